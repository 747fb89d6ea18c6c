"""Short commands of the phrasebook spelled out, to look up which sound like what was heard.

A recognizer that misheard two words of noise seldom lists the right ones among its readings.
What a teacher may say is known: the phrases nearest by sound are weighed beside the readings.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import cast

from rapidfuzz import process
from rapidfuzz.distance import Levenshtein

from assistant.language.hints import hints
from assistant.language.phrasebook import phrasebook
from assistant.language.templates import Choice, Node, Phrases
from assistant.shells.voice.phonemes import distance, phonemes

MOST_WORDS = 2
ALIKE = 0.4
LITTLE = frozenset(("and", "an", "on", "in", "onto", "into", "to", "end", "at", "under"))
"""Little words that are heard for each other."""
Words = tuple[str, ...]


def near(heard: str, count: int, language: str = "english") -> tuple[str, ...]:
    """Return so many short commands that sound most like what was heard, the nearest first."""
    phrases, sounds = _bank(language)
    found = process.extract(
        letters(heard), sounds, scorer=Levenshtein.normalized_similarity, limit=count
    )
    return tuple(phrases[at] for _, _, at in found)


def named(heard: str, things: tuple[str, ...], count: int) -> tuple[str, ...]:
    """Return so many names of steps, an action and a thing, that sound most like what was heard."""
    phrases, sounds = _names(things)
    found = process.extract(
        letters(heard), sounds, scorer=Levenshtein.normalized_similarity, limit=count
    )
    return tuple(phrases[at] for _, _, at in found)


def sounding(texts: Sequence[str], heard: Sequence[str], least: float) -> tuple[str, ...]:
    """Return those texts that sound like anything that was heard.

    Parameters
    ----------
    texts, heard : sequence of str
    least : float
        How alike at least, in [0, 1].
    """
    sounds = tuple(letters(one) for one in heard)
    like = Levenshtein.normalized_similarity
    return tuple(text for text in texts if any(like(letters(text), one) >= least for one in sounds))


@cache
def _names(things: tuple[str, ...]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    told = {
        name
        for entry in hints("actions", "english")
        for phrase in entry["phrases"]
        for thing in ("", *things)
        for name in _with_thing(phrase, thing)
    }
    phrases = tuple(sorted(told))
    return phrases, tuple(letters(phrase) for phrase in phrases)


def _with_thing(phrase: str, thing: str) -> Iterator[str]:
    """Yield an action's phrase with the thing it concerns: "move block up", "move up block"."""
    first, gap, last = (part.strip() for part in phrase.partition("..."))
    yield " ".join(f"{first} {last} {thing}".split())
    if gap and thing:
        yield f"{first} {thing} {last}"


def mended(heard: str, words: Sequence[str]) -> tuple[str, ...]:
    """Return what was heard with one word changed into one of `words` that sounds alike."""
    told = heard.split()
    return tuple(
        " ".join((*told[:at], word, *told[at + 1 :]))
        for at, one in enumerate(told)
        for word in words
        if word != one and distance(phonemes(one), phonemes(word)) <= ALIKE
    )


def related(heard: str, things: Sequence[str], relations: Sequence[str]) -> tuple[str, ...]:
    """Return what was heard with one little word between two things changed.

    Parameters
    ----------
    heard : str
    things : sequence of str
        Words for things.
    relations : sequence of str
        What may stand between two things here, such as "on" in a step's name.
    """
    told = heard.split()
    return tuple(
        " ".join((*told[:at], relation, *told[at + 1 :]))
        for at in range(1, len(told) - 1)
        if told[at] in LITTLE and told[at - 1] in things and _names_thing(told[at + 1 :], things)
        for relation in relations
        if relation != told[at]
    )


def _names_thing(words: Sequence[str], things: Sequence[str]) -> bool:
    bare = [word for word in words[:2] if word not in ("the", "a")]
    return bool(bare) and bare[0] in things


def short_commands(language: str = "english") -> tuple[str, ...]:
    """Return the commands of the phrasebook that have a word or two."""
    return _bank(language)[0]


@cache
def _bank(language: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    told = {
        " ".join(words)
        for sentence in phrasebook(language).sentences
        if sentence.act != "unknown"
        for words in _spelled(sentence.nodes, MOST_WORDS)
        if words
    }
    phrases = tuple(sorted(told))
    return phrases, tuple(letters(phrase) for phrase in phrases)


@cache
def letters(phrase: str) -> str:
    """Return the phonemes of a phrase, one letter each."""
    return "".join(_letter(sound) for sound in phonemes(phrase))


@cache
def _letter(sound: str) -> str:
    # Two letters of a phoneme's name tell all of them apart.
    first, second = (*sound, "_")[:2]
    return chr(256 + 128 * (ord(first) % 32) + ord(second) % 128)


def _spelled(nodes: Sequence[Node], room: int) -> Iterator[Words]:
    """Yield what a template stands for in at most `room` words; open slots stand for nothing."""
    if not nodes:
        yield ()
        return
    for begun in _one(nodes[0], room):
        for rest in _spelled(nodes[1:], room - len(begun)):
            yield (*begun, *rest)


def _one(node: Node, room: int) -> Iterator[Words]:
    match node:
        case str():
            if room:
                yield (node,)
        case Phrases():
            yield from _branches(node.tree, room)
        case Choice():
            for way in node.ways:
                yield from _spelled(way, room)
        case _:
            return


def _branches(tree: Mapping[str, object], room: int) -> Iterator[Words]:
    for word, below in tree.items():
        if not word:
            yield ()
        elif room:
            for rest in _branches(cast("Mapping[str, object]", below), room - 1):
                yield (word, *rest)
