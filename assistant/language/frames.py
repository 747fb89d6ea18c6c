"""Frames: acts told by the kinds of words that occur, in any order, with fillers between.

A language's ``frames.yaml`` lists classes of words and the frames made of them; this module
reads them and finds where the classes occur. `framing` makes acts of what is found.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from pathlib import Path
from typing import Any, cast

from assistant.language.numbers import NumberWords
from assistant.language.phrasebook import LANGUAGES, Phrase
from assistant.plain_yaml import read_file

Span = tuple[int, int]
Spans = Mapping[str, tuple[Span, ...]]


@dataclass(frozen=True, slots=True)
class Frame:
    """Classes that make an act, and where its slots come from.

    Parameters
    ----------
    needs : tuple of tuple of str
        Each must occur, in one of its ways.
    never, may : frozenset of str
        Classes that must not occur, and those that explain further words.
    slots : mapping
        Fixed values, and ``{}``, ``{class}`` or ``{*}`` for names.
    expected : bool
        Whether it holds only where its act is expected already.
    """

    act: str
    slots: Mapping[str, str]
    needs: tuple[tuple[str, ...], ...]
    never: frozenset[str]
    may: frozenset[str]
    stages: frozenset[str]
    asked: frozenset[str]
    expected: bool

    @property
    def names(self) -> tuple[tuple[str, str], ...]:
        """Return slots that take the teacher's own words, with where they stand."""
        told = self.slots.items()
        return tuple((slot, value[1:-1]) for slot, value in told if value.startswith("{"))


@dataclass(frozen=True, eq=False)
class Frames:
    """The frames of a language with its classes, by the stem they begin with.

    Parameters
    ----------
    little : mapping
        Small words by what they do: `joints` end a name, `soft` may stand in one, `heads` and
        `tails` are taken off its ends, `asking` begin a question, `asides` begin a clause that
        only explains, `steps` are words for a step.
    name_endings, adverb_endings : tuple of str
        Endings of words that name steps, and of words that tell nothing.
    """

    frames: tuple[Frame, ...]
    phrases: Mapping[Phrase, tuple[tuple[Phrase, str], ...]]
    little: Mapping[str, frozenset[str]]
    name_endings: tuple[str, ...]
    adverb_endings: tuple[str, ...]
    by_class: Mapping[str, tuple[int, ...]]

    def told_by(self, spans: Spans) -> Iterator[Frame]:
        """Yield the frames whose first need occurs, and those that need nothing, in their order."""
        places = {at for name in ("", *spans) for at in self.by_class.get(name, ())}
        return (self.frames[at] for at in sorted(places))

    def small(self, name: str) -> frozenset[str]:
        """Return the small words that do something; a language may have none that do."""
        return self.little.get(name, frozenset())


@cache
def frames(language: str) -> Frames | None:
    """Return the frames of a language, read once; None if it has none."""
    path = Path(__file__).parent / LANGUAGES[language.lower()] / "frames.yaml"
    if not path.exists():
        return None
    told = cast("dict[str, Any]", read_file(path)[0].value)
    phrases: dict[Phrase, list[tuple[Phrase, str]]] = {}
    for name, listed in (("empty", told["empty"]), *told["classes"].items()):
        for phrase in _list(listed):
            stems = tuple(_stem(word) for word in phrase.split())
            phrases.setdefault(stems[:2], []).append((stems, name))
    made = tuple(_frame(line) for line in told["frames"].splitlines() if line.strip())
    return Frames(
        frames=made,
        by_class=_by_class(made),
        phrases={first: tuple(ones) for first, ones in phrases.items()},
        little={name: frozenset(_list(listed)) for name, listed in told["little"].items()},
        name_endings=tuple(_list(told["name_endings"])),
        adverb_endings=tuple(_list(told["adverb_endings"])),
    )


