"""The words of a language, read once from ``hears.yaml`` and kept ready for matching."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, cast

from assistant.errors import BadInput
from assistant.language.numbers import Kind, NumberWords, glued
from assistant.language.templates import (
    Node,
    Reader,
    all_words,
    compiled,
    first_words,
    has_slot,
    needed_words,
)
from assistant.plain_yaml import read_file

LANGUAGES = {"english": "english", "en": "english", "german": "german", "de": "german"}
Phrase = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Sentence:
    """A way to say an act, compiled; `first` holds the words it can begin with."""

    act: str
    slots: Mapping[str, Any]
    nodes: tuple[Node, ...]
    first: frozenset[str] | None
    stages: frozenset[str]
    asked: frozenset[str]
    extra: str
    template: str
    needed: tuple[frozenset[str], ...]
    only: frozenset[str] | None

    def may_match(self, words: frozenset[str]) -> bool:
        """Tell quickly whether words can match: all are the template's, and none it needs lacks."""
        if self.only is not None and not words <= self.only:
            return False
        return not any(words.isdisjoint(one) for one in self.needed)


@dataclass(frozen=True)
class Phrasebook:
    """All that a language's teachers may say."""

    contractions: Mapping[str, Phrase]
    fillers: frozenset[Phrase]
    vocatives: tuple[frozenset[Phrase], frozenset[Phrase]]
    opening: frozenset[Phrase]
    closing: frozenset[Phrase]
    correction: tuple[Phrase, ...]
    contrary: tuple[frozenset[str], ...]
    not_taken_back: tuple[Phrase, ...]
    consenting: frozenset[Phrase]
    numbers: NumberWords
    motion: Mapping[Phrase, str]
    where: Mapping[str, tuple[Phrase, ...]]
    chat: frozenset[str]
    homophones: Mapping[Phrase, Phrase]
    sentences: tuple[Sentence, ...]
    by_first: Mapping[str, tuple[Sentence, ...]]
    answers: Mapping[str, tuple[tuple[Node, ...], ...]]
    answer_words: Mapping[str, tuple[Phrase, ...]]
    vocabulary: frozenset[str]
    suggestions: Mapping[str, tuple[str, ...]]
    again: tuple[Phrase, ...]
    real: frozenset[str]
    empty: frozenset[str]
    polite: frozenset[str]
    addressed: frozenset[str]
    yes: frozenset[str]
    no: frozenset[str]
    negating: frozenset[str]
    impure: frozenset[str]
    wrapping: Mapping[str, tuple[Phrase, ...]]


@cache
def phrasebook(language: str = "english") -> Phrasebook:
    """Return the phrasebook of a language, read once.

    Raises
    ------
    BadInput
        If there is no phrasebook of that language.
    """
    folder = LANGUAGES.get(language.lower())
    if folder is None:
        raise BadInput.one("language", f"unknown language {language!r}", "english or german")
    path = Path(__file__).parent / folder / "hears.yaml"
    if not path.exists():
        raise BadInput.one("language", f"{folder} is not understood yet", "english is")
    classes = cast("dict[str, Any]", read_file(path.with_name("frames.yaml"))[0].value)
    return _made(cast("dict[str, Any]", read_file(path)[0].value), classes)


