"""Lines broken between words to the width of the terminal, and their colors."""

from __future__ import annotations

import os
import shutil
import textwrap

NARROWEST = 20
"""A terminal that tells no sensible width is taken to have so many columns."""


def columns() -> int:
    """Return how many columns the terminal has."""
    return max(shutil.get_terminal_size().columns, NARROWEST)


def wrapped(text: str, width: int, *, before: str = "") -> tuple[str, ...]:
    """Return lines of at most `width` characters, broken between words.

    Parameters
    ----------
    text : str
        Its own line breaks and the indent after them stay, as in a tree.
    width : int
    before : str
        What the first line begins with; the others hang below what follows it.
    """
    indent = " " * len(before)
    lines: list[str] = []
    for given in text.split("\n"):
        own = " " * (len(given) - len(given.lstrip()))
        first = before if not lines else indent
        lines += textwrap.wrap(
            given.strip(),
            max(width - 1, NARROWEST),
            initial_indent=first + own,
            subsequent_indent=indent + own,
            break_on_hyphens=False,
        ) or [first]
    return tuple(lines)


def styled(text: str, style: str) -> str:
    """Return text in a color, unless colors are not wanted."""
    if not style or os.environ.get("NO_COLOR"):
        return text
    return f"\x1b[{style}m{text}\x1b[0m"
