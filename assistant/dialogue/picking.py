"""Which of the corrections a sentence means: by number, the last ones, all, or by its words."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from assistant.dialogue.directions import direction_of
from assistant.dialogue.knowledge import Knowledge
from assistant.language.hints import hints, mentions
from assistant.model.feedback import Feedback


@dataclass(frozen=True, slots=True)
class Picked:
    """What a sentence tells of which corrections are meant.

    Parameters
    ----------
    numbers : tuple of int
    last : bool
        The last one, or as many of the last as the first number says.
    every : bool
    words : frozenset of str
        Others that describe the ones meant: "the clockwise one".
    """

    numbers: tuple[int, ...]
    last: bool
    every: bool
    words: frozenset[str]

    def of(self, count: int) -> tuple[int, ...]:
        """Return the positions meant, from 1, of `count` corrections; empty if none is told."""
        if self.last:
            many = self.numbers[0] if self.numbers else 1
            return tuple(range(max(count - many, 0) + 1, count + 1))
        if self.every:
            return tuple(range(1, count + 1))
        return tuple(sorted(set(self.numbers)))


def picked(text: str, language: str) -> Picked:
    """Return which corrections a sentence tells of."""
    plain = text.lower()
    for part in ("take_back", "bring_back"):
        plain = _without(plain, hints(part, language))
    words = re.findall(r"[^\W\d_]+|\d+", plain)
    value: dict[str, int] = {**hints("numbers", language), **hints("ordinals", language)}
    # "The one", "that one": a number only behind a word that numbers, as in "number one".
    idle, numbering = set(hints("picking", language)), set(hints("numbering", language))
    told = [
        int(word) if word.isdigit() else value.get(word, 0)
        for before, word in zip(["", *words], words, strict=False)
        if word not in idle or before in numbering
    ]
    others = frozenset(word for word in set(words) - idle - set(value) if not word.isdigit())
    return Picked(
        tuple(number for number in told if number > 0),
        mentions(plain, hints("latest", language)),
        mentions(plain, hints("every", language)),
        others - _named_in(("corrections", "latest", "every"), language),
    )


def _without(text: str, phrases: Sequence[str]) -> str:
    """Return a text without the words of phrases; ``...`` in them stands for words kept."""
    words = {word for phrase in phrases for word in phrase.lower().split() if word != "..."}
    return " ".join(word for word in re.findall(r"[\w']+", text) if word not in words)


def _named_in(parts: Sequence[str], language: str) -> frozenset[str]:
    said = (word for part in parts for one in hints(part, language) for word in one.split())
    return frozenset(said)


def described(known: Knowledge, given: Sequence[Feedback], words: frozenset[str]) -> list[int]:
    """Return the positions, from 1, of the corrections that all the words may be said of."""
    return [at for at, one in enumerate(given, 1) if words <= _words_of(known, one)]


def _words_of(known: Knowledge, feedback: Feedback) -> frozenset[str]:
    kinds: dict[str, list[str]] = hints("kinds_of_correction", known.language)
    goes = feedback.kind in ("translate", "rotate")
    way = direction_of(known, feedback) if goes else feedback.hand or ""
    told = (feedback.words, feedback.primitive, way, *kinds[feedback.kind])
    return frozenset(re.findall(r"[^\W\d_]+", " ".join(told).lower()))
