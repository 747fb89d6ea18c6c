"""Matches free names of steps and objects to those the task knows."""

from __future__ import annotations

import re
from collections.abc import Sequence

from assistant.language.numbers import NumberWords

_ARTICLES = frozenset(
    ["the", "a", "an", "this", "that", "my", "our", "your", "its", "these", "those", "both"]
)
_STEP = frozenset(
    ["step", "subtask", "part", "primitive", "phase", "action", "one", "stage", "number"]
)
_LAST = frozenset(("last", "final"))
_GENERIC = frozenset(
    [
        "object",
        "target",
        "it",
        "thing",
        "onto",
        "on",
        "to",
        "of",
        "the",
        "a",
        "an",
        "and",
        "with",
        "into",
        "from",
    ]
)
_ENDINGS = re.compile(r"(?:ing|ed|es|s|e)$")


def without_article(
    words: Sequence[str], articles: frozenset[str] = frozenset()
) -> tuple[str, ...]:
    """Return the words without articles in front: those of English and `articles`."""
    at = 0
    while at < len(words) - 1 and words[at] in _ARTICLES | articles:
        at += 1
    return tuple(words[at:])


def known_name(words: Sequence[str], names: Sequence[str], numbers: NumberWords) -> str | None:
    """Return the known name the words refer to, by place or by likeness; None if unclear."""
    bare = without_article(words, numbers.articles)
    if not names or not bare:
        return None
    placed = _by_place(bare, names, numbers)
    if placed is not None:
        return placed
    spoken = " ".join(bare)
    if spoken in names:
        return spoken
    # Of equally like names the last is taken: parts are told after what they are part of.
    scores = [(_likeness(bare, name), _shared(bare, name), at) for at, name in enumerate(names)]
    best, shared, at = max(scores)
    near = [one for one in scores if one[0] > best - 0.04 and one[1] >= shared and one[2] != at]
    if best < 0.5 or any(not _same_content(names[one[2]], names[at]) for one in near):
        return None
    return names[at]


def _by_place(words: Sequence[str], names: Sequence[str], numbers: NumberWords) -> str | None:
    rest = [word for word in words if word not in _STEP]
    if len(rest) != 1 or (len(words) == 1 and words[0] not in numbers.ordinals):
        return None
    if rest[0] in _LAST:
        return names[-1]
    place = numbers.ordinal(rest, 0) or numbers.number(rest, 0)
    if place is None or not 1 <= place[0] <= len(names):
        return None
    return names[int(place[0]) - 1]


def _likeness(words: Sequence[str], name: str) -> float:
    said, known = _stems(words), _stems(name.lower().split())
    if not said or not known:
        return 0.0
    common = said & known
    if not common:
        return 0.0
    return len(common) / len(said) * 0.75 + 0.25 * len(common) / len(known)


def _shared(words: Sequence[str], name: str) -> int:
    """Return how many words, small ones too, are those of the name."""
    return len({stem(word) for word in words} & {stem(word) for word in name.lower().split()})


def _same_content(name: str, other: str) -> bool:
    return _stems(name.lower().split()) == _stems(other.lower().split())


def _stems(words: Sequence[str]) -> set[str]:
    content = [word for word in words if word not in _GENERIC and word not in _STEP]
    return {stem(word) for word in (content or words)}


def stem(word: str) -> str:
    """Return a word without its ending, so that "moves" and "moving" are alike."""
    found = _ENDINGS.sub("", word) if len(word) > 3 else word
    if len(found) > 3 and found[-1] == found[-2]:
        found = found[:-1]
    return found
