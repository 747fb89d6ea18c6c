"""The command line.

A verb is a module of this package with ``arguments(parser)`` and ``run(args) -> int``; heavy
imports stay inside ``run``. This module imports next to nothing: until `main` runs, Ctrl-C
shows Python's own traceback.
"""

from __future__ import annotations

import sys

TYPE_CHECKING = False
if TYPE_CHECKING:  # known to type checkers by its name; importing `typing` takes longer
    from collections.abc import Sequence

DONE, FAILED, BAD_INPUT = 0, 1, 2
INTERRUPTED = 130


def main(argv: Sequence[str] | None = None) -> int:
    """Run one verb and return its exit status."""
    try:
        from assistant.cli.running import run_verb

        return run_verb(sys.argv[1:] if argv is None else argv)
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return INTERRUPTED
