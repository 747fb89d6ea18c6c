"""Corrections of speed, place and turn, read from classes of words in any order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import cast

from assistant.language.little_words import LittleWords
from assistant.language.pace import factor_of as factor_of
from assistant.language.pace import speed_of
from assistant.language.phrasebook import Phrasebook
from assistant.language.tags import (
    OPPOSITE,
    PACES,
    WAYS,
    Tag,
    degree,
    flipped,
    rounded,
    tags_of,
)
from assistant.language.tags import degree_of as degree_of
from assistant.model.teacher_acts import (
    MoveDirection,
    Rotate,
    TeacherAct,
    Translate,
    TurnDirection,
)


@dataclass(frozen=True, slots=True)
class Reading:
    """Acts read from a clause and how many of its words stayed unexplained."""

    acts: tuple[TeacherAct, ...]
    unexplained: int
    empty: int = 0


def read_motion(
    words: Sequence[str], book: Phrasebook, names: frozenset[str] = frozenset()
) -> Reading | None:
    """Return what a clause asks to change in the motion; None if nothing of the kind."""
    tags = tags_of(words, book, names)
    kinds = [tag.kind for tag in tags]
    unexplained = kinds.count("other")
    empty = kinds.count("empty")
    if not _said_motion(kinds) and not any(kind in PACES for kind in kinds):
        unexplained += empty
    if any(kind in PACES or kind == "speed" for kind in kinds):
        paced = speed_of(tags, words, book.little)
        rest = [tag for tag in tags if tag.kind in WAYS]
        if paced is None:
            return None
        noun = "speed" in kinds
        odd = sum(t.kind not in _UPDOWN or not noun for t in rest)
        return Reading((paced,), unexplained + odd, empty)
    ways = [at for at, kind in enumerate(kinds) if kind in WAYS]
    if not ways:
        return None
    groups = _groups(tags, ways, book.little["joints"])
    acts: list[TeacherAct] = []
    turning = any(kind in ("turn", "tilt") for kind in kinds)
    for group in groups:
        act = _displacement(group, book.little, turning=turning)
        if act is None:
            return None
        acts.append(act)
    if not turning:
        unexplained += sum(tag.quantity is not None and tag.quantity.kind == "" for tag in tags)
    bare = len(tags) > 1 and not _said_motion(kinds) and "skip" in kinds
    if bare and _odd(kinds) and len(groups) > 1:
        return None
    return Reading(tuple(acts), unexplained + (1 if bare and _odd(kinds) else 0), empty)


_UPDOWN = frozenset(("up", "down", "up-er", "down-er", "high", "low", "lower", "raise"))
_SAYING = frozenset(
    ["turn", "tilt", "move", "quantity", "little", "much", "more", "less", "too", "not", "enough"]
)


def _said_motion(kinds: Sequence[str]) -> bool:
    return any(kind in _SAYING or kind in ("up-er", "down-er", "raise", "lower") for kind in kinds)


def _odd(kinds: Sequence[str]) -> bool:
    """Tell whether words beside a bare direction make it doubtful ("it is right there")."""
    return kinds.count("skip") > 2


def _groups(
    tags: tuple[Tag, ...], ways: Sequence[int], joining: frozenset[str]
) -> list[tuple[Tag, ...]]:
    """Cut a clause with several directions into one stretch a direction."""
    distinct = [
        at for n, at in enumerate(ways) if n == 0 or _way(tags, at) != _way(tags, ways[n - 1])
    ]
    if len(distinct) == 1:
        return [tags]
    cuts = [0]
    for before, after in pairwise(distinct):
        joints = [at for at in range(before + 1, after) if tags[at].words[0] in joining]
        cuts.append(joints[0] if joints else before + 1)
    return [tags[a:b] for a, b in zip(cuts, [*cuts[1:], len(tags)], strict=True)]


def _way(tags: Sequence[Tag], at: int) -> str:
    return WAYS[tags[at].kind]


def _displacement(tags: Sequence[Tag], little: LittleWords, *, turning: bool) -> TeacherAct | None:
    way = next((WAYS[tag.kind] for tag in tags if tag.kind in WAYS), None)
    if way is None:
        return None
    if flipped(tags):
        way = OPPOSITE[way]
    quantity = next((tag.quantity for tag in tags if tag.quantity), None)
    kind = quantity.kind if quantity else ""
    turning = (turning and kind != "m") or kind == "deg" or way.endswith("clockwise")
    value = abs(quantity.value) if quantity and kind in ("m", "deg") else None
    if quantity and kind == "" and turning:
        value = abs(quantity.value)
    told = None if value is not None else degree(tags, little)
    if turning:
        angle = None if value is None else rounded(value)
        return Rotate(cast("TurnDirection", way), told, angle)
    distance = None if value is None else rounded(value)
    return Translate(cast("MoveDirection", way), told, distance)
