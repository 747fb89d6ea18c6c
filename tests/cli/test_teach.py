"""Whole lessons through the program's own front doors."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from assistant.files.tasks import read_task
from tests.session.lessons import ANSWERS, COUNTS, NAMES

TEACH = [sys.executable, "-m", "assistant", "teach", "--arm", "kinematic"]


def environment(home: Path) -> dict[str, str]:
    return {**os.environ, "ASSISTANT_HOME": str(home), "OPENBLAS_NUM_THREADS": "1"}


class Program:
    """A teacher that is a program: reads robot lines, answers with JSON or words."""

    def __init__(self, home: Path, *more: str) -> None:
        self.process = subprocess.Popen(
            [*TEACH, "--json", *more],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=environment(home),
        )
        self.told: list[dict[str, Any]] = []

    def turn(self) -> dict[str, Any]:
        """Return the last question of the robot's turn; ``moving`` tells how it ended."""
        asked: dict[str, Any] = {"asked": None, "about": None}
        for line in self.lines():
            self.told.append(line)
            if "ready" in line:
                return {**asked, "moving": line["moving"]}
            asked = line if line["asked"] else asked
        return {"left": True}

    def lines(self) -> Iterator[dict[str, Any]]:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            yield json.loads(line)

    def say(self, line: str | dict[str, Any]) -> None:
        assert self.process.stdin is not None
        text = line if isinstance(line, str) else json.dumps(line)
        self.process.stdin.write(f"{text}\n")
        self.process.stdin.flush()

    def end(self) -> int:
        assert self.process.stdin is not None
        assert self.process.stderr is not None
        self.process.stdin.close()
        assert self.process.stdout is not None
        self.process.stdout.read()
        errors = self.process.stderr.read()
        assert "Traceback" not in errors
        self.process.stdout.close()
        self.process.stderr.close()
        return self.process.wait(timeout=60)


def reply(turn: dict[str, Any]) -> str | dict[str, Any]:
    if turn["moving"]:
        return {"wait": "rest"}
    asked = turn["asked"]
    index = tuple(turn["about"]["index"]) if turn["about"] else ()
    if asked == "subtask_name":
        return NAMES[index]
    if asked == "subtask_count":
        return COUNTS.get(index, "none")
    return ANSWERS[asked]


def test_a_program_teaches_a_whole_lesson(tmp_path: Path) -> None:
    program = Program(tmp_path, "--setup", "demonstration")
    fresh = iter(["table1_1", "table1_2"])
    turn = program.turn()
    while not any(line.get("topic") == "saved" for line in program.told):
        last = program.told[-2]
        if last.get("topic") == "watching":
            program.say({"demonstrate": {"hand": "scripted", "seed": 2, "cues": "auto"}})
        elif last.get("topic") == "ready_normal" and (name := next(fresh, "")):
            program.say({"setup": name})
            program.turn()
            program.say("go")
        else:
            program.say(reply(turn))
        turn = program.turn()
    assert program.end() == 0
    (kept,) = (tmp_path / "tasks").glob("*.yaml")
    learned = read_task(kept).learned
    assert learned is not None
    assert [one.kind for one in learned.stations] == ["grasp", "release"]
    done = [line for line in program.told if line.get("topic") == "run"]
    assert len(done) == 2


def run(home: Path, *more: str, lines: str = "") -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*TEACH, *more],
        input=lines,
        capture_output=True,
        text=True,
        env=environment(home),
        timeout=60,
        check=False,
    )


