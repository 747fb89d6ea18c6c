"""Lists of words as a phrasebook writes them: between commas, one a line, or in pairs."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

Phrase = tuple[str, ...]


def lines(text: str) -> list[str]:
    """Return the lines that hold anything."""
    return [line.strip() for line in text.splitlines() if line.strip()]


def pairs(text: str) -> list[tuple[str, str]]:
    """Return what stands on both sides of ``=`` in each line."""
    parts = (line.partition(" = ") for line in lines(text))
    return [(bare(key), value.strip()) for key, _, value in parts]


def bare(key: str) -> str:
    """Return a key without its quotes."""
    told = key.strip()
    return told[1:-1] if len(told) > 2 and told[0] == told[-1] == "'" else told


def listed(text: str) -> tuple[str, ...]:
    """Return what stands between commas, each with its own spaces."""
    return tuple(one.strip() for one in text.split(",") if one.strip())


def phrases(text: str) -> list[Phrase]:
    """Return the phrases between commas."""
    joined = " ".join(text.split())
    return [tuple(phrase.split()) for phrase in joined.split(",") if phrase.strip()]


def single(text: str) -> frozenset[str]:
    """Return the phrases of one word."""
    return frozenset(phrase[0] for phrase in phrases(text) if len(phrase) == 1)


def longest_first(text: str) -> tuple[Phrase, ...]:
    """Return the phrases between commas, the longest first."""
    return tuple(sorted(phrases(text), key=len, reverse=True))


def phrase_words(phrases: Iterable[Phrase]) -> set[str]:
    """Return every word of some phrases."""
    return {word for phrase in phrases for word in phrase}


def by_first_word(phrases: Iterable[Phrase]) -> Mapping[str, tuple[Phrase, ...]]:
    """Return phrases by the word they begin with, the longest first."""
    found: dict[str, list[Phrase]] = {}
    for phrase in sorted(phrases, key=len, reverse=True):
        found.setdefault(phrase[0], []).append(phrase)
    return {word: tuple(ones) for word, ones in found.items()}
