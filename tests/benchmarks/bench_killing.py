"""Kill a whole lesson at every step of its journal, resume it, and compare what was learned.

Run by name: ``python -m tests.benchmarks.bench_killing [EVERY]``, EVERY 1 by default.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

from assistant.files.transcripts import read_transcript
from tests.session.lessons import hold, opened
from tests.session.test_killing import in_a_process_of_its_own, kill_at_step, outcome, resumed

TORN = (0.0, 0.3, 0.7, 1.0)


def whole(home: Path) -> tuple[object, int]:
    """Return the outcome of an uninterrupted lesson, and the steps of its journal."""
    session = opened(home)
    hold(session)
    session.close()
    return outcome(session), len(read_transcript(home / "sessions/1/journal.yaml").steps)


def main() -> None:
    """Print how many kills lost nothing."""
    every = int(sys.argv[1]) if len(sys.argv) > 1 else 1
    with tempfile.TemporaryDirectory() as folder:
        expected, count = whole(Path(folder))
    same, kills = 0, range(1, count, every)
    for kill in kills:
        with tempfile.TemporaryDirectory() as folder:
            home, torn = Path(folder), TORN[kill % len(TORN)]
            in_a_process_of_its_own(home, lambda kill=kill, torn=torn: kill_at_step(kill, torn))
            session = resumed(home)
            hold(session)
            session.close()
            same += outcome(session) == expected
    print(f"killed at {len(kills)} of {count} steps: {same} lessons ended the same")


if __name__ == "__main__":
    main()
