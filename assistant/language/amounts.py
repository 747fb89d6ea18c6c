"""More, less or a share of the last correction, where no direction is named.

Read from classes of words in any order: "rather more than I intended" is less of it, "half as
much again" one and a half of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from assistant.language.numbers import Quantity
from assistant.language.phrasebook import Phrasebook
from assistant.language.tags import tags_of
from assistant.model.teacher_acts import AdjustLast, Degree

_PLAIN = frozenset(("skip", "empty", "little", "much", "more", "less"))
LONGEST = 18
MOST_UNEXPLAINED = 1


@dataclass(frozen=True, slots=True)
class AmountReading:
    """A change of the last correction and how many words stayed unexplained."""

    act: AdjustLast
    unexplained: int


@dataclass(frozen=True, slots=True)
class _Found:
    kinds: tuple[str, ...]
    quantities: tuple[Quantity, ...]
    degrees: tuple[Degree, ...]
    unexplained: int


def read_amount(words: Sequence[str], book: Phrasebook) -> AmountReading | None:
    """Return what a clause asks of the last correction; None if it asks something else."""
    if not book.amounts or len(words) > LONGEST:
        return None
    found = _found(words, book)
    if found is None or found.unexplained > MOST_UNEXPLAINED:
        return None
    if "opposite" in found.kinds:
        return AmountReading(AdjustLast(change="opposite"), found.unexplained)
    if len(found.quantities) == 1 and (factor := _factor(found)) is not None:
        return AmountReading(AdjustLast(factor=factor), found.unexplained)
    change = _change(found.kinds)
    if change is None or found.quantities:
        return None
    degree = found.degrees[-1] if found.degrees else None
    return AmountReading(AdjustLast(change=change, degree=degree), found.unexplained)


def _found(words: Sequence[str], book: Phrasebook) -> _Found | None:
    """Return the classes that occur; None where a direction, a turn or a pace does."""
    kinds: list[str] = []
    quantities: list[Quantity] = []
    degrees: list[Degree] = []
    at = unexplained = 0
    while at < len(words):
        begun = book.amounts.get(words[at], ())
        told = next((one for one in begun if tuple(words[at : at + len(one[0])]) == one[0]), None)
        if told is not None:
            kinds.append(told[1])
            at += len(told[0])
            continue
        tag = tags_of(words[at : at + _LOOK], book, frozenset())[0]
        if tag.quantity is not None and tag.quantity.kind in ("ratio", ""):
            quantities.append(tag.quantity)
        elif tag.kind not in _PLAIN and tag.kind != "other":
            return None
        if tag.kind == "little":
            degrees.append("little")
        elif tag.kind == "much":
            degrees.append("much")
        elif tag.kind in ("more", "less"):
            kinds.append(tag.kind)
        unexplained += tag.kind == "other"
        at += len(tag.words)
    return _Found(tuple(kinds), tuple(quantities), tuple(degrees), unexplained)


_LOOK = 6


def _change(kinds: Sequence[str]) -> Literal["more", "less"] | None:
    """Return what a complaint or a wish comes to; complaints tell more than words beside them."""
    if "excess" in kinds:
        return "less"
    if "lack" in kinds:
        return "more"
    wishes = {kind for kind in kinds if kind in ("more", "less")}
    about = "last" in kinds or len(kinds) == 1
    if len(wishes) != 1 or not about:
        return None
    return "more" if "more" in wishes else "less"


def _factor(found: _Found) -> float | None:
    """Return the share of the last correction that is told."""
    (quantity,) = found.quantities
    share = quantity.kind == "ratio" or quantity.value < 1
    if "again" in found.kinds:
        return _rounded(1 + quantity.value) if share else None
    if share and "less" in found.kinds:
        return _rounded(1 - quantity.value)
    if share and "more" in found.kinds:
        return _rounded(1 + quantity.value)
    told = {"last", "times"} & set(found.kinds)
    return _rounded(quantity.value) if told and quantity.value > 0 else None


def _rounded(value: float) -> float:
    return float(f"{value:.9g}")
