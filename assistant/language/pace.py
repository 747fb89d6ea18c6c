"""Corrections of the pace: "half as fast", "speed is too high", "don't go so slow"."""

from __future__ import annotations

from collections.abc import Sequence

from assistant.language.little_words import LittleWords
from assistant.language.numbers import Quantity
from assistant.language.phrasebook import Phrasebook
from assistant.language.tags import OPPOSITE, PACES, Tag, degree, flipped, rounded, tags_of
from assistant.model.teacher_acts import AdjustSpeed

_RATIOS = ("ratio", "")


def factor_of(words: Sequence[str], book: Phrasebook) -> float | None:
    """Return the factor of the present speed that words tell, wherever it stands."""
    tags = tags_of(words, book, frozenset())
    quantity = next((t.quantity for t in tags if t.quantity and t.quantity.kind in _RATIOS), None)
    if quantity is None:
        return None
    pace = next((PACES[tag.kind] for tag in tags if tag.kind in PACES), None)
    return _factor(quantity, pace or _pace_of_noun([tag.kind for tag in tags]), words, book.little)


def speed_of(tags: Sequence[Tag], words: Sequence[str], little: LittleWords) -> AdjustSpeed | None:
    """Return the change of pace that the words of a clause tell."""
    kinds = [tag.kind for tag in tags]
    pace = _told_pace(tags, little)
    told = pace is not None
    if pace is None:
        pace, less = _pace_of_noun(kinds), "less" in kinds
        tags = tuple(tag for tag in tags if tag.kind != "less") if less else tags
    quantity = next((tag.quantity for tag in tags if tag.quantity), None)
    if quantity is not None and quantity.kind == "" and quantity.value >= 1:
        quantity = quantity if little["times"] & set(words) else None
    if quantity is not None and quantity.kind in ("ratio", ""):
        return AdjustSpeed(factor=_factor(quantity, pace, words, little))
    if pace is None:
        return AdjustSpeed(factor=1.0) if "normal" in kinds else None
    if not told and flipped(tags):
        pace = OPPOSITE[pace]
    change = "faster" if pace == "faster" else "slower"
    return AdjustSpeed(
        change="faster" if change == "faster" else "slower", degree=degree(tags, little)
    )


def _told_pace(tags: Sequence[Tag], little: LittleWords) -> str | None:
    """Return the pace that words tell, each by itself: "faster, too slow" is twice faster.

    "Too", "not", "less" and a complaining "so" just before a word turn it round.
    """
    told: list[tuple[bool, str]] = []
    for at, tag in enumerate(tags):
        if tag.kind not in PACES:
            continue
        before = _since_pace(tags[:at], little)
        near = before[-2:] if "not" not in before else before
        plain = tag.kind in ("fast", "slow") or (
            len(tag.words) == 1 and tag.words[0] in little["paces"]
        )
        turned = bool({"too", "not", "less"} & set(near)) and "enough" not in [t.kind for t in tags]
        counted = any(one.quantity for one in tags[:at])
        so = plain and at > 0 and set(tags[at - 1].words) <= little["so"]
        # "So fast" complains; "one and a half times so fast", as some languages say, does not.
        turned = turned or (so and not counted)
        pace = PACES[tag.kind]
        complained = turned or tag.kind in ("fast", "slow")
        told.append((complained, OPPOSITE[pace] if turned else pace))
    # What is asked for outright counts before what is complained of.
    return min(told, key=lambda one: one[0])[1] if told else None


def _since_pace(tags: Sequence[Tag], little: LittleWords) -> list[str]:
    """Return the kinds of the words before, back to another pace or a joining word."""
    found: list[str] = []
    for tag in reversed(tags):
        if tag.kind in PACES or tag.words[0] in little["joints"]:
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


def _factor(
    quantity: Quantity, pace: str | None, words: Sequence[str], little: LittleWords
) -> float:
    value, told = quantity.value, set(words)
    aimed = quantity.kind == "ratio" and bool(little["aimed_at"] & told)
    compared = bool(little["as"] & told)
    absolute = pace is None or compared or aimed
    if little["speed"] & told and quantity.kind == "" and value < 1 and not little["by"] & told:
        absolute = True
    if absolute:
        slower = pace == "slower" and compared and value > 1
        return rounded(1 / value if slower else value)
    if quantity.kind == "ratio" or value < 1:
        return rounded(1 + value if pace == "faster" else 1 - value)
    return rounded(value if pace == "faster" else 1 / value)
