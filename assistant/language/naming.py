"""Matches free names of steps and objects to those the task knows."""

from __future__ import annotations

from collections.abc import Sequence

from assistant.language.little_words import LittleWords, little_words
from assistant.language.phrasebook import Phrasebook


def without_article(words: Sequence[str], articles: frozenset[str]) -> tuple[str, ...]:
    """Return the words without articles and the like in front."""
    at = 0
    while at < len(words) - 1 and words[at] in articles:
        at += 1
    return tuple(words[at:])


def known_name(words: Sequence[str], names: Sequence[str], book: Phrasebook) -> str | None:
    """Return the known name the words refer to, by place or by likeness; None if unclear."""
    bare = without_article(words, book.little["determiners"] | book.numbers.articles)
    if not names or not bare:
        return None
    placed = _by_place(bare, names, book)
    if placed is not None:
        return placed
    spoken = " ".join(bare)
    if spoken in names:
        return spoken
    # Of equally like names the last is taken: parts are told after what they are part of.
    little = book.little
    scores = [
        (_likeness(bare, name, little), _shared(bare, name, little), at)
        for at, name in enumerate(names)
    ]
    best, shared, at = max(scores)
    near = [one for one in scores if one[0] > best - 0.04 and one[1] >= shared and one[2] != at]
    if best < 0.5 or any(
        _content(names[one[2]], little) != _content(names[at], little) for one in near
    ):
        return None
    return names[at]


def _by_place(words: Sequence[str], names: Sequence[str], book: Phrasebook) -> str | None:
    numbers, little = book.numbers, book.little
    rest = [word for word in words if word not in little["step_nouns"]]
    if len(rest) != 1 or (len(words) == 1 and words[0] not in numbers.ordinals):
        return None
    if rest[0] in little["last_ones"]:
        return names[-1]
    place = numbers.ordinal(rest, 0) or numbers.number(rest, 0)
    if place is None or not 1 <= place[0] <= len(names):
        return None
    return names[int(place[0]) - 1]


def _likeness(words: Sequence[str], name: str, little: LittleWords) -> float:
    said, known = _stems(_parted(" ".join(words)), little), _content(name, little)
    if not said or not known:
        return 0.0
    common = said & known
    if not common:
        return 0.0
    return len(common) / len(said) * 0.75 + 0.25 * len(common) / len(known)


def _shared(words: Sequence[str], name: str, little: LittleWords) -> int:
    """Return how many words, small ones too, are those of the name."""
    told = name.lower().split()
    return len({_stem(word, little) for word in words} & {_stem(word, little) for word in told})


def _content(name: str, little: LittleWords) -> set[str]:
    return _stems(_parted(name.lower()), little)


def _parted(name: str) -> list[str]:
    """Return the words of a name, those of a code apart: "v block" may be said of "v_block"."""
    return name.replace("_", " ").split()


def _stems(words: Sequence[str], little: LittleWords) -> set[str]:
    empty = little["generic"] | little["step_nouns"]
    content = [word for word in words if word not in empty]
    return {_stem(word, little) for word in (content or words)}


def stem(word: str, language: str = "english") -> str:
    """Return a word without its ending, so that "moves" and "moving" are alike."""
    return _stem(word, little_words(language))


def _stem(word: str, little: LittleWords) -> str:
    ending = next((one for one in little.stems if word.endswith(one)), "")
    found = word.removesuffix(ending) if len(word) > 3 else word
    if len(found) > 3 and found[-1] == found[-2]:
        found = found[:-1]
    return found
