"""The command by which this program was started, to be typed as it is printed."""

from __future__ import annotations

import os
import shlex
import shutil
import sys
from pathlib import Path

from assistant.files.home import VARIABLE


def as_started(*arguments: str) -> str:
    """Return a command line for other arguments that works where this one did.

    A program that is not found by its name is told by its path, and ``ASSISTANT_HOME`` is told
    where it was set.
    """
    started = Path(sys.argv[0])
    if started.name == "__main__.py":
        words = [_found(Path(sys.executable)), "-m", "assistant"]
    else:
        words = [_found(started)]
    told = os.environ.get(VARIABLE, "")
    kept = [f"{VARIABLE}={shlex.quote(os.path.abspath(Path(told).expanduser()))}"] if told else []
    return " ".join([*kept, *map(shlex.quote, (*words, *arguments))])


def _found(program: Path) -> str:
    """Return the name of a program if that leads to it, else its path."""
    found = shutil.which(program.name)
    same = found is not None and os.path.abspath(found) == os.path.abspath(program)
    return program.name if same else os.path.abspath(program)
