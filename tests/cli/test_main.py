"""The command finds its verbs, never shows a traceback, and ends with a status to trust."""

from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path

import pytest

from assistant.cli import main
from assistant.cli.running import VERBS
from assistant.errors import BadInput, Problem, WorkFailed
from assistant.files.shipped import shipped

HEAVY = ("pybullet", "filterpy", "scipy", "numpy", "prompt_toolkit", "rich", "matplotlib")


class Panic(BaseException):
    """What a library written in Rust raises when it gives up: no Exception."""


@pytest.mark.parametrize("verb", VERBS)
def test_every_verb_has_help_with_an_example(verb: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main([verb, "--help"])
    assert left.value.code == 0
    told = capsys.readouterr().out
    assert "example:" in told
    assert f"assistant {verb}" in told


def test_overview_lists_every_verb(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["--help"])
    assert left.value.code == 0
    told = capsys.readouterr().out
    assert all(f"  {verb} " in told for verb in VERBS)


def test_overview_imports_nothing_heavy() -> None:
    code = (
        "import sys, assistant.cli\n"
        "try: assistant.cli.main(['--help'])\n"
        "except SystemExit: pass\n"
        f"print([name for name in {HEAVY} if name in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr.strip() == "[]"


def test_until_the_verb_begins_hardly_anything_is_imported() -> None:
    # Ctrl-C while something is imported before `main` shows Python's own traceback.
    code = (
        "import sys\n"
        "before = set(sys.modules)\n"
        "from assistant.cli import main\n"
        "print(sorted(set(sys.modules) - before))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "['__future__', 'assistant', 'assistant.cli']"


def test_ctrl_c_while_a_verb_is_being_found_is_told_in_a_word(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(_: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr("assistant.cli.running.run_verb", interrupted)
    assert main(["tasks"]) == 130
    assert capsys.readouterr().err == "interrupted\n"


def test_the_version_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["--version"])
    assert left.value.code == 0
    assert capsys.readouterr().out.startswith("assistant 0.")


@pytest.mark.parametrize(
    "words",
    [
        ["show", "NAME"],
        ["check", "NAME"],
        ["convert", "NAME", "out.json"],
        ["convert", str(shipped("tasks") / "pick_and_place.yaml"), "NAME.json"],
        ["adapt", "NAME", "--setup", "NAME"],
        ["replay", "NAME"],
        ["understand", "left", "--task", "NAME"],
    ],
)
def test_a_name_too_long_for_a_file_is_bad_input(
    words: list[str], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    long = str(tmp_path / ("ä" * 200))
    assert main([word.replace("NAME", long) for word in words]) == 2
    err = capsys.readouterr().err
    assert long in err
    assert "File name too long" in err
    assert "fault" not in err


def test_an_unknown_verb_ends_with_2(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fly"]) == 2
    assert "unknown verb 'fly'; one of teach, demo" in capsys.readouterr().err


def test_a_wrong_flag_ends_with_2(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["check", "--colour"])
    assert left.value.code == 2
    assert "see assistant check --help" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("fault", "status", "told"),
    [
        (
            BadInput([Problem("a:1", "wrong", "right"), Problem("a:2", "worse", "")]),
            2,
            "a:1: wrong; right\na:2: worse\n",
        ),
        (WorkFailed("refused"), 1, "refused"),
        (
            PermissionError(13, "Permission denied", "in/a"),
            2,
            "in/a: cannot be used (Permission denied); name a file or folder that you may use\n",
        ),
        (KeyboardInterrupt(), 130, "interrupted"),
        (ZeroDivisionError("division by zero"), 1, "a fault of the program: ZeroDivisionError"),
        (Panic("no clock"), 1, "a fault of the program: Panic: no clock"),
    ],
)
def test_errors_become_one_message_and_a_status(
    fault: BaseException,
    status: int,
    told: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
) -> None:
    def run(_: object) -> int:
        raise fault

    monkeypatch.setenv("ASSISTANT_HOME", str(tmp_path))
    monkeypatch.setattr(importlib.import_module("assistant.cli.check"), "run", run)
    assert main(["check", "a"]) == status
    err = capsys.readouterr().err
    assert told in err
    assert "Traceback" not in err
    kept = tmp_path / "faults.log"
    assert kept.exists() == isinstance(fault, ZeroDivisionError | Panic)
