"""The command finds its verbs, never shows a traceback, and ends with a status to trust."""

from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path

import pytest

from assistant.cli import VERBS, main
from assistant.errors import BadInput, Problem, WorkFailed

HEAVY = ("pybullet", "filterpy", "scipy", "numpy", "prompt_toolkit", "rich", "matplotlib")


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
        (KeyboardInterrupt(), 130, "interrupted"),
        (ZeroDivisionError("division by zero"), 1, "a fault of the program: ZeroDivisionError"),
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
    assert kept.exists() == isinstance(fault, ZeroDivisionError)
