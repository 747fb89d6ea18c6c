"""Input that ends while the task is being shown: nothing shown is lost, and resuming goes on."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from assistant.files.demonstrations import read_demonstration
from tests.cli.test_teach import run
from tests.cli.test_terminal import TALK, Teacher

INTRODUCTION = [text for text, _ in TALK[:-1]]


def resumed(home: Path, *lines: str) -> list[dict[str, str]]:
    ended = run(home, "--resume", "--json", lines="".join(f"{line}\n" for line in lines))
    assert ended.returncode == 0, ended.stderr
    return [json.loads(line) for line in ended.stdout.splitlines()]


def samples(home: Path) -> int:
    path = home / "sessions" / "1" / "recording_1.csv"
    return len(path.read_text("utf-8").splitlines()) - 1


@pytest.mark.parametrize(
    ("more", "shown"),
    [(("--json",), json.dumps({"demonstrate": {"hand": "scripted"}})), ((), "scripted hand")],
)
def test_input_that_ends_with_the_demonstration(
    tmp_path: Path, more: tuple[str, ...], shown: str
) -> None:
    # The last line is the demonstration, and nobody is there when it is over.
    talk = "".join(f"{line}\n" for line in (*INTRODUCTION, shown))
    ended = run(tmp_path, *more, lines=talk)
    assert ended.returncode == 0
    assert "Traceback" not in ended.stderr
    told = resumed(tmp_path, "yes")
    assert told[0]["topic"] == "resumed"
    assert told[1]["stage"] == "learning"
    kept = read_demonstration(tmp_path / "sessions" / "1" / "demonstration_1.yaml")
    assert len(kept.recording.t_s) == samples(tmp_path)


def test_input_that_ends_while_the_robot_watches(tmp_path: Path) -> None:
    ended = run(tmp_path, "--json", lines="".join(f"{line}\n" for line in INTRODUCTION))
    assert ended.returncode == 0
    told = resumed(tmp_path, json.dumps({"demonstrate": {"hand": "scripted"}}))
    assert told[0]["topic"] == "resumed_recording"
    assert any(line.get("stage") == "learning" for line in told)


def test_a_window_that_closes_while_the_hand_is_driven(tmp_path: Path) -> None:
    teacher = Teacher(tmp_path)
    teacher.terminal.expect("What is the task called")
    for text, then in TALK:
        teacher.say(text, then)
    for _ in range(20):
        teacher.press("w")
    assert samples(tmp_path) > 5
    teacher.terminal.close(force=False)
    teacher.terminal.wait()
    shown = samples(tmp_path)
    told = resumed(tmp_path, "finished")
    assert told[0]["topic"] == "resumed_recording"
    kept = read_demonstration(tmp_path / "sessions" / "1" / "demonstration_1.yaml")
    assert len(kept.recording.t_s) == shown
