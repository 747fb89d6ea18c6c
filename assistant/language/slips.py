"""Misspelled words of names put right: "aproach the blok" tells of approaching the block.

A teacher's names are kept as typed; only what is read from them is read without slips.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache, lru_cache

from rapidfuzz import process
from rapidfuzz.distance import OSA

from assistant.language.hints import hints, matter
from assistant.language.phrasebook import phrasebook

SHORTEST = 4
"""Letters of the shortest word that is put right."""


def without_slips(text: str, names: Iterable[str] = (), language: str = "english") -> str:
    """Return a text whose unknown words are the words of actions and names nearest to them."""
    own = frozenset(word for name in names for word in re.findall(r"[^\W\d_]+", name.lower()))
    return re.sub(r"[^\W\d_]+", lambda found: _nearest(found.group(), own, language), text)


def stands(text: str, language: str = "english") -> str:
    """Return where a teacher stands: ``facing``, ``beside``, or empty if not told."""
    groups: dict[str, list[str]] = hints("facing", language)
    words = [word for phrases in groups.values() for phrase in phrases for word in phrase.split()]
    return matter(without_slips(text, words, language), "facing", language)


@cache
def _vocabulary(language: str) -> frozenset[str]:
    entries = (*hints("actions", language), *hints("guesses", language))
    phrases = [phrase for entry in entries for phrase in entry["phrases"]]
    phrases += [*hints("targets", language), *hints("compound", language)]
    return frozenset(word for phrase in phrases for word in re.findall(r"[^\W\d_]+", phrase))


@lru_cache(maxsize=4096)
def _nearest(word: str, own: frozenset[str], language: str) -> str:
    lowered = word.lower()
    book = phrasebook(language)
    known = _vocabulary(language) | own
    if len(word) < SHORTEST or lowered in known or lowered in book.real:
        return word
    if lowered in book.vocabulary:
        return word
    far = 1 if len(word) < 7 else 2
    found = process.extract(lowered, known, scorer=OSA.distance, score_cutoff=far, limit=3)
    near = [(distance, one) for one, distance, _ in found if one[0] == lowered[0]]
    return min(near)[1] if near else word