def _by_class(made: Sequence[Frame]) -> Mapping[str, tuple[int, ...]]:
    """Return where the frames stand whose first need is a class; ``""`` for those without."""
    found: dict[str, list[int]] = {}
    for at, frame in enumerate(made):
        for name in frame.needs[0] if frame.needs else ("",):
            found.setdefault(name, []).append(at)
    return {name: tuple(ones) for name, ones in found.items()}


def _list(text: str) -> list[str]:
    return [one.strip() for one in text.replace("\n", " ").split(",") if one.strip()]


def _frame(line: str) -> Frame:
    head, _, rest = line.strip().partition(" : ")
    act, *slots = head.split()
    needed, _, allowed = rest.partition("?")
    marks = [*needed.split(), *allowed.split()]
    return Frame(
        act=act,
        slots=dict(cast("tuple[str, str]", tuple(slot.split("=", 1))) for slot in slots),
        needs=tuple(tuple(one.split("|")) for one in needed.split() if one[0] not in "!@~%"),
        never=frozenset(one[1:] for one in marks if one[0] == "!"),
        may=frozenset(one for one in allowed.split() if one[0] not in "!@~%"),
        stages=frozenset(one[1:] for one in marks if one[0] == "@"),
        asked=frozenset(one[1:] for one in marks if one[0] == "~"),
        expected="%" in marks,
    )


@lru_cache(maxsize=512)
def spans_of(texts: Phrase, known: Frames, numbers: NumberWords) -> Spans:
    """Return where each class occurs, its longest phrases first, and numbers and times."""
    return {**_classes(texts, known), **_counted(texts, numbers)}


def classes_of(texts: Phrase, language: str) -> tuple[str, ...]:
    """Return the classes that occur among the words."""
    known = frames(language)
    return () if known is None else tuple(sorted(_classes(texts, known).keys() - {"empty"}))


@lru_cache(maxsize=512)
def _classes(texts: Phrase, known: Frames) -> dict[str, tuple[Span, ...]]:
    stems = tuple(_stem(text) for text in texts)
    found: dict[str, list[Span]] = {}
    begun = known.phrases.get
    for at in range(len(stems)):
        pair = begun(stems[at : at + 2], ()) if at + 1 < len(stems) else ()
        for phrase, name in (*begun(stems[at : at + 1], ()), *pair):
            if stems[at : at + len(phrase)] == phrase:
                found.setdefault(name, []).append((at, at + len(phrase)))
    dressed = {at for a, b in found.get("empty", ()) if b - a > 1 for at in range(a, b)}
    for name in found.keys() - {"empty"} if dressed else ():
        found[name] = [one for one in found[name] if not dressed.issuperset(range(*one))]
    return {
        name: tuple(sorted(ones, key=lambda s: s[0] - s[1])) for name, ones in found.items() if ones
    }


@lru_cache(maxsize=8192)
def _stem(word: str) -> str:
    """Return a word without its ending; words in -ing stay, for they name steps."""
    found = word.removesuffix("s") if not word.endswith("ss") else word
    found = found.removesuffix("ed") if len(found) > 4 else found
    return found.removesuffix("e") if len(found) > 3 else found


def _counted(texts: Phrase, numbers: NumberWords) -> dict[str, tuple[Span, ...]]:
    """Return where numbers, places in an order and times stand."""
    found: dict[str, list[Span]] = {}
    for at in range(len(texts)):
        quantity = numbers.quantity(texts, at)
        if quantity is not None and quantity.kind in ("s", ""):
            name = "seconds" if quantity.kind == "s" else "number"
            found.setdefault(name, []).append((at, quantity.end))
        unit = numbers.units.get(texts[at])
        behind = numbers.number(texts, at + 1) if unit and unit[0] == "s" else None
        if behind is not None:
            found.setdefault("seconds", []).append((at, behind[1]))
        place = numbers.ordinal(texts, at)
        if place is not None:
            found.setdefault("ordinal", []).append((at, place[1]))
    return {name: tuple(ones) for name, ones in found.items()}


def places(names: Iterable[str], spans: Spans) -> set[int]:
    """Return every place that words of some classes take."""
    return {at for name in names for span in spans.get(name, ()) for at in range(*span)}
