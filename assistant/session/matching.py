"""Comparing what a transcript expects with what happened: by meaning, never by screen.

A block of robot steps is matched like a regular expression against the lines the robot said
since the last action: ``robot`` one, ``robot?`` at most one, ``robot*`` any number, ``robot+``
at least one. Every line must be accounted for.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from assistant.model.robot_acts import About, RobotAct
from assistant.model.transcript import Near, RobotLine


@dataclass(frozen=True, slots=True)
class Said:
    """A line the robot said, with its sentence."""

    line: RobotAct
    text: str


@dataclass(frozen=True, slots=True)
class Difference:
    """Where a transcript and what happened part.

    Parameters
    ----------
    line : int
        Of the transcript.
    why : str
    """

    line: int
    why: str


def account(expected: Sequence[RobotLine], said: Sequence[Said], line: int) -> Difference | None:
    """Return None if the expected steps account for every line said, else where they do not.

    Parameters
    ----------
    expected : sequence of RobotLine
    said : sequence of Said
    line : int
        Of the step that comes after the block, told when the robot said too much.
    """
    # reached[k]: how many lines may be used up after k steps.
    reached = {0}
    for step in expected:
        after = _after(step, said, reached)
        if not after:
            return Difference(step.line, _why_not(step, said, max(reached)))
        reached = after
    if len(said) in reached:
        return None
    extra = said[max(reached)]
    return Difference(line, f"the robot said more: {told(extra)}")


def _after(step: RobotLine, said: Sequence[Said], reached: set[int]) -> set[int]:
    after = set(reached) if step.times in ("maybe", "any") else set()
    for start in reached:
        used = start
        while used < len(said) and not mismatch(step, said[used]):
            used += 1
            after.add(used)
            if step.times in ("one", "maybe"):
                break
    return after


def _why_not(step: RobotLine, said: Sequence[Said], at: int) -> str:
    if at >= len(said):
        return f"expected {wanted(step)}, but the robot said nothing more"
    return f"{mismatch(step, said[at]) or 'the lines do not fit'}; the robot said {told(said[at])}"


def mismatch(step: RobotLine, said: Said) -> str:
    """Return how a line differs from what a step expects, empty if it does not."""
    line = said.line
    for name in ("act", "asked", "topic"):
        expected, real = getattr(step, name), getattr(line, name)
        if expected is not None and expected != real:
            return f"expected {name} {expected!r}, got {real!r}"
    if step.about is not None and not _about(step.about, line.about):
        return f"expected it about {step.about!r}, got {line.about!r}"
    for name, value in step.slots.items():
        why = difference(value, line.slots.get(name))
        if why:
            return f"slot {name}: {why}"
    # A journal keeps the sentence beside its meaning: worded otherwise it still means the same.
    by_meaning = step.act is not None and step.topic is not None
    if step.words is not None and not by_meaning and step.words != said.text:
        return f"expected the words {step.words!r}"
    if step.pattern is not None and not re.search(step.pattern, said.text, re.IGNORECASE):
        return f"expected words like /{step.pattern}/"
    return ""


def _about(expected: About | str, real: About | None) -> bool:
    if real is None:
        return False
    return expected == (real.name if isinstance(expected, str) else real)


def difference(expected: Any, real: Any) -> str:
    """Return how a value differs from what was expected, empty if it does not.

    Numbers may be expected `Near`; of a mapping only the keys listed must agree.
    """
    if isinstance(expected, Near):
        if isinstance(real, int | float) and abs(real - expected.near) <= expected.within:
            return ""
        return f"expected {expected.near} within {expected.within}, got {real!r}"
    if isinstance(expected, Mapping) and isinstance(real, Mapping):
        told = (
            f"{key}: {difference(one, real.get(key))}"
            for key, one in expected.items()
            if difference(one, real.get(key))
        )
        return next(told, "")
    if isinstance(expected, list | tuple) and isinstance(real, list | tuple):
        if len(expected) != len(real):
            return f"expected {len(expected)} items, got {len(real)}: {list(real)!r}"
        pairs = zip(expected, real, strict=True)
        return next((why for one, other in pairs if (why := difference(one, other))), "")
    return "" if expected == real else f"expected {expected!r}, got {real!r}"


def look_up(view: Any, path: str) -> Any:
    """Return the value at a dotted path; positions in lists count from 1, -1 is the last.

    Returns None where there is nothing.
    """
    for part in path.split("."):
        if isinstance(view, Mapping):
            view = view.get(part)
        elif isinstance(view, list | tuple) and re.fullmatch(r"-?[1-9]\d*", part):
            position = int(part)
            inside = abs(position) <= len(view)
            view = view[position - 1 if position > 0 else position] if inside else None
        else:
            return None
    return view


def wanted(step: RobotLine) -> str:
    """Return what a step expects, for people."""
    parts = [
        f"{name} {getattr(step, name)!r}"
        for name in ("act", "topic", "asked", "about", "words", "pattern")
        if getattr(step, name) is not None
    ]
    return "a robot line" + (f" with {', '.join(parts)}" if parts else "")


def told(said: Said) -> str:
    """Return a line the robot said, for people."""
    asked = f" (asked {said.line.asked})" if said.line.asked else ""
    return f"[{said.line.act}.{said.line.topic}{asked}] {said.text!r}"