def _made(book: Mapping[str, Any], classes: Mapping[str, Any]) -> Phrasebook:
    numbers = _numbers(book["numbers"])
    readers: dict[str, Reader] = {"n": numbers.number_ends, "nth": numbers.ordinal_ends}
    made: dict[str, Node] = {}
    sentences = tuple(_sentences(book, readers, made))
    wrappings = ("tails", "heads", "list_joints", "item_heads", "none")
    answers = {
        asked: tuple(compiled(line, book["rules"], readers, made) for line in _lines(told))
        for asked, told in book["answers"].items()
        if asked not in wrappings
    }
    motion = {phrase: kind for kind, told in book["motion"].items() for phrase in _phrases(told)}
    opening, closing = _phrases(book["opening"]), _phrases(book["closing"])
    vocabulary = {word for one in sentences for word in all_words(one.nodes)}
    vocabulary |= {word for phrase in (*motion, *opening, *closing) for word in phrase}
    vocabulary |= {*numbers.ones, *numbers.tens, *numbers.units, *numbers.fractions}
    told = ",".join([classes["empty"], classes["polite"], *classes["classes"].values()])
    vocabulary |= _phrase_words(_phrases(told))
    vocabulary |= {*numbers.ordinals, *_phrase_words(numbers.also)}
    return Phrasebook(
        contractions=_contractions(book, vocabulary),
        fillers=frozenset(_phrases(book["fillers"])),
        vocatives=_vocatives(book["vocatives"]),
        opening=frozenset(opening),
        closing=frozenset(closing),
        correction=tuple(sorted(_phrases(book["correction"]), key=len, reverse=True)),
        contrary=tuple(
            frozenset(word for (word,) in _phrases(line)) for line in _lines(book["contrary"])
        ),
        not_taken_back=_longest_first(book["not_taken_back"]),
        consenting=frozenset(_phrases(book["consenting"])),
        numbers=numbers,
        motion=motion,
        where={name: _longest_first(told) for name, told in _where(book).items()},
        chat=frozenset(phrase[0] for phrase in _phrases(book["chat"]) if len(phrase) == 1),
        homophones={
            tuple(key.split()): tuple(value.split()) for key, value in _pairs(book["homophones"])
        },
        sentences=sentences,
        by_first=_index(sentences),
        answers=answers,
        answer_words={name: _longest_first(book["answers"][name]) for name in wrappings}
        | {f"pose_{name}": _longest_first(told) for name, told in book["poses"].items()}
        | {f"stop_{name}": _longest_first(told) for name, told in book["stops"].items()}
        | {f"key_{name}": _longest_first(told) for name, told in book["key_states"].items()},
        vocabulary=frozenset(word for word in vocabulary if word.isalpha()),
        again=_longest_first(book["again"]),
        empty=_single(classes["empty"]) - _turning(book),
        polite=_single(classes["polite"]),
        addressed=_single(classes["addressed"]),
        yes=_single(classes["classes"]["yes"]),
        no=_single("no, nope, nah, nein"),
        negating=_single(classes["classes"]["no"]),
        impure=_single(classes["impure"]),
        wrapping={name: _longest_first(told) for name, told in classes["answers"].items()},
        real=frozenset(book["real"].split())
        | {word for one in _phrases(book["chat"]) for word in one},
        suggestions={
            key: tuple(" ".join(phrase) for phrase in _phrases(told))
            for key, told in book["suggestions"].items()
        },
    )


def _sentences(
    book: Mapping[str, Any], readers: Mapping[str, Reader], made: dict[str, Node]
) -> Iterable[Sentence]:
    for entry in book["sentences"]:
        extra = next(
            (key for key in ("text", "list", "number", "seconds", "ratio") if key in entry), ""
        )
        for line in _lines(entry["say"]):
            nodes = compiled(line, book["rules"], readers, made)
            yield Sentence(
                act=entry["act"],
                slots=entry.get("slots", {}),
                nodes=nodes,
                first=first_words(nodes),
                stages=frozenset(entry.get("stage", "").split()),
                asked=frozenset(entry.get("asked", "").split()),
                extra=extra,
                template=line,
                needed=needed_words(nodes),
                only=None if has_slot(nodes) else frozenset(all_words(nodes)),
            )


def _index(sentences: Sequence[Sentence]) -> dict[str, tuple[Sentence, ...]]:
    """Group sentences by the word they begin with; ``""`` holds those that begin freely."""
    found: dict[str, list[Sentence]] = {"": []}
    for sentence in sentences:
        for word in sentence.first if sentence.first is not None else ("",):
            found.setdefault(word, []).append(sentence)
    return {word: tuple(ones) for word, ones in found.items()}


