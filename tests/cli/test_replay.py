from __future__ import annotations

import json
from pathlib import Path

import pytest

from assistant.cli import main
from assistant.files.transcripts import read_transcript

PLAY = """\
format: transcript/1
title: a short play
arm: kinematic
steps:
- robot: {act: greet}
- robot: {asked: task_name}
- teacher: pick and place
- robot: {asked: ASKED}
"""


def played(tmp_path: Path, text: str, *more: str) -> tuple[int, Path]:
    path = tmp_path / "play.yaml"
    path.write_text(text)
    return main(["replay", str(path), *more]), path


def test_a_play_that_goes_as_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, path = played(tmp_path, PLAY.replace("ASKED", "goal"), "--json")
    assert status == 0
    (told,) = json.loads(capsys.readouterr().out)["transcripts"]
    assert told["file"] == str(path)
    assert (told["passed"], told["line"], told["why"]) == (True, None, "")
    assert not (tmp_path / "play.actual.yaml").exists()


def test_a_play_that_differs_is_told_and_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status, path = played(tmp_path, PLAY.replace("ASKED", "objects"))
    assert status == 1
    assert f"{path}:8: expected asked 'objects', got 'goal'" in capsys.readouterr().err
    actual = read_transcript(tmp_path / "play.actual.yaml")
    assert [getattr(step, "asked", None) for step in actual.steps][-2] == "goal"


def test_what_really_happened_passes_as_a_play(tmp_path: Path) -> None:
    played(tmp_path, PLAY.replace("ASKED", "objects"))
    assert main(["replay", str(tmp_path / "play.actual.yaml")]) == 0


@pytest.mark.parametrize("text", ["", "format: transcript/9\n", "steps: [dance]\n"])
def test_a_bad_play_is_bad_input(tmp_path: Path, text: str) -> None:
    assert played(tmp_path, text)[0] == 2


def test_a_step_that_cannot_be_done_is_a_difference(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = PLAY.replace("ASKED", "goal") + "- setup: nowhere\n"
    assert played(tmp_path, text)[0] == 1
    assert "no setup 'nowhere'" in capsys.readouterr().err


def test_of_a_folder_all_transcripts_are_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "more").mkdir()
    for name in ("b.yaml", "more/a.yaml", "b.actual.yaml"):
        (tmp_path / name).write_text(PLAY.replace("ASKED", "goal"))
    (tmp_path / "setup.yaml").write_text("format: setup/1\n")
    assert main(["replay", str(tmp_path), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)["transcripts"]
    assert [Path(one["file"]).name for one in told] == ["b.yaml", "a.yaml"]


def test_a_folder_without_transcripts_is_bad_input(tmp_path: Path) -> None:
    assert main(["replay", str(tmp_path)]) == 2


@pytest.mark.parametrize(
    ("step", "told"),
    [
        ("expect: {stage: introduction, nothing.here: 1}", "nothing.here: expected 1, got None"),
        ("expect: {stage: {near: 1, within: 2}}", "stage: expected 1.0 within 2.0, got 'intro"),
        ("setup: nowhere", "there is no setup 'nowhere'"),
        ("demonstrate: {hand: scripted}", "the robot is not watching"),
    ],
)
def test_what_really_happened_holds_what_was_really_found(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], step: str, told: str
) -> None:
    status, path = played(tmp_path, PLAY.replace("ASKED", "goal") + f"- {step}\n")
    assert status == 1
    assert f"{path}:9: " in (err := capsys.readouterr().err)
    assert told in err
    assert main(["replay", str(tmp_path / "play.actual.yaml")]) == 0


def test_a_difference_is_told_where_it_cannot_be_written_down(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "play.actual.yaml").mkdir()
    status, _ = played(tmp_path, PLAY.replace("ASKED", "objects"), "--json")
    assert status == 1
    (told,) = json.loads(capsys.readouterr().out)["transcripts"]
    assert told["line"] == 8
    assert "what really happened is not kept" in told["why"]


def test_all_that_is_wrong_is_told_before_the_first_is_played(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    names = ("good.yaml", "head.yaml", "torn.yaml")
    good, head, torn = (tmp_path / name for name in names)
    good.write_text(PLAY.replace("ASKED", "goal"))
    head.write_text("format: transcript/1\ntitle: t\nsetup: moon\ntask: no.yaml\nsteps: []\n")
    torn.write_text(PLAY[:-3])
    assert main(["replay", str(tmp_path), str(tmp_path / "none.yaml")]) == 2
    told = capsys.readouterr()
    assert told.out == ""
    where = [line.split(": ")[0] for line in told.err.splitlines()]
    assert where == [f"{head}:4", f"{head}:3", f"{torn}:9", f"{tmp_path}/none.yaml"]
