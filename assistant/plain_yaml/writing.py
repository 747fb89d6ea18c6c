"""Writes plain values as YAML a person likes to read: the same values give the same text.

What fits on a line is written on one line, ``{hand: close, object: block}``; what does not is
spread over lines, two spaces deeper. A list of numbers always stays on its line.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from assistant.plain_yaml.scalars import scalar_text

WIDTH = 100


def write(
    value: Mapping[str, Any], *, spread: Collection[str] = (), rows: Collection[str] = ()
) -> str:
    """Return the YAML text of a mapping.

    Parameters
    ----------
    value : mapping of text to plain values
    spread : names of keys
        Whose values go over several lines even if they would fit on one.
    rows : names of keys
        Whose lists have each item on a line of its own, however long.
    """
    if rows:
        value = _with_rows(value, frozenset(rows))
    if not value:
        return "{}\n"
    return "".join(f"{line}\n" for line in _mapping(value, 0, frozenset(spread)))


def write_item(value: Any, *, spread: Collection[str] = ()) -> str:
    """Return the text of one item of a list at the margin, ``- ...``, to be appended."""
    return "".join(f"{line}\n" for line in _sequence([value], 0, frozenset(spread)))


def tidy(number: float) -> float | int:
    """Return whole numbers as integers, so that 300.0 is written as 300."""
    if not math.isfinite(number) or abs(number) >= 1e15 or number != int(number):
        return number
    return number if number == 0 and math.copysign(1.0, number) < 0 else int(number)


@dataclass(frozen=True, slots=True)
class _Row:
    """A value that stays on its line."""

    value: Any


def _with_rows(value: Any, keys: frozenset[str]) -> Any:
    if not isinstance(value, Mapping):
        return value
    return {
        key: [_Row(item) for item in part]
        if key in keys and _is_list(part)
        else _with_rows(part, keys)
        for key, part in value.items()
    }


def _flow(value: Any) -> str:
    if isinstance(value, Mapping):
        inside = (f"{_word(key)}: {_flow(part)}" for key, part in value.items())
        return "{" + ", ".join(inside) + "}"
    if _is_list(value):
        return "[" + ", ".join(_flow(part) for part in value) + "]"
    return _word(value)


def _word(value: Any) -> str:
    return scalar_text(value, in_flow=True)


def _is_list(value: Any) -> bool:
    return isinstance(value, Sequence) and not isinstance(value, str)


def _is_row(value: Any) -> bool:
    return _is_list(value) and all(isinstance(part, int | float) for part in value)


def _mapping(value: Mapping[str, Any], indent: int, spread: frozenset[str]) -> Iterator[str]:
    pad = " " * indent
    for key, part in value.items():
        head = f"{pad}{_word(key)}:"
        line = _on_one_line(head, part, spread=key in spread, inside=spread)
        if line is not None:
            yield line
        elif isinstance(part, Mapping):
            yield head
            yield from _mapping(part, indent + 2, spread)
        else:
            yield head
            yield from _sequence(part, indent + 2, spread)


def _sequence(value: Sequence[Any], indent: int, spread: frozenset[str]) -> Iterator[str]:
    pad = " " * indent
    for part in value:
        if isinstance(part, _Row):
            yield f"{pad}- {_flow(part.value)}"
            continue
        single = isinstance(part, Mapping) and len(part) == 1
        line = None if single else _on_one_line(f"{pad}-", part, spread=False, inside=spread)
        if line is not None:
            yield line
        else:
            inner = _mapping if isinstance(part, Mapping) else _sequence
            first, *rest = inner(part, indent + 2, spread)
            yield f"{pad}- {first.lstrip()}"
            yield from rest


def _on_one_line(head: str, value: Any, *, spread: bool, inside: frozenset[str]) -> str | None:
    if not isinstance(value, Mapping) and not _is_list(value):
        return f"{head} {scalar_text(value, in_flow=False)}"
    if _is_row(value) or not value:
        return f"{head} {_flow(value)}"
    if spread or _holds(value, inside):
        return None
    line = f"{head} {_flow(value)}"
    return line if len(line) <= WIDTH else None


def _holds(value: Any, keys: frozenset[str]) -> bool:
    """Whether one of the keys that are spread stands somewhere inside."""
    if isinstance(value, Mapping):
        return any(key in keys or _holds(part, keys) for key, part in value.items())
    return _is_list(value) and any(_holds(part, keys) for part in value)
