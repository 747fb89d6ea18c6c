"""A document that was read: plain values, and beside them the line each stands on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

from assistant.errors import Problem

Value: TypeAlias = "str | int | float | bool | list[Value] | dict[str, Value] | None"
Lines: TypeAlias = "int | tuple[int, dict[str, Lines] | list[Lines]]"


@dataclass(frozen=True, slots=True)
class Document:
    """One YAML document.

    Parameters
    ----------
    value : plain values
    lines : line, or (line, lines of the parts)
        Counted from 1, in the shape of `value`.
    file : str
        Where it was read from, for messages.
    flaws : sequence of Problem
        Repeated keys and tags; only where the reader was told to go on in spite of them.
    """

    value: Value
    lines: Lines
    file: str
    flaws: tuple[Problem, ...] = ()

    def line(self, place: Sequence[str | int] = ()) -> int:
        """Return the line of the value at a place, or of the nearest part above it."""
        lines = self.lines
        for part in place:
            if isinstance(lines, int):
                break
            lines = _part(lines, part)
        return line_of(lines)

    def where(self, place: Sequence[str | int] = ()) -> str:
        """Return ``file:line`` of the value at a place."""
        return f"{self.file}:{self.line(place)}"


def line_of(lines: Lines) -> int:
    """Return the line something begins on."""
    return lines if isinstance(lines, int) else lines[0]


def _part(lines: tuple[int, dict[str, Lines] | list[Lines]], part: str | int) -> Lines:
    """Return the lines of a part, or what was given where there is no such part."""
    parts = lines[1]
    if isinstance(parts, dict):
        return parts.get(part, lines) if isinstance(part, str) else lines
    return parts[part] if isinstance(part, int) and part < len(parts) else lines
