from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from assistant.cli import main
from assistant.files.demonstrations import write_demonstration
from assistant.files.library import library
from assistant.files.setups import write_setups
from assistant.files.tasks import read_task, write_task
from assistant.model.demonstration import Recording
from assistant.model.setup import Setup
from tests.learning.lessons import BLOCK, CUTS_S, TARGET, demonstration, moved, task


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_task(task(), tmp_path / "tree.yaml")
    write_demonstration(demonstration(), tmp_path / "shown.yaml")
    rng = np.random.default_rng(0)
    setups = [Setup("as shown", places={"block": BLOCK, "target": TARGET}), moved(rng, "moved")]
    write_setups(setups, tmp_path / "setups.yaml")
    return tmp_path


def told(capsys: pytest.CaptureFixture[str]) -> list[dict[str, object]]:
    return [json.loads(line) for line in capsys.readouterr().out.splitlines()]


def test_what_is_odd_in_a_recording_is_told_and_learned_from_all_the_same(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shown = demonstration()
    path = np.array(shown.recording.path)
    path[100, :3] += 1.0
    recording = Recording(shown.recording.t_s, path, shown.recording.gripper_m)
    write_demonstration(replace(shown, recording=recording), folder / "jump.yaml")
    words = ["learn", str(folder / "jump.yaml"), "--task", str(folder / "tree.yaml"), "--json"]
    assert main(words) == 0
    printed = capsys.readouterr()
    assert "warning:" in printed.err
    assert "the hand jumps" in printed.err
    assert json.loads(printed.out)["episodes"]


def test_learn_tells_and_writes_what_adapt_reads(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    learned = folder / "learned.yaml"
    shown = str(folder / "shown.yaml")
    words = ["learn", shown, "--task", str(folder / "tree.yaml"), "-o", str(learned), "--json"]
    assert main(words) == 0
    (line,) = told(capsys)
    cuts = line["segmentation_points_s"]
    assert isinstance(cuts, list)
    # The hand draws back once it has opened, at 14 s: no cue tells of it, so it is no step.
    assert np.allclose(cuts, CUTS_S, atol=0.1)
    questions = line["questions"]
    assert isinstance(questions, list)
    assert [one["asked"] for one in questions if one["about"] == ""] == []
    docking = line["docking"]
    assert isinstance(docking, list)
    assert [one["kind"] for one in docking] == ["grasp", "release"]
    assert read_task(learned).learned is not None
    csv = folder / "path.csv"
    words = ["adapt", str(learned), "--setup", str(folder / "setups.yaml"), "--json"]
    assert main([*words, "--csv", str(csv)]) == 0
    lines = told(capsys)
    assert [one["name"] for one in lines] == ["as shown", "moved"]
    for one in lines:
        errors = [value for name, value in one.items() if "error" in name]
        assert len(errors) == 4
        assert max(float(str(value)) for value in errors) <= 1e-9
        assert float(str(one["jerk_ratio"])) <= 1.15
        assert float(str(one["peak_speed_ratio"])) <= 1.0
        assert float(str(one["duration_ratio"])) <= 1.2
    assert (folder / "path_1.csv").exists()
    assert main(["adapt", str(learned), "--setup", str(folder / "setups.yaml")]) == 0
    assert "as shown: grasp off by" in capsys.readouterr().out


def test_several_are_one_line_each_or_one_together(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_demonstration(demonstration(0.0005, 1), folder / "again.yaml")
    words = ["learn", str(folder / "shown.yaml"), str(folder / "again.yaml")]
    words += ["--task", str(folder / "tree.yaml"), "--json"]
    assert main(words) == 0
    assert len(told(capsys)) == 2
    assert main([*words, "--together"]) == 0
    assert len(told(capsys)) == 1
    assert main([*words, "-o", str(folder / "out.yaml")]) == 2
    assert "--together" in capsys.readouterr().err


def test_without_a_gripper_docking_is_absent_and_asked_about(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_demonstration(demonstration(gripper=False), folder / "blind.yaml")
    words = ["learn", str(folder / "blind.yaml"), "--task", str(folder / "tree.yaml"), "--json"]
    assert main(words) == 0
    (line,) = told(capsys)
    assert line["docking"] is None
    questions = line["questions"]
    assert isinstance(questions, list)
    assert any("hand" in one["text"] for one in questions)
    assert line["segmentation_points_s"]


def test_what_was_cut_without_a_gripper_is_written_and_tells_why_it_is_not_carried_out(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_demonstration(demonstration(gripper=False), folder / "blind.yaml")
    learned, setups = str(folder / "learned.yaml"), str(folder / "setups.yaml")
    words = ["learn", str(folder / "blind.yaml"), "--task", str(folder / "tree.yaml")]
    assert main([*words, "-o", learned, "--json"]) == 0
    (line,) = told(capsys)
    lesson = read_task(Path(learned)).learned
    assert lesson is not None
    assert lesson.path is None
    assert np.allclose(lesson.segmentation.cuts_s, np.array(line["segmentation_points_s"]))
    assert main(["check", learned]) == 0
    for verb in (
        ["adapt", learned, "--setup", setups],
        ["practice", learned, "--setup", setups, "--dry-run"],
        ["evaluate", learned, "--setups", "1", "--seed", "0"],
    ):
        assert main(verb) == 1
        assert "gripper_m" in capsys.readouterr().err


def test_a_hand_that_never_closes_ends_with_1(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shown = demonstration()
    opened = Recording(shown.recording.t_s, shown.recording.path, np.full(801, 0.08))
    write_demonstration(replace(shown, recording=opened), folder / "open.yaml")
    words = ["learn", str(folder / "open.yaml"), str(folder / "shown.yaml")]
    assert main([*words, "--task", str(folder / "tree.yaml"), "--json"]) == 1
    out = capsys.readouterr()
    assert "never closes" in out.err
    assert len(out.out.splitlines()) == 2


def test_figures_are_drawn(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    drawn = folder / "figures"
    words = ["learn", str(folder / "shown.yaml"), "--task", str(folder / "tree.yaml")]
    assert main([*words, "--figures", str(drawn)]) == 0
    assert "learned in" in capsys.readouterr().out
    for name in ("votes.png", "paths.png", "weights.png"):
        assert (drawn / name).read_bytes().startswith(b"\x89PNG")


def test_what_was_not_learned_cannot_be_adapted(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tree, setups = str(folder / "tree.yaml"), str(folder / "setups.yaml")
    told = f"{tree}:1: nothing has been learned for this task yet; show it first: assistant learn"
    for verb in (
        ["adapt", tree, "--setup", setups],
        ["practice", tree, "--setup", setups, "--dry-run"],
        ["evaluate", tree, "--setups", "1", "--seed", "0"],
    ):
        assert main(verb) == 2
        assert capsys.readouterr().err == f"{told}\n"


def test_a_missing_file_and_a_missing_place_end_with_2(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["learn", str(folder / "no.yaml"), "--task", str(folder / "tree.yaml")]) == 2
    shown = str(folder / "shown.yaml")
    learned = str(folder / "learned.yaml")
    assert main(["learn", shown, "--task", str(folder / "tree.yaml"), "-o", learned]) == 0
    bare, moon = folder / "bare.yaml", folder / "moon.yaml"
    write_setups([Setup("good", places={"block": BLOCK, "target": TARGET})], bare)
    bare.write_text(f"{bare.read_text()}---\nformat: setup/1\nname: bare\nplaces: {{}}\n")
    lines = len(bare.read_text().splitlines())
    write_setups([Setup("far", "moon"), Setup("farther", "mars")], moon)
    capsys.readouterr()
    for verb in (["adapt"], ["practice", "--dry-run"]):
        assert main([*verb, learned, "--setup", str(bare)]) == 2
        err = capsys.readouterr().err
        assert err.startswith(f"{bare}:{lines}: bare: no place for ")
        assert "block" in err
        assert "target" in err
        assert main([*verb, learned, "--setup", str(moon), str(folder / "none.yaml")]) == 2
        told = capsys.readouterr().err.splitlines()
        assert told[0].startswith(f"{moon}:3: there is no scene 'moon'; known: ")
        assert told[1].startswith(f"{moon}:9: there is no scene 'mars'; known: ")
        assert told[-1].startswith(f"{folder}/none.yaml: no such file")


def test_a_recording_alone_is_a_demonstration_without_words(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bare = replace(demonstration(), cues=(), key_states=(), setup=Setup())
    write_demonstration(bare, folder / "bare.yaml")
    told_of = []
    for name in ("bare.yaml", "bare.csv"):
        words = ["learn", str(folder / name), "--task", str(folder / "tree.yaml"), "--json"]
        assert main(words) == 0
        (line,) = told(capsys)
        told_of.append(line["segmentation_points_s"])
    assert told_of[0] == told_of[1]


def test_whatever_can_be_converted_can_be_learned_from_and_written(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ASSISTANT_HOME", str(folder / "home"))
    kept = library().save("my task", task())
    cuts = []
    for number, shown in enumerate(("shown.csv", "shown.npz", "columns.json", "shown.json")):
        if not (folder / shown).exists():
            first = "shown.yaml" if shown == "shown.json" else "shown.csv"
            assert main(["convert", str(folder / first), str(folder / shown)]) == 0
        out = folder / f"learned_{number}.json"
        words = ["learn", str(folder / shown), "--task", "My task", "-o", str(out), "--json"]
        assert main(words) == 0
        (line,) = told(capsys)
        cuts.append(line["segmentation_points_s"])
        assert json.loads(out.read_text())["learned"]
        assert replace(read_task(out), learned=None) == read_task(kept)
    assert cuts == [cuts[0]] * 4


def test_what_is_wrong_with_tree_and_demonstrations_is_told_at_once(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "bad.yaml").write_text("format: demonstration/1\nrecording: no.csv\ncue: []\n")
    (folder / "moon.yaml").write_text(
        "format: demonstration/1\nrecording: shown.csv\nsetup: {scene: moon}\n"
    )
    names = [str(folder / name) for name in ("bad.yaml", "moon.yaml", "none.yaml")]
    assert main(["learn", *names, "--task", str(folder / "setups.yaml")]) == 2
    told = [line.split(": ")[0] for line in capsys.readouterr().err.splitlines()]
    where = [folder / "setups.yaml", *[folder / "bad.yaml"] * 2, folder / "moon.yaml"]
    assert [one.split(":")[0] for one in told] == [*map(str, where), names[2]]
