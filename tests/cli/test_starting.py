"""What is printed to go on with can be typed as it stands."""

from __future__ import annotations

import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from assistant.cli.starting import as_started


def program(folder: Path, name: str = "assistant") -> Path:
    folder.mkdir()
    path = folder / name
    path.write_text('#!/bin/sh\necho "$0 $* in $ASSISTANT_HOME"\n')
    path.chmod(0o755)
    return path


@pytest.mark.parametrize("found", [True, False])
@pytest.mark.parametrize("kept", ["", "a home of mine"])
def test_the_command_runs_the_same_program_with_the_same_home(
    found: bool, kept: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = program(tmp_path / "bin here")
    other = program(tmp_path / "other")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PATH", f"{(here if found else other).parent}:/usr/bin:/bin")
    monkeypatch.setenv("ASSISTANT_HOME", kept)
    monkeypatch.setattr(sys, "argv", ["bin here/assistant"])
    command = as_started("teach", "--resume", "3")
    assert command.endswith("assistant teach --resume 3") == found
    monkeypatch.delenv("ASSISTANT_HOME")
    said = subprocess.run(["/bin/sh", "-c", command], capture_output=True, text=True, check=True)
    home = tmp_path / kept if kept else ""
    assert said.stdout == f"{here} teach --resume 3 in {home}\n"


def test_a_module_is_started_as_a_module(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["/somewhere/assistant/__main__.py"])
    monkeypatch.delenv("ASSISTANT_HOME", raising=False)
    words = shlex.split(as_started("teach"))
    assert words[1:] == ["-m", "assistant", "teach"]
    assert Path(words[0]).name == Path(sys.executable).name
