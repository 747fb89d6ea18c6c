"""The words of a language, read once from ``hears.yaml`` and kept ready for matching."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, cast

from assistant.language.bends import Bends, bends_of
from assistant.language.counting import number_words
from assistant.language.lists import (
    Phrase as Phrase,
)
from assistant.language.lists import (
    by_first_word,
    lines,
    longest_first,
    pairs,
    phrase_words,
    phrases,
    single,
)
from assistant.language.little_words import LANGUAGES as LANGUAGES
from assistant.language.little_words import LittleWords, folder_of, little_words
from assistant.language.numbers import NumberWords
from assistant.language.templates import (
    Node,
    Reader,
    all_words,
    compiled,
)
from assistant.language.ways_to_say import Sentence as Sentence
from assistant.language.ways_to_say import beginning, needing, sentences_of
from assistant.language.words import owners
from assistant.model.feedback import When
from assistant.plain_yaml import read_file


@dataclass(frozen=True, eq=False)
class Phrasebook:
    """All that a language's teachers may say."""

    little: LittleWords
    contractions: Mapping[str, Phrase]
    fillers: frozenset[Phrase]
    vocatives: tuple[frozenset[Phrase], frozenset[Phrase]]
    opening: frozenset[Phrase]
    closing: frozenset[Phrase]
    correction: tuple[Phrase, ...]
    correction_begun: Mapping[str, tuple[Phrase, ...]]
    contrary: tuple[frozenset[str], ...]
    contrasting: tuple[Phrase, ...]
    restating: tuple[Phrase, ...]
    not_taken_back: tuple[Phrase, ...]
    consenting: frozenset[Phrase]
    numbers: NumberWords
    motion: Mapping[Phrase, str]
    motion_begun: Mapping[str, tuple[Phrase, ...]]
    where: Mapping[str, tuple[Phrase, ...]]
    where_words: Mapping[str, frozenset[str]]
    whens: Mapping[str, tuple[tuple[Phrase, When], ...]]
    amounts: Mapping[str, tuple[tuple[Phrase, str], ...]]
    keeping: Mapping[str, tuple[Phrase, ...]]
    keeping_words: frozenset[str]
    cueing: Mapping[str, frozenset[str]]
    refusing: frozenset[str]
    chat: frozenset[str]
    homophones: Mapping[Phrase, Phrase]
    bends: Bends
    sentences: tuple[Sentence, ...]
    needing: Mapping[str, tuple[int, ...]]
    beginning: Mapping[str, frozenset[int]]
    answers: Mapping[str, tuple[tuple[Node, ...], ...]]
    answer_words: Mapping[str, tuple[Phrase, ...]]
    vocabulary: frozenset[str]
    suggestions: Mapping[str, tuple[str, ...]]
    again: tuple[Phrase, ...]
    real: frozenset[str]
    empty: frozenset[str]
    stuttered: frozenset[str]
    polite: frozenset[str]
    addressed: frozenset[str]
    yes: frozenset[str]
    no: frozenset[str]
    negating: frozenset[str]
    impure: frozenset[str]
    wrapping: Mapping[str, tuple[Phrase, ...]]
    wrapping_words: Mapping[str, frozenset[str]]

    def candidates(self, texts: Phrase) -> Iterator[Sentence]:
        """Yield the sentences that words can match, those that begin with the first word first."""
        told = frozenset(texts)
        needing = (self.needing.get(word, ()) for word in ("", *told))
        places = set[int]().union(*needing)
        for begun in (texts[0], ""):
            for at in sorted(places & self.beginning.get(begun, frozenset())):
                if self.sentences[at].may_match(told, texts[-1]):
                    yield self.sentences[at]

    def leading_words(self, name: str) -> frozenset[str]:
        """Return the single words of a kind of wrapping; a language may have none."""
        return self.wrapping_words.get(name, frozenset())


@cache
def phrasebook(language: str = "english") -> Phrasebook:
    """Return the phrasebook of a language, read once.

    Raises
    ------
    BadInput
        If there is no phrasebook of that language.
    """
    folder = folder_of(language)
    classes = cast("dict[str, Any]", read_file(folder / "frames.yaml")[0].value)
    told = cast("dict[str, Any]", read_file(folder / "hears.yaml")[0].value)
    return _made(told, classes, little_words(language))


