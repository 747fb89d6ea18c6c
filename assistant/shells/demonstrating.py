"""What ``assistant demo`` shows: the dialogue as it goes and the table beside the paper's."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rich.table import Table
from rich.text import Text

PAPER_MM_DEG = ((0.0, 0.1), (0.5, 0.0), (1.0, 0.0), (1.0, 0.0))
"""Alignment errors in the paper's four setups. Source: paper, Table I."""


def dialogue_writer(write: Callable[[object], None]) -> Callable[[str, str], None]:
    """Return a listener that writes a play line by line."""

    def listen(who: str, words: str) -> None:
        name = "you" if who == "teacher" else who
        write(Text.assemble((f"{name:>5}: ", "bold" if who == "teacher" else "magenta"), words))

    return listen


def alignment_table(rows: Sequence[tuple[str, str, float | None, float | None]]) -> Table:
    """Return the alignment measured in each setup beside the paper's.

    Parameters
    ----------
    rows : sequence of (name, status, distance in mm, angle in deg)
        In the order of Table I; no numbers where the block was not placed.
    """
    table = Table(title="Alignment of block and target", title_justify="left")
    for title in ("setup", "run", "here: mm", "deg", "paper: mm", "deg"):
        table.add_column(title, justify="left" if title in ("setup", "run") else "right")
    for (name, status, mm, deg), (paper_mm, paper_deg) in zip(rows, PAPER_MM_DEG, strict=False):
        here = (_told(mm, 3), _told(deg, 3))
        table.add_row(name, status, *here, f"{paper_mm:.1f}", f"{paper_deg:.1f}")
    return table


def _told(number: float | None, digits: int) -> str:
    return "-" if number is None else f"{number:.{digits}f}"
