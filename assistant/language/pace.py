"""Corrections of the pace: "half as fast", "speed is too high", "don't go so slow"."""

from __future__ import annotations

from collections.abc import Sequence

from assistant.language.numbers import Quantity
from assistant.language.phrasebook import Phrasebook
from assistant.language.tags import JOINTS, OPPOSITE, PACES, Tag, degree, flipped, rounded, tags_of
from assistant.model.teacher_acts import AdjustSpeed

_ADJECTIVES = frozenset((("slow",), ("quick",), ("fast",)))

_TIMES = frozenset(("times", "as", "twice", "double", "triple", "thrice", "fold", "x", "speed"))
_RATIOS = ("ratio", "")


def factor_of(words: Sequence[str], book: Phrasebook) -> float | None:
    """Return the factor of the present speed that words tell, wherever it stands."""
    tags = tags_of(words, book, frozenset())
    quantity = next((t.quantity for t in tags if t.quantity and t.quantity.kind in _RATIOS), None)
    if quantity is None:
        return None
    pace = next((PACES[tag.kind] for tag in tags if tag.kind in PACES), None)
    return _factor(quantity, pace or _pace_of_noun([tag.kind for tag in tags]), words)


def speed_of(tags: Sequence[Tag], words: Sequence[str]) -> AdjustSpeed | None:
    """Return the change of pace that the words of a clause tell."""
    kinds = [tag.kind for tag in tags]
    pace = _told_pace(tags)
    told = pace is not None
    if pace is None:
        pace, less = _pace_of_noun(kinds), "less" in kinds
        tags = tuple(tag for tag in tags if tag.kind != "less") if less else tags
    quantity = next((tag.quantity for tag in tags if tag.quantity), None)
    if quantity is not None and quantity.kind == "" and quantity.value >= 1:
        quantity = quantity if _TIMES & set(words) else None
    if quantity is not None and quantity.kind in ("ratio", ""):
        return AdjustSpeed(factor=_factor(quantity, pace, words))
    if pace is None:
        return AdjustSpeed(factor=1.0) if "normal" in kinds else None
    if not told and flipped(tags):
        pace = OPPOSITE[pace]
    change = "faster" if pace == "faster" else "slower"
    return AdjustSpeed(change="faster" if change == "faster" else "slower", degree=degree(tags))


def _told_pace(tags: Sequence[Tag]) -> str | None:
    """Return the pace that words tell, each by itself: "faster, too slow" is twice faster.

    "Too", "not", "less" and a complaining "so" just before a word turn it round.
    """
    told: list[tuple[bool, str]] = []
    for at, tag in enumerate(tags):
        if tag.kind not in PACES:
            continue
        before = _since_pace(tags[:at])
        near = before[-2:] if "not" not in before else before
        plain = tag.kind in ("fast", "slow") or tag.words in _ADJECTIVES
        turned = bool({"too", "not", "less"} & set(near)) and "enough" not in [t.kind for t in tags]
        turned = turned or (plain and at > 0 and tags[at - 1].words == ("so",))
        pace = PACES[tag.kind]
        complained = turned or tag.kind in ("fast", "slow")
        told.append((complained, OPPOSITE[pace] if turned else pace))
    # What is asked for outright counts before what is complained of.
    return min(told, key=lambda one: one[0])[1] if told else None


def _since_pace(tags: Sequence[Tag]) -> list[str]:
    """Return the kinds of the words before, back to another pace or a joining word."""
    found: list[str] = []
    for tag in reversed(tags):
        if tag.kind in PACES or tag.words[0] in JOINTS:
            break
        found.insert(0, tag.kind)
    return found[-_NEAR:]


_NEAR = 7


def _pace_of_noun(kinds: Sequence[str]) -> str | None:
    """Read "more speed", "speed is too high", "speed down"."""
    if "too" in kinds and {"much", "little"} & set(kinds):
        return "faster" if "much" in kinds else "slower"
    for kind in kinds:
        if kind in ("high", "up", "up-er", "raise", "more"):
            return "faster"
        if kind in ("low", "down", "down-er", "lower", "less"):
            return "slower"
    return None


def _factor(quantity: Quantity, pace: str | None, words: Sequence[str]) -> float:
    value = quantity.value
    aimed = quantity.kind == "ratio" and not {"to", "auf"}.isdisjoint(words)
    absolute = pace is None or "as" in words or aimed
    if "speed" in words and quantity.kind == "" and value < 1 and "by" not in words:
        absolute = True
    if absolute:
        slower = pace == "slower" and "as" in words and value > 1
        return rounded(1 / value if slower else value)
    if quantity.kind == "ratio" or value < 1:
        return rounded(1 + value if pace == "faster" else 1 - value)
    return rounded(value if pace == "faster" else 1 / value)