def _numbers(told: Mapping[str, Any]) -> NumberWords:
    ones = {word: value for value, word in enumerate(told["ones"].split())}
    tens = {word: 10 * value for value, word in enumerate(told["tens"].split(), start=2)}
    ordinals = {word: value for value, word in enumerate(told["ordinals"].split(), start=1)}
    units: dict[str, tuple[Kind, float]] = {}
    for key, names in _pairs(told["units"]):
        kind, factor = key.split(":")
        for name in names.split(","):
            units[name.strip()] = (cast("Kind", kind.strip()), float(factor))
    whole = glued(told.get("glued", ""), tens, ones)
    also: dict[Phrase, float] = {(word,): value for word, value in whole.items()}
    also |= {tuple(key.split()): float(value) for key, value in _pairs(told["also"])}
    return NumberWords(
        ones=ones,
        tens=tens,
        also=also,
        begun={
            phrase[0]: tuple(sorted((p for p in also if p[0] == phrase[0]), key=len, reverse=True))
            for phrase in also
        },
        ordinals=ordinals,
        fractions={key: float(value) for key, value in _pairs(told["fractions"])},
        units=units,
        hundred=frozenset(told["hundred"].split()),
        joiners=frozenset(told["and"].split()),
        articles=frozenset(told["a"].split()),
        points=frozenset(told["point"].split()),
        minus=frozenset(told["minus"].split()),
    )


def _lines(text: str) -> list[str]:
    return [line.strip() for line in text.splitlines() if line.strip()]


def _pairs(text: str) -> list[tuple[str, str]]:
    parts = (line.partition(" = ") for line in _lines(text))
    return [(_bare(key), value.strip()) for key, _, value in parts]


def _bare(key: str) -> str:
    told = key.strip()
    return told[1:-1] if len(told) > 2 and told[0] == told[-1] == "'" else told


def _phrases(text: str) -> list[Phrase]:
    joined = " ".join(text.split())
    return [tuple(phrase.split()) for phrase in joined.split(",") if phrase.strip()]


def _turning(book: Mapping[str, Any]) -> set[str]:
    """Return the words that say when something holds, or take back what was said."""
    told = [_phrases(book["where"][when]) for when in ("during", "before", "after")]
    weak = {"at", "in", "for", "as", "once"}
    taken_back = {"sorry", "mean", "meant", "rather", "actually", "instead", "but", "if"}
    return {phrase[0] for phrases in told for phrase in phrases} - weak | taken_back


def _contractions(book: Mapping[str, Any], vocabulary: set[str]) -> Mapping[str, Phrase]:
    """Return what is spelled otherwise elsewhere, words with dots typed without them as well."""
    told = _pairs(book.get("dialect", "") + book["contractions"])
    taken = vocabulary | set(book["real"].split())
    words = [one for one in taken if one.isalpha() and not one.isascii()]
    ways = [str.maketrans(dict(zip("äöüß", to, strict=True))) for to in _DOTLESS]
    plain = {word.translate(way): (word,) for way in ways for word in words if len(word) > 3}
    found = {key: one for key, one in plain.items() if key not in taken}
    return found | {key: tuple(value.split()) for key, value in told}


_DOTLESS = (("a", "o", "u", "ss"), ("ae", "oe", "ue", "ß"), ("ae", "oe", "ue", "ss"))


def _vocatives(text: str) -> tuple[frozenset[Phrase], frozenset[Phrase]]:
    sure, others = _lines(text)
    return frozenset(_phrases(sure)), frozenset(_phrases(f"{sure}, {others}"))


def _where(book: Mapping[str, Any]) -> dict[str, str]:
    return {"stepping": "", **book["where"]}


def _single(text: str) -> frozenset[str]:
    return frozenset(phrase[0] for phrase in _phrases(text) if len(phrase) == 1)


def _longest_first(text: str) -> tuple[Phrase, ...]:
    return tuple(sorted(_phrases(text), key=len, reverse=True))


def _phrase_words(phrases: Iterable[Phrase]) -> set[str]:
    return {word for phrase in phrases for word in phrase}
