"""The standard streams: closed, full, left by their reader, or short of letters."""

from __future__ import annotations

import io
import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from assistant.cli import main, streams

ASSISTANT = [sys.executable, "-m", "assistant"]


def environment(home: Path, **more: str) -> dict[str, str]:
    """Return surroundings in which output is held back, as it is by default."""
    bare = {name: value for name, value in os.environ.items() if name != "PYTHONUNBUFFERED"}
    return {**bare, "ASSISTANT_HOME": str(home), **more}


@pytest.mark.parametrize("words", [["tasks"], ["--help"]])
def test_a_reader_that_has_left_is_no_fault(words: list[str], tmp_path: Path) -> None:
    read, write = os.pipe()
    os.close(read)
    ended = subprocess.run(
        [*ASSISTANT, *words],
        stdout=write,
        stderr=subprocess.PIPE,
        env=environment(tmp_path),
        check=False,
    )
    os.close(write)
    assert (ended.returncode, ended.stderr) == (0, b"")


def test_a_full_disk_is_told_in_a_line(tmp_path: Path) -> None:
    with (tmp_path / "out").open("wb") as full:
        ended = subprocess.run(
            [*ASSISTANT, "tasks"],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            env=environment(tmp_path),
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0)),
            check=False,
        )
    assert ended.returncode == 1
    told = "assistant tasks: the output cannot be written (File too large)"
    assert ended.stderr == f"{told}; make room where it goes\n"


def test_closed_streams_lead_nowhere(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("stdin", "stdout", "stderr"):
        monkeypatch.setattr(sys, name, None)
    assert main(["check"]) == 2
    made = (sys.stdin, sys.stdout, sys.stderr)
    assert made[0].read() == ""
    for stream in made:
        stream.close()


@pytest.mark.parametrize("errors", ["strict", "surrogateescape"])
def test_letters_the_output_lacks_are_written_as_numbers(
    errors: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    # A plain locale ("C") has the second.
    written = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written, "ascii", errors))
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"gr\xf6\xdfer"), "utf-8"))
    streams.prepare()
    sys.stdout.write(f"größer \ud800 {sys.stdin.read()}\n")
    streams.flush()
    assert written.getvalue() == b"gr\\xf6\\xdfer \\ud800 gr\\ufffd\\ufffder\n"
    sys.stdout.close()
