"""What the tagger of slots looks at: traits of a word, of its neighbors, and of where it stands.

Traits are kept as hashes, so that those of neighbors and pairs are made by arithmetic alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from assistant.language.families import families
from assistant.language.frames import frames, spans_of
from assistant.language.naming import stem
from assistant.language.parsing import Hearing, texts_of
from assistant.language.words import Words

Hashes = NDArray[np.uint32]
NO_TRAITS: Hashes = np.zeros((0, 0), dtype=np.uint32)
_MIX = np.uint32(0x9E3779B1)
_EDGE = "<>"
_OWN, _CLASSES, _MARKS = 7, 3, 2
_WORD, _FAMILY, _CLASS = 0, 4, 7
_PAIRS = (
    (-1, 0, ((_WORD, _WORD), (_FAMILY, _FAMILY), (_CLASS, _FAMILY), (_WORD, _FAMILY))),
    (0, 1, ((_WORD, _WORD), (_FAMILY, _FAMILY), (_FAMILY, _CLASS), (_FAMILY, _WORD))),
    (-2, -1, ((_WORD, _WORD), (_CLASS, _CLASS))),
    (1, 2, ((_WORD, _WORD), (_CLASS, _CLASS))),
    (-1, 1, ((_WORD, _WORD), (_CLASS, _CLASS))),
)
"""Which neighbors are told together, and by which of their traits."""
_PAIRED, _FIRST, _SECOND, _THIRD = (np.uint32(salt) for salt in (7, 3, 5, 17))


def _neighbors() -> tuple[NDArray[np.int64], NDArray[np.int64], Hashes]:
    """Return how far away neighbors are of which traits are told, which, and their salts."""
    told = [
        (reach, trait, 101 + reach)
        for reach in range(-3, 4)
        for trait in (range(_OWN + _CLASSES + _MARKS) if abs(reach) < 2 else _FAR)
    ]
    reach, traits, salts = np.array(told).T
    return reach, traits, salts.astype(np.uint32)


def _together() -> tuple[tuple[NDArray[np.int64], ...], Hashes]:
    """Return of pairs how far away both are, which of their traits count, and their salts."""
    told = [
        (a, b, x, y, 211 + 10 * a + b + 1000 * x + 77 * y)
        for a, b, kinds in _PAIRS
        for x, y in kinds
    ]
    *found, salts = np.array(told).T
    return tuple(found), salts.astype(np.uint32)


_FAR = (_WORD, _FAMILY, _CLASS)
_NEAR, (_BOTH, _BOTH_SALTS) = _neighbors(), _together()


def named(text: str) -> np.uint32:
    """Return the hash of a trait."""
    return np.uint32(crc32(text.encode()))


def mixed(traits: Hashes, salt: Hashes | np.uint32) -> Hashes:
    """Return traits as they are told apart by what they belong to."""
    found = (traits ^ salt) * _MIX
    return np.asarray(found ^ (found >> np.uint32(15)), dtype=np.uint32)


def word_traits(words: Words, hearing: Hearing) -> Hashes:
    """Return what tells which slot each word is in, an array of shape (words, traits).

    Parameters
    ----------
    words : tuple of Word
        A clause, spelling repaired.
    hearing : Hearing
        Its names and question are looked at.
    """
    size = len(words)
    alone = _alone(words, hearing)
    at = np.arange(1, size + 1)[:, None]
    near = mixed(alone[np.clip(at + _NEAR[0], 0, size + 1), _NEAR[1]], _NEAR[2])
    left, right = (np.clip(at + reach, 0, size + 1) for reach in (_BOTH[0], _BOTH[1]))
    pairs = mixed(alone[left, _BOTH[2]], _PAIRED) + alone[right, _BOTH[3]]
    before = mixed(alone[at - 1, _WORD], _FIRST) + alone[at, _WORD]
    three = mixed(mixed(before, _SECOND) + alone[at + 1, _WORD], _THIRD)
    listening = hearing.listening
    asked = named(f"? {listening.asked} {listening.stage[0]}")
    place = mixed(alone[1:-1, [_WORD, _FAMILY]], asked)
    told = (near, mixed(pairs, _BOTH_SALTS), three, place, np.full((size, 1), asked), _ends(size))
    return np.concatenate(told, axis=1, dtype=np.uint32)


def _alone(words: Words, hearing: Hearing) -> Hashes:
    """Return what each word is by itself, the edges of the clause included."""
    texts, listening = texts_of(words), hearing.listening
    found = np.zeros((len(words) + 2, _OWN + _CLASSES + _MARKS), dtype=np.uint32)
    found[:, :_OWN] = [_own(one, hearing.language) for one in (_EDGE, *texts, _EDGE)]
    names = {w for name in (*listening.subtasks, *listening.objects) for w in name.lower().split()}
    known = hearing.book.vocabulary
    for at, (word, classes) in enumerate(zip(words, _classes(texts, hearing), strict=True)):
        for n, name in enumerate(sorted(classes)[:_CLASSES]):
            found[at + 1, _OWN + n] = _class(name)
        found[at + 1, _OWN + _CLASSES] = named(f"m {word.broken} {word.text in names}")
        found[at + 1, _OWN + _CLASSES + 1] = named(f"k {not word.said} {word.text in known}")
    return found


@lru_cache(maxsize=8192)
def _own(text: str, language: str) -> tuple[int, ...]:
    """Return hashes of the word, its stem, ending, beginning, families and length."""
    small, large = families(text, language)
    told = (
        f"w {text}",
        f"s {stem(text)}",
        f"e {text[-3:]}" if len(text) > 4 else f"e {text[-2:]}",
        f"p {text[:4]}",
        f"f {small}" if small >= 0 else f"f {text[-2:]}",
        f"g {large}" if large >= 0 else "g",
        "d" if text[:1].isdigit() else f"l {min(len(text), 6)}",
    )
    return tuple(int(named(one)) for one in told)


@lru_cache(maxsize=1024)
def _class(name: str) -> int:
    return int(named(f"c {name}"))


@lru_cache(maxsize=64)
def _ends(size: int) -> Hashes:
    """Return how far each word is from either end."""
    told = [(f"b {min(n, 3)}", f"b- {min(size - n, 3)}") for n in range(size)]
    return np.array([[named(a), named(b)] for a, b in told], dtype=np.uint32).reshape(size, 2)


def _classes(texts: Sequence[str], hearing: Hearing) -> list[set[str]]:
    """Return the classes of the phrasebook each word stands in."""
    found: list[set[str]] = [set() for _ in texts]
    known = frames(hearing.language)
    if known is None:
        return found
    for name, spans in spans_of(tuple(texts), known, hearing.book.numbers).items():
        for start, end in spans:
            for at in range(start, end):
                found[at].add(name)
    return found
