"""Small pictures made of characters: a course of numbers over time in a few rows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from rich.console import Console, ConsoleOptions, RenderResult
from rich.text import Text

from assistant.geometry import Array

BLOCKS = " ▁▂▃▄▅▆▇█"
COLUMNS, FEWEST_COLUMNS = 60, 12
PLAIN_BLOCKS = " .:-=+*#@"


@dataclass(frozen=True, slots=True)
class Picture:
    """A picture drawn with the characters the terminal has, no wider than it is.

    Parameters
    ----------
    draw : callable
        Takes the characters for bars of growing height and how many columns there are.
    """

    draw: Callable[[str, int], str]

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        columns = max(min(COLUMNS, options.max_width), FEWEST_COLUMNS)
        blocks = PLAIN_BLOCKS if options.ascii_only else BLOCKS
        yield Text(self.draw(blocks, columns), no_wrap=True)


def sampled(t_s: Array, values: Array, columns: int) -> Array:
    """Return the greatest value within each of `columns` equal spans of time, shape (columns,)."""
    edges = np.linspace(t_s[0], t_s[-1], columns + 1)
    middles = np.interp((edges[:-1] + edges[1:]) / 2, t_s, values)
    at = np.clip(np.searchsorted(edges, t_s, side="right") - 1, 0, columns - 1)
    np.maximum.at(middles, at, values)
    return np.asarray(middles)


def bars(values: Array, rows: int = 4, *, blocks: str = BLOCKS) -> tuple[str, ...]:
    """Return lines of text, top first, that show numbers as bars from 0 to the greatest."""
    top = float(np.max(values, initial=0.0)) or 1.0
    steps = len(blocks) - 1
    heights = np.round(np.clip(values, 0.0, None) / top * rows * steps).astype(int)
    return tuple(
        "".join(blocks[int(np.clip(height - row * steps, 0, steps))] for height in heights)
        for row in reversed(range(rows))
    )


def marks(at_s: Sequence[float], t_s: Array, columns: int, mark: str) -> str:
    """Return a line with a mark under the column of each instant."""
    span = float(t_s[-1] - t_s[0]) or 1.0
    line = [" "] * columns
    for at in at_s:
        column = int((at - t_s[0]) / span * columns)
        line[min(max(column, 0), columns - 1)] = mark
    return "".join(line).rstrip()


def axis(t_s: Array, columns: int, decimal: str = ".") -> str:
    """Return a line that tells the first and last instant below a picture."""
    first, last = (f"{at:.1f}".replace(".", decimal) for at in (t_s[0], t_s[-1]))
    last = f"{last} s"
    return f"{first}{last.rjust(max(columns - len(first), 1))}"


def speed(t_s: Array, path: Array) -> Array:
    """Return the hand's speed in m/s at each sample, shape (n,); repeated times are bridged."""
    kept = np.concatenate([[True], np.diff(t_s) > 0])
    if np.count_nonzero(kept) < 2:
        return np.zeros(len(t_s))
    velocity = np.gradient(path[kept, :3], t_s[kept], axis=0)
    return np.asarray(np.interp(t_s, t_s[kept], np.linalg.norm(velocity, axis=1)))
