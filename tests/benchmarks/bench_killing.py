"""Kill a whole lesson at every step of its journal, resume it, and compare what was learned.

Run by name: ``python -m tests.benchmarks.bench_killing [EVERY] [--real N]``; EVERY is 1 by
default. A kill leaves nothing but the disk as it is at that instant, so the disk is copied at
every step of one lesson, with the step that was being written torn in four ways, and each copy
is resumed and held to its end. N of the kills (6 by default) are done once more by SIGKILL on a
process of its own; their disks must be resumed to the same outcome.
"""

from __future__ import annotations

import argparse
import os
import shutil
import tempfile
import time
from pathlib import Path
from typing import Any

from assistant.files import transcripts
from assistant.files.transcripts import read_transcript
from assistant.model.transcript import Step
from assistant.session import journal as journal_module
from tests.session.lessons import hold, opened
from tests.session.test_killing import in_a_process_of_its_own, kill_at_step, outcome, resumed

TORN = (0.0, 0.3, 0.7, 1.0)


def copied_at_every_step(home: Path, copies: Path) -> tuple[dict[str, Any], int]:
    """Hold a lesson, and copy its disk before and after every step that is written.

    Returns what was learned and how many steps there are; the first step has number 1.
    """
    append, count = transcripts.append_step, 0

    def append_and_copy(path: Path, step: Step) -> None:
        nonlocal count
        count += 1
        # Files beside the journal are written before the step that names them.
        shutil.copytree(home, copies / str(count) / "before")
        append(path, step)
        shutil.copytree(home, copies / str(count) / "after")

    vars(journal_module)["append_step"] = append_and_copy
    try:
        session = opened(home)
        hold(session)
        session.close()
    finally:
        vars(journal_module)["append_step"] = append
    return outcome(session), count


def killed(copies: Path, number: int, torn: float, home: Path) -> None:
    """Lay a disk out as a kill leaves it that came while a step was being written."""
    before, after = copies / str(number) / "before", copies / str(number) / "after"
    shutil.copytree(after, home)
    journal = Path("sessions/1/journal.yaml")
    had, has = (os.path.getsize(folder / journal) for folder in (before, after))
    os.truncate(home / journal, had + round(torn * (has - had)))


def taken_up(home: Path) -> dict[str, Any]:
    """Resume a lesson, hold it to its end, and return what was learned."""
    session = resumed(home)
    hold(session)
    session.close()
    return outcome(session)


def torn_alike(copies: Path, number: int) -> bool:
    """Whether a torn step leaves the same conversation wherever it was torn."""
    read = []
    for torn in TORN[:-1]:
        with tempfile.TemporaryDirectory() as folder:
            home = Path(folder) / "home"
            killed(copies, number, torn, home)
            read.append(read_transcript(home / "sessions/1/journal.yaml", resume=True).steps)
    return all(steps == read[0] for steps in read)


def swept(copies: Path, steps: range, expected: dict[str, Any]) -> tuple[int, int]:
    """Return how many lessons ended the same, and how many torn steps were alike."""
    same = alike = 0
    for number in steps:
        alike += torn_alike(copies, number)
        with tempfile.TemporaryDirectory() as folder:
            home = Path(folder) / "home"
            killed(copies, number, TORN[number % len(TORN)], home)
            ended = taken_up(home) == expected
        if not ended:
            print(f"step {number}, torn {TORN[number % len(TORN)]}: another outcome")
        same += ended
    return same, alike


def really(count: int, kills: int, expected: dict[str, Any]) -> int:
    """Kill processes of their own at steps evenly over the lesson; return how many end alike."""
    same = 0
    for kill in range(1, kills + 1):
        step, torn = kill * count // (kills + 1), TORN[kill % len(TORN)]
        with tempfile.TemporaryDirectory() as folder:
            home = Path(folder)
            in_a_process_of_its_own(home, lambda step=step, torn=torn: kill_at_step(step, torn))
            same += taken_up(home) == expected
    return same


def main() -> None:
    """Print how many kills lost nothing."""
    parser = argparse.ArgumentParser()
    parser.add_argument("every", nargs="?", type=int, default=1)
    parser.add_argument("--real", type=int, default=6)
    asked = parser.parse_args()
    begun_s = time.process_time()
    with tempfile.TemporaryDirectory() as folder:
        copies = Path(folder) / "copies"
        expected, count = copied_at_every_step(Path(folder) / "home", copies)
        steps = range(1, count + 1, asked.every)
        same, alike = swept(copies, steps, expected)
    print(f"killed at {len(steps)} of {count} steps: {same} lessons ended the same")
    print(f"torn in {len(TORN) - 1} ways each: {alike} of {len(steps)} steps left out whole")
    kept = really(count, asked.real, expected)
    print(f"killed by SIGKILL at {asked.real} steps: {kept} lessons ended the same")
    print(f"CPU time {time.process_time() - begun_s:.0f} s, processes that were killed not counted")


if __name__ == "__main__":
    main()
