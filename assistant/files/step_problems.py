"""What no form of a step can see: patterns that are none, and values that are near nothing.

The raw document is walked, so that these are told together with whatever else is wrong.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

from assistant.errors import Problem
from assistant.plain_yaml import Document

NEAR = frozenset(("near", "within"))
Place = tuple[str | int, ...]


def step_problems(document: Document) -> list[Problem]:
    """Return the problems of a transcript's steps; parts of a wrong shape are passed over."""
    told = document.value if isinstance(document.value, dict) else {}
    steps = told.get("steps")
    found: list[Problem] = []
    for number, step in enumerate(steps if isinstance(steps, list) else []):
        for key, value in step.items() if isinstance(step, dict) else ():
            place: Place = ("steps", number, key)
            if key.startswith("robot"):
                found += _of_line(value, document, place)
            elif key == "expect":
                found += _near_nothing(value, document, place)
    return found


def pattern_in(words: str) -> str | None:
    """Return the regular expression of ``/pattern/``, or None for plain words."""
    is_pattern = len(words) > 2 and words.startswith("/") and words.endswith("/")
    return words[1:-1] if is_pattern else None


def _of_line(value: Any, document: Document, place: Place) -> Iterator[Problem]:
    if isinstance(value, dict):
        yield from _near_nothing(value.get("slots"), document, (*place, "slots"))
        value = value.get("words")
    pattern = pattern_in(value) if isinstance(value, str) else None
    if pattern is None:
        return
    try:
        re.compile(pattern)
    except (re.error, RecursionError, OverflowError) as error:
        what = f"bad /pattern/: {error}"
        yield Problem(document.where(list(place)), what, "a regular expression")


def _near_nothing(value: Any, document: Document, place: Place) -> Iterator[Problem]:
    """Complain wherever a value is expected near something that is no number."""
    if isinstance(value, dict) and set(value) == NEAR:
        good = _is_number(value["near"]) and _is_number(value["within"]) and value["within"] >= 0
        if not good:
            where = document.where(list(place))
            yield Problem(where, "this is near nothing", "{near: number, within: number from 0 on}")
        return
    if isinstance(value, list):
        value = dict(enumerate(value))
    for key, part in value.items() if isinstance(value, dict) else ():
        yield from _near_nothing(part, document, (*place, key))


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
