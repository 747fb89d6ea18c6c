"""Places told by another thing, or as nearer to the robot: "ten centimetres left of the plate".

What is to the left, in front or behind is so for the teacher: "in front of" a thing is the side
on which the teacher stands.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from assistant.language.actions import mentioned_objects
from assistant.language.hints import hints, mentions, phrase_pattern
from assistant.language.phrasebook import phrasebook
from assistant.model.task import TaskObject

Side = Literal["left", "right", "front", "behind", "beside", "closer", "farther"]
Posture = Literal["is", "put", ""]


@dataclass(frozen=True, slots=True)
class Relation:
    """Where a thing is, seen from another one or from the robot.

    Parameters
    ----------
    thing : str
        Empty where only the other one is named.
    side : str
        Of the other thing; ``closer`` to the robot, or ``farther`` from it, than before.
    other : str
        Empty where the robot is meant.
    distance_mm : float or None
    posture : {"is", "put", ""}
        Whether the thing is told to be there, or to be put there.
    """

    thing: str
    side: Side
    other: str
    distance_mm: float | None
    posture: Posture


def relation(text: str, things: Sequence[TaskObject], language: str = "english") -> Relation | None:
    """Return the relation a text tells; None if it tells none that is plain."""
    lowered = " ".join(text.lower().split())
    posture = _posture(lowered, language)
    if _asks(lowered, posture, language) or mentions(lowered, hints("relation_stops", language)):
        return None
    # "It" is whatever was spoken of, not a thing's name.
    lowered = _without(lowered, hints("pronouns", language))
    found = _side(lowered, hints("relations", language))
    if found is None:
        return None
    side, begin, end = found
    before = mentioned_objects(lowered[:begin], things, language)
    behind = mentioned_objects(lowered[end:], things, language)
    robot = side in ("closer", "farther")
    if len(before) > 1 or len(behind) != (0 if robot else 1) or (behind and behind == before):
        return None
    thing, other = before[0] if before else "", "" if robot else behind[0]
    distance_mm = _distance_mm(lowered, language)
    return Relation(thing, side, other, distance_mm, posture)


def _asks(text: str, posture: Posture, language: str) -> bool:
    """Whether a text asks where something is, rather than to put it there."""
    first_word = (text.split() or [""])[0]
    asks = first_word in hints("question_words", language)
    return asks or (text.endswith("?") and posture != "put")


def _without(text: str, phrases: Sequence[str]) -> str:
    for phrase in phrases:
        text = phrase_pattern(phrase).sub(" ", text)
    return text


def _side(text: str, sides: Mapping[Side, Sequence[str]]) -> tuple[Side, int, int] | None:
    """Return the first relation a text names and where that stands; of two the longer."""
    hits = [
        (hit.start(), -len(phrase), side, hit.end())
        for side, phrases in sides.items()
        for phrase in phrases
        if (hit := phrase_pattern(phrase).search(text))
    ]
    if not hits:
        return None
    start, _, side, end = min(hits, key=lambda one: one[:2])
    return side, start, end


def _distance_mm(text: str, language: str) -> float | None:
    """Return the one length a text tells, in mm; None if none, or several."""
    numbers = phrasebook(language).numbers
    words = re.findall(r"[^\W\d_]+|\d+(?:[.,]\d+)?", text)
    lengths: dict[int, float] = {}
    for at in range(len(words)):
        quantity = numbers.quantity(words, at)
        if quantity is not None and quantity.kind == "m":
            lengths.setdefault(quantity.end, 1000.0 * quantity.value)
    return next(iter(lengths.values())) if len(lengths) == 1 else None


def _posture(text: str, language: str) -> Posture:
    if mentions(text, hints("putting", language)):
        return "put"
    return "is" if mentions(text, hints("standing", language)) else ""