def test_resuming_goes_on_where_the_input_ended(tmp_path: Path) -> None:
    first = run(tmp_path, lines="pick and place\nthe block rests on the target\n")
    assert first.returncode == 0
    assert "--resume 1" in first.stderr
    again = run(tmp_path, "--resume", "--json", lines="the block and the target\n")
    told = [json.loads(line) for line in again.stdout.splitlines()]
    assert told[0]["topic"] == "resumed"
    assert told[1]["asked"] == "objects"
    assert any(line.get("asked") == "subtask_count" for line in told)


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (["--resume"], "no session yet"),
        (["--resume", "77"], "no such session"),
        (["--setup", "nowhere"], "no setup 'nowhere'"),
        (["--task", "missing.yaml"], "missing.yaml"),
        (["--language", "fr"], "invalid choice"),
    ],
)
def test_what_cannot_be_opened_is_told_in_a_line(
    tmp_path: Path, more: list[str], message: str
) -> None:
    ended = run(tmp_path, *more)
    assert ended.returncode == 2
    assert message in ended.stderr
    assert "Traceback" not in ended.stderr


def test_a_journal_whose_files_are_gone_is_bad_input(tmp_path: Path) -> None:
    run(tmp_path, lines="pick and place\n")
    (tmp_path / "sessions" / "1" / "scene_1.yaml").unlink()
    ended = run(tmp_path, "--resume")
    assert ended.returncode == 2
    assert "scene_1.yaml" in ended.stderr
    assert "Traceback" not in ended.stderr


def test_a_newest_session_that_is_unreadable_is_passed_over_and_told(tmp_path: Path) -> None:
    run(tmp_path, lines="pick and place\n")
    broken = tmp_path / "sessions" / "2"
    broken.mkdir()
    (broken / "journal.yaml").write_text("", "utf-8")
    again = run(tmp_path, "--resume", "--json")
    told = [json.loads(line) for line in again.stdout.splitlines()]
    assert "resumed" in [one.get("topic") for one in told]
    older = next(one for one in told if one.get("topic") == "resumed_older")
    assert older["text"].startswith("This is session 1.")


def test_a_home_that_cannot_be_written_is_told_and_the_talk_goes_on(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("not a folder")
    ended = run(tmp_path / "file", lines="pick and place\nquit\nno\n")
    assert ended.returncode == 0
    assert "Goodbye" in ended.stdout
    first, second = ended.stdout.splitlines()[:2]
    assert "cannot write this session down" in first
    assert "Hello" in second


@pytest.mark.parametrize("more", [[], ["--json"]])
def test_an_input_that_was_closed_before_is_one_that_ends(tmp_path: Path, more: list[str]) -> None:
    command = ["sh", "-c", 'exec "$0" "$@" <&-', *TEACH, *more]
    ended = subprocess.run(
        command, capture_output=True, text=True, env=environment(tmp_path), timeout=60, check=False
    )
    assert ended.returncode == 0
    assert "Goodbye" in ended.stdout
    assert "Traceback" not in ended.stderr


@pytest.mark.parametrize("coding", ["utf-8:strict", "ascii:strict"])
def test_bytes_that_are_no_text_are_words_nobody_understands(tmp_path: Path, coding: str) -> None:
    ended = subprocess.run(
        TEACH,
        input=b"pick and place\n\xff\xfe\x80\nquit\nno\n",
        capture_output=True,
        env=environment(tmp_path) | {"PYTHONIOENCODING": coding},
        timeout=60,
        check=False,
    )
    assert ended.returncode == 0
    assert ended.stdout.endswith(b"Goodbye.\n")
    assert b"Traceback" not in ended.stderr


@pytest.mark.parametrize(
    ("more", "told"),
    [
        (("--json",), "does not go with --json"),
        ((), "the kinematic arm has none"),
        (("--arm", "pybullet"), "there is no display"),
    ],
)
def test_a_window_that_cannot_be_is_refused(
    tmp_path: Path, more: tuple[str, ...], told: str
) -> None:
    bare = environment(tmp_path)
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        bare.pop(name, None)
    refused = subprocess.run(
        [*TEACH, "--window", *more], capture_output=True, text=True, env=bare, check=False
    )
    assert refused.returncode == 2
    assert told in refused.stderr
    assert "--window" in refused.stderr
    assert not (tmp_path / "sessions" / "2").exists()
