"""Shape and size of a thing from a teacher's words: "a box, 6 by 4 by 10 centimetres"."""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from assistant.language.hints import hints, matter, mentions
from assistant.language.phrasebook import phrasebook

Triple = tuple[float, float, float]
Shape = Literal["box", "cylinder", "sphere", "cup"]
_NUMBER = re.compile(r"(\d+(?:[.,]\d+)?)\s*([^\W\d_]+)?|\b([^\W\d_]+)\b")


@dataclass(frozen=True, slots=True)
class ToldBody:
    """What was told of a body; None for what was not."""

    shape: Shape | None
    size_mm: Triple | None


def read_body(text: str, language: str = "english", name: str = "") -> ToldBody:
    """Return the shape and size that some words tell; centimetres if no unit is said.

    A box needs three lengths (two for a flat mark, one for a cube), a cylinder or cup the
    diameter and the height, a ball its diameter. "8 wide and 7 high" is as deep as wide.

    Parameters
    ----------
    text : str
    language : str
    name : str
        What the body is called; a cup is a cup though only its size is told.
    """
    shape = shape_in(text, language)
    if shape is None and mentions(text, hints("places", language)):
        # Lengths that tell where a thing is are no size.
        return ToldBody(None, None)
    shape = shape or shape_in(name, language)
    lengths = read_lengths_mm(text, language)
    return ToldBody(shape, _size(shape or "box", _upright_last(text, lengths, language)))


def shape_in(text: str, language: str = "english") -> Shape | None:
    """Return the shape that words name; what is only flat is a box."""
    shapes: dict[str, Shape] = {
        "box": "box",
        "cylinder": "cylinder",
        "sphere": "sphere",
        "cup": "cup",
        "flat": "box",
    }
    return shapes.get(matter(text, "shapes", language))


def _upright_last(text: str, lengths: tuple[float, ...], language: str) -> tuple[float, ...]:
    """Return lengths with the height at the end, and two for the ground, if a height is told."""
    words = "|".join(map(re.escape, hints("upright", language)))
    found = re.search(rf"\b(?:{words})\b", text.lower())
    if found is None or len(lengths) < 2:
        return lengths
    # "7 high" and "a height of 7": a number before the word is its own.
    before = len(read_lengths_mm(text[: found.start()], language))
    told = text[: found.start()].lower()
    units = "|".join(map(re.escape, hints("units", language)))
    close = re.search(
        rf"\d\s*[^\W\d_]*\s*$|\b(?:{_numbers(language)})\s*[^\W\d_]*\s*$|\b(?:{units})\s*$",
        told,
    )
    at = min(before - 1 if close else before, len(lengths) - 1)
    ground = [one for number, one in enumerate(lengths) if number != max(at, 0)]
    return (*(ground * 2 if len(ground) == 1 else ground), lengths[max(at, 0)])


def _numbers(language: str) -> str:
    return "|".join(map(re.escape, hints("numbers", language)))


def read_lengths_mm(text: str, language: str = "english") -> tuple[float, ...]:
    """Return the lengths in a text in mm; a unit said once holds for the numbers before it."""
    units: dict[str, float] = hints("units", language)
    numbers: dict[str, int] = hints("numbers", language)
    # "Ein" is a length before a unit alone: "ein Würfel, 4 Zentimeter groß" has one length.
    articles: list[str] = hints("articles", language)
    joints: list[str] = hints("between_lengths", language)
    book = phrasebook(language).numbers
    values: list[float] = []
    scales: list[float | None] = []
    parts = [*_NUMBER.findall(text.lower()), ("", "", "")]
    for (digits, unit, word), (_, _, behind) in pairwise(parts):
        spoken = book.number((word,), 0) if word and behind in units else None
        if digits:
            values.append(float(digits.replace(",", ".")))
            scales.append(units.get(unit))
        elif word in numbers and (word not in articles or behind in units or behind in joints):
            values.append(float(numbers[word]))
            scales.append(None)
        elif spoken:
            values.append(spoken[0])
            scales.append(None)
        elif word in units and scales:
            scales[-1] = units[word]
    return _scaled(values, scales)


def _scaled(values: list[float], scales: list[float | None]) -> tuple[float, ...]:
    known: float | None = None
    for position in range(len(scales) - 1, -1, -1):
        known = scales[position] or known
        scales[position] = known
    last = next((scale for scale in reversed(scales) if scale), 10.0)
    pairs = zip(values, scales, strict=True)
    return tuple(value * (scale or last) for value, scale in pairs if value > 0)


def _size(shape: Shape, lengths: tuple[float, ...]) -> Triple | None:
    if not lengths:
        return None
    if shape == "sphere":
        return (lengths[0],) * 3
    if shape in ("cylinder", "cup"):
        return (lengths[0], lengths[0], lengths[-1]) if len(lengths) > 1 else None
    if len(lengths) == 1:
        return (lengths[0],) * 3
    return (lengths[0], lengths[1], lengths[2] if len(lengths) > 2 else 0.0)
