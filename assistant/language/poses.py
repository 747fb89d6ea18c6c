"""Places told in words: "the block is at 533, 270, 300 turned by 15 degrees"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from assistant.language.naming import without_article
from assistant.language.numbers import Quantity
from assistant.language.phrasebook import Phrasebook
from assistant.language.tags import tags_of
from assistant.model.directions import WAYS, Triple
from assistant.model.listening import Listening
from assistant.model.teacher_acts import SetPose

_AXES = {"x": 0, "y": 1, "z": 2}
_ANGLES = {"roll": 0, "pitch": 1, "yaw": 2}
_STEPS: Mapping[str, Triple] = {
    **WAYS,
    "up-er": WAYS["up"],
    "down-er": WAYS["down"],
    "high": WAYS["up"],
    "low": WAYS["down"],
}


@dataclass(frozen=True, slots=True)
class PoseReading:
    """A place and how many words stayed unexplained."""

    act: SetPose
    unexplained: int


@dataclass(frozen=True, slots=True)
class _Number:
    quantity: Quantity
    before: str
    start: int
    angular: bool


def read_pose(
    words: Sequence[str], broken: Sequence[bool], listening: Listening, book: Phrasebook
) -> PoseReading | None:
    """Return the place a clause tells; None if it tells none."""
    if not any(char.isdigit() for word in words for char in word) and not any(
        word in book.numbers.ones
        or word in book.numbers.tens
        or (word,) in book.numbers.also
        or word in book.little["counting"]
        for word in words
    ):
        return None
    body = _body(words, listening, book)
    if body is None and listening.asked != "pose":
        return None
    comma = book.little["comma"]
    if sum(word in comma for word in words) > 1:
        broken = [mark or word in comma for mark, word in zip(broken, words, strict=True)]
    numbers = _numbers(words, broken, book)
    lengths = [one for one in numbers if not one.angular]
    angles = [one for one in numbers if one.angular]
    name = body[0] if body else _only(listening)
    position = _position(lengths)
    turned = _turned(angles, words, book)
    by = None if position else displacement(words, book)
    meant = body is not None or listening.asked == "pose"
    if by is None and position is None and (turned is None or not meant):
        return None
    if position is None and body is not None and not _told(words, book, listening):
        return None
    spent = {at for one in numbers for at in range(one.start, one.quantity.end)}
    spent |= set(range(body[1], body[2])) if body else set()
    known = {word for phrase in book.answer_words["pose_fillers"] for word in phrase}
    left = [
        word
        for at, word in enumerate(words)
        if at not in spent and word not in known and (word,) not in book.motion
    ]
    return PoseReading(SetPose(name, position, None if by else turned, by), len(left))


def _only(listening: Listening) -> str:
    return listening.objects[0] if len(listening.objects) == 1 else ""


def _told(words: Sequence[str], book: Phrasebook, listening: Listening) -> bool:
    """Tell a place from a correction: "the block is ... left", not "move the block left"."""
    if listening.asked == "pose":
        return True
    stated, targets = _listed(book, "stated"), _listed(book, "targets")
    wanted = book.answer_words.get("pose_wanting", ())
    if any((word,) in wanted or book.motion.get((word,)) == "too" for word in words):
        return False
    return bool(stated & set(words)) or bool(targets & set(words[:3]))


def _listed(book: Phrasebook, name: str) -> frozenset[str]:
    return frozenset(word for phrase in book.answer_words[f"pose_{name}"] for word in phrase)


def _body(
    words: Sequence[str], listening: Listening, book: Phrasebook
) -> tuple[str, int, int] | None:
    """Return the body named and where its words are."""
    for name in sorted(listening.objects, key=len, reverse=True):
        parts = name.lower().split()
        for at in range(len(words) - len(parts) + 1):
            if list(words[at : at + len(parts)]) == parts:
                return name, at, at + len(parts)
    if listening.asked == "pose":
        first = _told_first(words, book)
        if first is not None:
            return body_like(first[0], listening), first[1], first[2]
    bodies = {word for phrase in book.answer_words["pose_bodies"] for word in phrase}
    for at, word in enumerate(words):
        if word in bodies:
            start = _noun_start(words, at, book)
            name = " ".join(_bare(words[start : at + 1], book))
            return body_like(name, listening), start, at + 1
    return None


def body_like(name: str, listening: Listening) -> str:
    """Return the known object whose name ends alike, or the name as told."""
    noun = name.rpartition(" ")[2]
    return next((one for one in listening.objects if noun in one.lower().split()), name)


def _told_first(words: Sequence[str], book: Phrasebook) -> tuple[str, int, int] | None:
    """Return a body nobody spoke of before: "bolt at 400, 150, 90"."""
    places = {word for phrase in book.answer_words["pose_at"] for word in phrase}
    little = book.little
    if words[0] in little["moving"] and len(words) > 2:
        start = 2 if words[1] in little["placed_articles"] else 1
        known = {word for phrase in book.motion for word in phrase} - little["known_bodies"]
        end = next(
            (
                n
                for n, word in enumerate(words)
                if (n > start and word in known | places) or book.numbers.number(words, n)
            ),
            start,
        )
        named = " ".join(words[start:end])
        return (named, 0, end) if 0 < end - start <= 3 else None
    numbers = book.numbers
    found = (at for at, word in enumerate(words) if word in places or numbers.number(words, at))
    end = next(found, 0)
    name = _bare(words[:end], book)
    while len(name) > 1 and name[-1] in little["behind_names"]:
        name = name[:-1]
    fit = 0 < len(name) <= _LONGEST_NAME and not set(name) & little["no_bodies"]
    turning = {word for phrase in book.answer_words["pose_turning"] for word in phrase}
    # "rpy 0 0 90" tells no thing, and of "heat sink HS2" the number is no place.
    counted = any(not any(map(str.isalpha, word)) for word in name)
    return (" ".join(name), 0, end) if fit and not counted and set(name) - turning else None


_LONGEST_NAME = 4


def _bare(words: Sequence[str], book: Phrasebook) -> Sequence[str]:
    return without_article(words, book.little["determiners"] | book.numbers.articles)


def _noun_start(words: Sequence[str], at: int, book: Phrasebook) -> int:
    """Return where a noun phrase with its adjectives begins: after the article."""
    articles = book.numbers.articles | book.little["bodys_articles"]
    for start in range(at - 1, max(at - 4, -1), -1):
        if words[start] in articles:
            return start
    return at


def _numbers(words: Sequence[str], broken: Sequence[bool], book: Phrasebook) -> list[_Number]:
    """Return the numbers told, none of them across a mark."""
    turning = {word for phrase in book.answer_words["pose_turning"] for word in phrase}
    cuts = [at for at in range(1, len(words)) if broken[at]]
    found: list[_Number] = []
    at = 0
    axis = ""
    turned = False
    while at < len(words):
        word = words[at]
        end = next((cut for cut in cuts if cut > at), len(words))
        quantity = (
            None
            if word in book.little["quantity_articles"]
            else _quantity(words[:end], at, book, len(cuts))
        )
        if quantity is None:
            axis = (
                word
                if word in _AXES or word in _ANGLES
                else ("" if word in book.little["and"] else axis)
            )
            turned = (turned or word in turning or word in _ANGLES) and word not in _AXES
            at += 1
            continue
        angular = quantity.kind == "deg" or (turned and quantity.kind == "")
        found.append(_Number(quantity, axis, at, angular))
        axis = ""
        at = quantity.end
    return found


def _quantity(words: Sequence[str], at: int, book: Phrasebook, marks: int) -> Quantity | None:
    """Return the number at a place, read digit by digit where marks part the numbers."""
    numbers = book.numbers
    end = at
    while end < len(words) and (
        numbers.number(words[: end + 1], end) or words[end] in numbers.minus
    ):
        end += 1
    told = numbers.listed(words[at:end]) if marks >= _TWO_MARKS else None
    plain = numbers.quantity(words, at)
    if told is not None and plain is not None and plain.end < end:
        return Quantity(told, "", end)
    return plain


_TWO_MARKS = 2


def _position(lengths: Sequence[_Number]) -> tuple[float, float, float] | None:
    if len(lengths) != 3:
        return None
    kinds = [one.quantity.kind for one in lengths]
    unit = _shared_unit(lengths)
    values = [
        one.quantity.value * (1000.0 if kind == "m" else unit)
        for one, kind in zip(lengths, kinds, strict=True)
    ]
    places = [_AXES.get(one.before, at) for at, one in enumerate(lengths)]
    if sorted(places) != [0, 1, 2]:
        places = [0, 1, 2]
    ordered = dict(zip(places, values, strict=True))
    return _clean(ordered[0]), _clean(ordered[1]), _clean(ordered[2])


def _shared_unit(lengths: Sequence[_Number]) -> float:
    """Return mm a bare number stands for, when only the last has a unit ("53, 27 and 30 cm")."""
    last = lengths[-1].quantity
    if last.kind != "m" or all(one.quantity.kind == "m" for one in lengths):
        return 1.0
    return 1.0 if last.value > 1.5 else _unit_mm(last)


def _unit_mm(quantity: Quantity) -> float:
    return quantity.unit * 1000.0 if quantity.unit else 1.0


def _turned(angles: Sequence[_Number], words: Sequence[str], book: Phrasebook) -> Triple | None:
    if not angles:
        return None
    if len(angles) == 3 or any(one.before in _ANGLES for one in angles):
        turned = [0.0, 0.0, 0.0]
        for at, one in enumerate(angles[:3]):
            place = _ANGLES.get(one.before, at if len(angles) == 3 else 2)
            turned[place] = _clean(one.quantity.value)
        return turned[0], turned[1], turned[2]
    yaw = _clean(angles[0].quantity.value)
    behind = set(words[angles[0].quantity.end :]) | set(words[: angles[0].start][-3:])
    sign: Literal[1, -1] = -1 if behind & book.little["rightwards"] else 1
    return 0.0, 0.0, sign * yaw


def displacement(words: Sequence[str], book: Phrasebook) -> tuple[float, float, float] | None:
    """Return a displacement: "ten centimetres further left and five forward"."""
    total = [0.0, 0.0, 0.0]
    held, unit_mm = None, 0.0
    step: tuple[float, float, float] | None = None
    seen = False
    for tag in tags_of(words, book, frozenset()):
        if tag.quantity is not None and tag.quantity.kind == "m":
            held, unit_mm = tag.quantity.value * 1000.0, tag.quantity.unit * 1000.0
        elif tag.quantity is not None and tag.quantity.kind == "" and unit_mm:
            held = tag.quantity.value * unit_mm
        elif tag.kind in _STEPS:
            step = _STEPS[tag.kind]
        if held is not None and step is not None:
            total = [have + held * part for have, part in zip(total, step, strict=True)]
            held, step, seen = None, None, True
    return (_clean(total[0]), _clean(total[1]), _clean(total[2])) if seen else None


def _clean(value: float) -> float:
    return float(f"{value:.9g}") + 0.0
