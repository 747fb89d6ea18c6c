"""Corrections of speed, place and turn, read from classes of words in any order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import cast

from assistant.language.numbers import Quantity
from assistant.language.phrasebook import Phrasebook
from assistant.model.teacher_acts import (
    AdjustSpeed,
    Degree,
    MoveDirection,
    Rotate,
    TeacherAct,
    Translate,
    TurnDirection,
)

OPPOSITE = {
    "left": "right",
    "right": "left",
    "up": "down",
    "down": "up",
    "forward": "backward",
    "backward": "forward",
    "clockwise": "counterclockwise",
    "counterclockwise": "clockwise",
    "faster": "slower",
    "slower": "faster",
}
WAYS = {
    **{way: way for way in OPPOSITE if way not in ("faster", "slower")},
    "up-er": "up",
    "down-er": "down",
    "high": "up",
    "low": "down",
    "raise": "up",
    "lower": "down",
    "advance": "forward",
    "retreat": "backward",
}
_PACES = {"faster": "faster", "fast": "faster", "slower": "slower", "slow": "slower"}
_ADJECTIVES = frozenset((("slow",), ("quick",), ("fast",)))


@dataclass(frozen=True, slots=True)
class Tag:
    """A stretch of words with the class it belongs to; class ``other`` is unexplained."""

    kind: str
    quantity: Quantity | None
    words: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Reading:
    """Acts read from a clause and how many of its words stayed unexplained."""

    acts: tuple[TeacherAct, ...]
    unexplained: int
    empty: int = 0


def tags_of(words: Sequence[str], book: Phrasebook, names: frozenset[str]) -> tuple[Tag, ...]:
    """Return the classes of the words, longest phrases first."""
    found: list[Tag] = []
    at = 0
    while at < len(words):
        begun = book.motion_begun.get(words[at], ())
        phrase = next((one for one in begun if tuple(words[at : at + len(one)]) == one), None)
        quantity = book.numbers.quantity(words, at)
        if quantity is not None and (phrase is None or quantity.end - at >= len(phrase)):
            found.append(Tag("quantity", quantity, tuple(words[at : quantity.end])))
            at = quantity.end
        elif phrase is not None:
            at += len(phrase)
            # Behind all else "too" means also, and German "zu" shuts the hand.
            alone = book.motion[phrase] == "too" and (not words[at:] or words[at] in _JOINTS)
            found.append(Tag("other" if alone else book.motion[phrase], None, phrase))
        else:
            kind = "skip" if words[at] in names else "other"
            kind = "empty" if words[at] in book.empty else kind
            found.append(Tag(kind, None, (words[at],)))
            at += 1
    return tuple(found)


def read_motion(
    words: Sequence[str], book: Phrasebook, names: frozenset[str] = frozenset()
) -> Reading | None:
    """Return what a clause asks to change in the motion; None if nothing of the kind."""
    tags = tags_of(words, book, names)
    kinds = [tag.kind for tag in tags]
    unexplained = kinds.count("other")
    empty = kinds.count("empty")
    if not _said_motion(kinds) and not any(kind in _PACES for kind in kinds):
        unexplained += empty
    if any(kind in _PACES or kind == "speed" for kind in kinds):
        paced = _speed(tags, words)
        rest = [tag for tag in tags if tag.kind in WAYS]
        if paced is None:
            return None
        noun = "speed" in kinds
        odd = sum(t.kind not in _UPDOWN or not noun for t in rest)
        return Reading((paced,), unexplained + odd, empty)
    ways = [at for at, kind in enumerate(kinds) if kind in WAYS]
    if not ways:
        return None
    groups = _groups(tags, ways)
    acts: list[TeacherAct] = []
    turning = any(kind in ("turn", "tilt") for kind in kinds)
    for group in groups:
        act = _displacement(group, turning=turning)
        if act is None:
            return None
        acts.append(act)
    if not turning:
        unexplained += sum(tag.quantity is not None and tag.quantity.kind == "" for tag in tags)
    bare = len(tags) > 1 and not _said_motion(kinds) and "skip" in kinds
    if bare and _odd(kinds) and len(groups) > 1:
        return None
    return Reading(tuple(acts), unexplained + (1 if bare and _odd(kinds) else 0), empty)


_TIMES = frozenset(("times", "as", "twice", "double", "triple", "thrice", "fold", "x", "speed"))
_RATIOS = ("ratio", "")
_JOINTS = frozenset(("and", "but", "then", "und", "aber", "dann"))
_UPDOWN = frozenset(("up", "down", "up-er", "down-er", "high", "low", "lower", "raise"))
_SAYING = frozenset(
    ["turn", "tilt", "move", "quantity", "little", "much", "more", "less", "too", "not", "enough"]
)


def _said_motion(kinds: Sequence[str]) -> bool:
    return any(kind in _SAYING or kind in ("up-er", "down-er", "raise", "lower") for kind in kinds)


def _odd(kinds: Sequence[str]) -> bool:
    """Tell whether words beside a bare direction make it doubtful ("it is right there")."""
    return kinds.count("skip") > 2


def _groups(tags: tuple[Tag, ...], ways: Sequence[int]) -> list[tuple[Tag, ...]]:
    """Cut a clause with several directions into one stretch a direction."""
    distinct = [
        at for n, at in enumerate(ways) if n == 0 or _way(tags, at) != _way(tags, ways[n - 1])
    ]
    if len(distinct) == 1:
        return [tags]
    cuts = [0]
    for before, after in pairwise(distinct):
        joints = [at for at in range(before + 1, after) if tags[at].words[0] in _JOINTS]
        cuts.append(joints[0] if joints else before + 1)
    return [tags[a:b] for a, b in zip(cuts, [*cuts[1:], len(tags)], strict=True)]


def _way(tags: Sequence[Tag], at: int) -> str:
    return WAYS[tags[at].kind]


def _displacement(tags: Sequence[Tag], *, turning: bool) -> TeacherAct | None:
    way = next((WAYS[tag.kind] for tag in tags if tag.kind in WAYS), None)
    if way is None:
        return None
    if _flipped(tags):
        way = OPPOSITE[way]
    quantity = next((tag.quantity for tag in tags if tag.quantity), None)
    kind = quantity.kind if quantity else ""
    turning = (turning and kind != "m") or kind == "deg" or way.endswith("clockwise")
    value = abs(quantity.value) if quantity and kind in ("m", "deg") else None
    if quantity and kind == "" and turning:
        value = abs(quantity.value)
    degree = None if value is not None else _degree(tags)
    if turning:
        angle = None if value is None else _rounded(value)
        return Rotate(cast("TurnDirection", way), degree, angle)
    distance = None if value is None else _rounded(value)
    return Translate(cast("MoveDirection", way), degree, distance)


def _rounded(value: float) -> float:
    return float(f"{value:.9g}")


def _flipped(tags: Sequence[Tag]) -> bool:
    kinds = [tag.kind for tag in tags]
    if "enough" in kinds:
        return False
    return "too" in kinds or "not" in kinds or "less" in kinds


def _degree(tags: Sequence[Tag]) -> Degree | None:
    """Return little or much; "too far" and "not so much" only name the direction."""
    found: list[str] = []
    for at, tag in enumerate(tags):
        if tag.kind not in ("little", "much"):
            continue
        before = tags[at - 1].kind if at else ""
        if tag.kind == "much" and before in ("too", "so", "enough"):
            continue
        if tag.words == ("far",) or (tag.words == ("well",) and before):
            behind = tags[at + 1].kind if at + 1 < len(tags) else ""
            if behind != "too":
                continue
        found.append(tag.kind)
    if not found:
        return None
    return "little" if "little" in found else "much"


def degree_of(words: Sequence[str], book: Phrasebook) -> Degree | None:
    """Return little or much, wherever it stands."""
    return _degree(tags_of(words, book, frozenset()))


def factor_of(words: Sequence[str], book: Phrasebook) -> float | None:
    """Return the factor of the present speed that words tell, wherever it stands."""
    tags = tags_of(words, book, frozenset())
    quantity = next((t.quantity for t in tags if t.quantity and t.quantity.kind in _RATIOS), None)
    if quantity is None:
        return None
    pace = next((_PACES[tag.kind] for tag in tags if tag.kind in _PACES), None)
    return _factor(quantity, pace or _pace_of_noun([tag.kind for tag in tags]), words)


def _speed(tags: Sequence[Tag], words: Sequence[str]) -> AdjustSpeed | None:
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
    if not told and _flipped(tags):
        pace = OPPOSITE[pace]
    change = "faster" if pace == "faster" else "slower"
    return AdjustSpeed(change="faster" if change == "faster" else "slower", degree=_degree(tags))


def _told_pace(tags: Sequence[Tag]) -> str | None:
    """Return the pace that words tell, each by itself: "faster, too slow" is twice faster.

    "Too", "not", "less" and a complaining "so" just before a word turn it round.
    """
    told: list[tuple[bool, str]] = []
    for at, tag in enumerate(tags):
        if tag.kind not in _PACES:
            continue
        before = [one.kind for one in tags[max(0, at - 4) : at]]
        near = before[-2:] if "not" not in before else before
        plain = tag.kind in ("fast", "slow") or tag.words in _ADJECTIVES
        turned = bool({"too", "not", "less"} & set(near)) and "enough" not in [t.kind for t in tags]
        turned = turned or (plain and at > 0 and tags[at - 1].words == ("so",))
        pace = _PACES[tag.kind]
        complained = turned or tag.kind in ("fast", "slow")
        told.append((complained, OPPOSITE[pace] if turned else pace))
    # What is asked for outright counts before what is complained of.
    return min(told, key=lambda one: one[0])[1] if told else None


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
        return _rounded(1 / value if slower else value)
    if quantity.kind == "ratio" or value < 1:
        return _rounded(1 + value if pace == "faster" else 1 - value)
    return _rounded(value if pace == "faster" else 1 / value)
