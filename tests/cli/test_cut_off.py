"""Input that ends while the task is being shown: nothing shown is lost, and resuming goes on."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from assistant.cli import main
from assistant.files.demonstrations import read_demonstration
from tests.cli.at_a_terminal import TALK, Teacher, introduced

INTRODUCTION = [text for text, _ in TALK[:-1]]


Taught = Callable[..., str]
"""Holds a session with lines of input that end, and returns what was told."""


@pytest.fixture
def teach(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Taught:
    monkeypatch.setenv("ASSISTANT_HOME", str(tmp_path))

    def taught(*more: str, lines: Iterable[str]) -> str:
        text = "".join(f"{line}\n" for line in lines)
        monkeypatch.setattr("sys.stdin", io.StringIO(text))
        assert main(["teach", "--arm", "kinematic", *more]) == 0
        told = capsys.readouterr()
        assert "Traceback" not in told.err
        return told.out

    return taught


def resumed(teach: Taught, *lines: str) -> list[dict[str, str]]:
    told = teach("--resume", "--json", lines=lines)
    return [json.loads(line) for line in told.splitlines()]


def samples(home: Path) -> int:
    path = home / "sessions" / "1" / "recording_1.csv"
    return len(path.read_text("utf-8").splitlines()) - 1


@pytest.mark.parametrize(
    ("more", "shown"),
    [(("--json",), json.dumps({"demonstrate": {"hand": "scripted"}})), ((), "scripted hand")],
)
def test_input_that_ends_with_the_demonstration(
    tmp_path: Path, teach: Taught, more: tuple[str, ...], shown: str
) -> None:
    # The last line is the demonstration, and nobody is there when it is over.
    teach(*more, lines=(*INTRODUCTION, shown))
    told = resumed(teach, "yes")
    assert told[0]["topic"] == "resumed"
    assert told[1]["stage"] == "learning"
    kept = read_demonstration(tmp_path / "sessions" / "1" / "demonstration_1.yaml")
    assert len(kept.recording.t_s) == samples(tmp_path)


def test_input_that_ends_while_the_robot_watches(teach: Taught) -> None:
    teach("--json", lines=INTRODUCTION)
    told = resumed(teach, json.dumps({"demonstrate": {"hand": "scripted"}}))
    assert told[0]["topic"] == "resumed_recording"
    assert any(line.get("stage") == "learning" for line in told)


def test_a_window_that_closes_while_the_hand_is_driven(tmp_path: Path, teach: Taught) -> None:
    introduced(tmp_path)
    teacher = Teacher(tmp_path, "--resume")
    teacher.take_the_hand()
    teacher.press("w")
    # What is shown is recorded from the first key on, which opens the file.
    teacher.sample()
    teacher.until(lambda: samples(tmp_path) > 5)
    teacher.terminal.close(force=False)
    teacher.terminal.wait()
    shown = samples(tmp_path)
    told = resumed(teach, "finished")
    assert told[0]["topic"] == "resumed_recording"
    kept = read_demonstration(tmp_path / "sessions" / "1" / "demonstration_1.yaml")
    assert len(kept.recording.t_s) == shown