def _made(book: Mapping[str, Any], classes: Mapping[str, Any], little: LittleWords) -> Phrasebook:
    numbers = number_words(book["numbers"])
    readers: dict[str, Reader] = {"n": numbers.number_ends, "nth": numbers.ordinal_ends}
    made: dict[str, Node] = {}
    sentences = tuple(sentences_of(book, readers, made))
    wrappings = ("tails", "heads", "list_joints", "item_heads", "none")
    answers = {
        asked: tuple(compiled(line, book["rules"], readers, made) for line in lines(told))
        for asked, told in book["answers"].items()
        if asked not in wrappings
    }
    motion = {phrase: kind for kind, told in book["motion"].items() for phrase in phrases(told)}
    opening, closing = phrases(book["opening"]), phrases(book["closing"])
    vocabulary = {word for one in sentences for word in all_words(one.nodes)}
    vocabulary |= {word for phrase in (*motion, *opening, *closing) for word in phrase}
    vocabulary |= {*numbers.ones, *numbers.tens, *numbers.units, *numbers.fractions}
    told = ",".join([classes["empty"], classes["polite"], *classes["classes"].values()])
    vocabulary |= phrase_words(phrases(told))
    vocabulary |= {*numbers.ordinals, *phrase_words(numbers.also)}
    led = (told for name, told in _where(book).items() if name not in _WHERE_WORDS)
    vocabulary |= phrase_words(phrases(",".join(led)))
    return Phrasebook(
        little=little,
        contractions=_contractions(book, vocabulary) | owners(little),
        fillers=frozenset(phrases(book["fillers"])),
        vocatives=_vocatives(book["vocatives"]),
        opening=frozenset(opening),
        closing=frozenset(closing),
        correction=longest_first(book["correction"]),
        correction_begun=by_first_word(phrases(book["correction"])),
        contrary=tuple(
            frozenset(word for (word,) in phrases(line)) for line in lines(book["contrary"])
        ),
        contrasting=longest_first(book.get("contrasting", "")),
        restating=longest_first(book.get("restating", "") + "," + book["correction"]),
        not_taken_back=longest_first(book["not_taken_back"]),
        consenting=frozenset(phrases(book["consenting"])),
        numbers=numbers,
        motion=motion,
        motion_begun=by_first_word(motion),
        where={name: longest_first(told) for name, told in _where(book).items()},
        where_words={name: single(book["where"].get(name, "")) for name in _WHERE_WORDS},
        whens=_whens(book["where"]),
        amounts=_amounts(book.get("amounts", {})),
        keeping={name: longest_first(told) for name, told in book.get("keeping", {}).items()},
        keeping_words=frozenset(phrase_words(phrases(",".join(book.get("keeping", {}).values())))),
        cueing={name: frozenset(told.split()) for name, told in book.get("cueing", {}).items()},
        refusing=frozenset(book.get("refusing", "").split()),
        chat=frozenset(phrase[0] for phrase in phrases(book["chat"]) if len(phrase) == 1),
        homophones={
            tuple(key.split()): tuple(value.split()) for key, value in pairs(book["homophones"])
        },
        bends=bends_of(book.get("bends", {})),
        sentences=sentences,
        needing=needing(sentences),
        beginning=beginning(sentences),
        answers=answers,
        answer_words={name: longest_first(book["answers"][name]) for name in wrappings}
        | {f"pose_{name}": longest_first(told) for name, told in book["poses"].items()}
        | {f"stop_{name}": longest_first(told) for name, told in book["stops"].items()}
        | {f"key_{name}": longest_first(told) for name, told in book["key_states"].items()},
        vocabulary=frozenset(word for word in vocabulary if word.isalpha()),
        again=longest_first(book["again"]),
        empty=single(classes["empty"]) - _turning(book, little),
        stuttered=frozenset(book.get("stuttered", "").split()),
        polite=single(classes["polite"]),
        addressed=single(classes["addressed"]),
        yes=single(classes["classes"]["yes"]),
        no=little["no"],
        negating=single(classes["classes"]["no"]),
        impure=single(classes["impure"]),
        wrapping={name: longest_first(told) for name, told in classes["answers"].items()},
        wrapping_words={name: single(told) for name, told in classes["answers"].items()},
        real=frozenset(book["real"].split())
        | {word for one in phrases(book["chat"]) for word in one},
        suggestions={
            key: tuple(" ".join(phrase) for phrase in phrases(told))
            for key, told in book["suggestions"].items()
        },
    )


def _turning(book: Mapping[str, Any], little: LittleWords) -> frozenset[str]:
    """Return the words that say when something holds, or take back what was said."""
    told = [phrases(book["where"][when]) for when in ("during", "before", "after")]
    begun = {phrase[0] for phrases in told for phrase in phrases}
    return frozenset(begun - little["weak_whens"]) | little["taken_back"]


def _contractions(book: Mapping[str, Any], vocabulary: set[str]) -> dict[str, Phrase]:
    """Return what is spelled otherwise elsewhere, words with dots typed without them as well."""
    told = pairs(book.get("dialect", "") + book["contractions"])
    taken = vocabulary | set(book["real"].split())
    words = [one for one in taken if one.isalpha() and not one.isascii()]
    ways = [str.maketrans(dict(zip("äöüß", to, strict=True))) for to in _DOTLESS]
    plain = {word.translate(way): (word,) for way in ways for word in words if len(word) > 3}
    found = {key: one for key, one in plain.items() if key not in taken}
    return found | {key: tuple(value.split()) for key, value in told}


_DOTLESS = (("a", "o", "u", "ss"), ("ae", "oe", "ue", "ß"), ("ae", "oe", "ue", "ss"))


def _vocatives(text: str) -> tuple[frozenset[Phrase], frozenset[Phrase]]:
    sure, others = lines(text)
    return frozenset(phrases(sure)), frozenset(phrases(f"{sure}, {others}"))


_WHERE_WORDS = (
    *("weak", "particles", "step_nouns", "no_steps", "no_places", "no_starts", "no_ends"),
    "stated",
)


def _whens(where: Mapping[str, str]) -> Mapping[str, tuple[tuple[Phrase, When], ...]]:
    """Return phrases that say when something holds, by the word they begin with."""
    found: dict[str, list[tuple[Phrase, When]]] = {}
    whens: tuple[When, ...] = ("before", "after", "during")
    for when in whens:
        for phrase in longest_first(where[when]):
            found.setdefault(phrase[0], []).append((phrase, when))
    return {first: tuple(ones) for first, ones in found.items()}


def _amounts(told: Mapping[str, str]) -> Mapping[str, tuple[tuple[Phrase, str], ...]]:
    """Return phrases about the last correction with their class, by their first word."""
    kinds = {phrase: kind for kind, listed in told.items() for phrase in phrases(listed)}
    begun = by_first_word(kinds)
    return {first: tuple((one, kinds[one]) for one in ones) for first, ones in begun.items()}


def _where(book: Mapping[str, Any]) -> dict[str, str]:
    return {"stepping": "", **book["where"]}
