"""`assistant evaluate`: success over random setups, kept when interrupted."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from assistant.cli import BAD_INPUT, DONE, main
from assistant.cli.evaluation import Evaluation, Finished, evaluated, summary, told
from assistant.errors import BadInput
from assistant.files.demonstrations import read_demonstration
from assistant.files.scenes import find_scene
from assistant.files.shipped import shipped
from assistant.files.tasks import read_task, write_task
from assistant.learning.lesson import learn


@pytest.fixture(scope="module")
def learned(tmp_path_factory: pytest.TempPathFactory) -> Path:

    shown = shipped("tasks") / "demonstrations" / "pick_and_place.yaml"
    task = read_task(shipped("tasks") / "pick_and_place.yaml")
    demonstration = read_demonstration(shown)
    scene = find_scene(demonstration.setup.scene, shown)
    path = tmp_path_factory.mktemp("learned") / "pick_and_place.yaml"
    write_task(replace(task, learned=learn([demonstration], task, scene=scene)), path)
    return path


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ASSISTANT_HOME", str(tmp_path / "home"))
    return tmp_path / "home"


def command(learned: Path, *more: str) -> list[str]:
    return ["evaluate", str(learned), "--seed", "1", "--arm", "kinematic", "--workers", "1", *more]


def test_it_tells_how_many_were_done(
    learned: Path, home: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(command(learned, "--setups", "2", "--json")) == DONE
    out, err = capsys.readouterr()
    answer = json.loads(out)
    assert [result["name"] for result in answer["setups"]] == ["random_1", "random_2"]
    assert answer["done"] + answer["missed"] + answer["refused"] == 2
    low, high = answer["success_interval_95"]
    assert 0.0 <= low < high <= 1.0
    assert "2 of 2" in err
    assert list((home / "evaluations").iterdir()) == []


def test_it_goes_on_where_it_was_interrupted(
    learned: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record = tmp_path / "record.jsonl"
    assert main(command(learned, "--setups", "1", "--resume", str(record))) == DONE
    with record.open("a", encoding="utf-8") as file:
        file.write('{"number": 2, "torn')
    capsys.readouterr()
    assert main(command(learned, "--setups", "2", "--resume", str(record))) == DONE
    out, err = capsys.readouterr()
    assert "1 of 2 were finished before" in err
    assert "random_1" not in err
    assert "of 2: " in out
    assert len(Finished.of(wanted(learned, 2), record).results) == 2


def wanted(learned: Path, setups: int) -> Evaluation:
    return Evaluation(str(learned), "table", setups, 1, "all", "kinematic")


def test_finished_setups_are_not_done_again(learned: Path, tmp_path: Path) -> None:
    finished = Finished.of(wanted(learned, 1), tmp_path / "record.jsonl")
    kept = {"number": 1, "name": "random_1", "status": "missed", "reason": "kept"}
    finished.add(kept)
    assert evaluated(wanted(learned, 1), finished, 1, lambda _: None) == [kept]


def test_the_record_of_something_else_is_refused(learned: Path, tmp_path: Path) -> None:
    record = tmp_path / "record.jsonl"
    record.write_text('{"format": "evaluation/1", "seed": 9}\n', encoding="utf-8")
    with pytest.raises(BadInput, match="something else"):
        Finished.of(wanted(learned, 1), record)


@pytest.mark.parametrize(
    "words",
    [
        ["--setups", "0"],
        ["--setups", "x"],
        ["--setups", "1", "--seed", "-1"],
        ["--setups", "1", "--noise", "1"],
        ["--setups", "1", "--noise", "99,1"],
    ],
)
def test_what_cannot_be_counted_is_refused(learned: Path, words: list[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(command(learned, *words))
    assert left.value.code == BAD_INPUT


def test_a_missing_task_and_a_tree_alone_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(command(tmp_path / "none.yaml", "--setups", "1")) == BAD_INPUT
    tree = shipped("tasks") / "pick_and_place.yaml"
    assert main(command(tree, "--setups", "1")) == BAD_INPUT
    assert "nothing has been learned" in capsys.readouterr().err


def test_a_scene_without_the_tasks_objects_is_refused(
    learned: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(command(learned, "--setups", "1", "--scene", "stacking_table")) == BAD_INPUT
    assert "has no block" in capsys.readouterr().err


def test_causes_of_failures_are_counted_without_their_numbers() -> None:
    def failed(by: str) -> dict[str, object]:
        reason = f"reach at grasp of block by {by} mm; put it closer"
        missing = {"distance_mm": None, "angle_deg": None}
        return {"number": 1, "name": "a", "status": "refused", "reason": reason, **missing}

    answer = told([failed("3.5"), failed("10")])
    assert answer["causes"] == {"refused: reach at grasp of block by # mm; put it closer": 2}
    assert "2 x refused: reach" in summary(answer)
    assert answer["refused"] == 2
