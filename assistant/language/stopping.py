"""Stop words, looked for in raw input while the arm moves: no grammar, no context.

Anything that could be a stop word is one, "don't stop" and misspellings included. A false
stop costs a start; a missed one costs more.
"""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from functools import cache
from typing import Any, cast

from rapidfuzz.distance import OSA

from assistant.language.lists import listed
from assistant.language.little_words import folder_of
from assistant.plain_yaml import read_file

_WORDS = re.compile(r"[^\W\d_]+")
COMMON = "english"
"""The language whose stop words hold beside those of every other."""


@dataclass(frozen=True, eq=False)
class StopWords:
    """What stops the arm in a language.

    Parameters
    ----------
    stops, within, phrases : tuple of str
        Words, parts of words, and stretches of text that stop.
    ending : str
        Taken off before parts are looked for: a holder does not halt.
    others : frozenset of str
        Real words one letter away from a stop word.
    containing : tuple of str
        Beginnings of words that only contain one.
    """

    stops: tuple[str, ...]
    within: tuple[str, ...]
    ending: str
    phrases: tuple[str, ...]
    others: frozenset[str]
    containing: tuple[str, ...]


@cache
def stop_words(language: str) -> StopWords:
    """Return what stops the arm: the words of a language and those that hold everywhere."""
    told = [_told(name) for name in dict.fromkeys((folder_of(language).name, COMMON))]

    def all_of(key: str) -> tuple[str, ...]:
        return tuple(one for page in told for one in listed(page[key]))

    return StopWords(
        stops=all_of("stops"),
        within=all_of("within"),
        ending=next(one for one in all_of("ending")),
        phrases=all_of("phrases"),
        others=frozenset(all_of("others")),
        containing=all_of("containing"),
    )


def _told(language: str) -> dict[str, Any]:
    page = folder_of(language) / "stop_words.yaml"
    return cast("dict[str, Any]", read_file(page)[0].value)


def has_stop_word(text: str, language: str = COMMON) -> bool:
    """Tell whether raw input holds a stop word, however it is spelled or meant."""
    known = stop_words(language)
    plain = unicodedata.normalize("NFKC", text).lower().replace("\u2019", "'")
    plain = re.sub(r"(?<=[^\W\d_])0(?=[^\W\d_])", "o", plain)
    together = " ".join(plain.split())
    if any(phrase in together for phrase in known.phrases):
        return True
    return any(_is_stop(word, known) for word in _WORDS.findall(plain))


def _is_stop(word: str, known: StopWords) -> bool:
    if known.containing and word.startswith(known.containing):
        return False
    stem = word.removesuffix(known.ending)
    if any(part in stem for part in known.within) or word in known.stops:
        return True
    if word in known.others:
        return False
    once = _once(word)
    return any(
        once == _once(stop)
        or (len(word) >= 3 and word[0] == stop[0] and OSA.distance(word, stop) <= 1)
        or (
            len(word) == len(stop)
            and sorted(word) == sorted(stop)
            and OSA.distance(word, stop) <= 2
        )
        for stop in known.stops
    )


def _once(word: str) -> str:
    """Return a word with repeated letters once: "stoooop"."""
    return re.sub(r"(.)\1+", r"\1", word)
