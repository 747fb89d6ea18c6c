"""How likely a teacher says these words rather than others: which words follow which.

A recognizer knows what people say; teachers of robots speak of little else but steps, moves and
things. Words are counted alone, in pairs and in triples (interpolated after Witten and Bell), in
what imagined teachers said. The counts are made by `tests/benchmarks/fit_wording.py` and shipped
as ``wording.npz``; another language has none.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import as_file, files
from math import log

import numpy as np
from numpy.typing import NDArray

ORDER = 3
UNSEEN = 0
"""Stands for all words that were never counted."""
EDGE = 1
"""Stands for the beginning and the end of what is said."""
LEAST = 1e-3
"""A word is no less likely: things are named as the teacher likes."""
RARE = 1e-5
Counts = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Wording:
    """Counts of words and of words in a row.

    Parameters
    ----------
    words : dict of str to int
        Numbers of the words known, from 2.
    keys : tuple of array of int
        For one word, two, and three in a row: their numbers in one, in order.
    counts : tuple of array of int
        How often each was said.
    """

    words: dict[str, int]
    keys: tuple[Counts, ...]
    counts: tuple[Counts, ...]

    def likelihood(self, text: str) -> float:
        """Return the natural logarithm of how likely a teacher says this and no more."""
        told = self.numbered(text)
        return sum(log(max(self._next(told[: at + 1]), LEAST)) for at in range(2, len(told)))

    def numbered(self, text: str) -> tuple[int, ...]:
        """Return the numbers of a text's words, with its edges."""
        words = (self.words.get(word, UNSEEN) for word in text.split())
        return (EDGE, EDGE, *words, EDGE)

    def _next(self, told: Sequence[int]) -> float:
        """Return how likely the last number follows those before it."""
        likely = RARE
        for many in range(ORDER):
            before = self._key(told[len(told) - 1 - many : -1])
            said, kinds = self._behind(before, many)
            if not said:
                break
            times = self._times(before * self.base + told[-1], many)
            likely = (times + kinds * likely) / (said + kinds)
        return likely

    @property
    def base(self) -> int:
        """How many numbers there are: keys are written in this base."""
        return len(self.words) + 2

    def _key(self, told: Iterable[int]) -> int:
        key = 0
        for one in told:
            key = key * self.base + one
        return key

    def _behind(self, before: int, many: int) -> tuple[float, int]:
        """Return how often anything followed, and how many different words did."""
        span = np.searchsorted(self.keys[many], (before * self.base, (before + 1) * self.base))
        return float(self.counts[many][span[0] : span[1]].sum()), int(span[1] - span[0])

    def _times(self, key: int, many: int) -> float:
        at = int(np.searchsorted(self.keys[many], key))
        found = at < len(self.keys[many]) and self.keys[many][at] == key
        return float(self.counts[many][at]) if found else 0.0


def counted(texts: Iterable[str], least: int = 1) -> Wording:
    """Return the wording of what was said.

    Parameters
    ----------
    texts : iterable of str
        Plain words.
    least : int
        Words said less often stay unseen.
    """
    told = [text.split() for text in texts]
    said, times = np.unique([word for words in told for word in words], return_counts=True)
    known = [str(word) for word, often in zip(said, times, strict=True) if often >= least]
    words = {word: at + 2 for at, word in enumerate(known)}
    base = len(words) + 2
    keys: list[list[int]] = [[] for _ in range(ORDER)]
    for one in told:
        numbers = (EDGE, EDGE, *(words.get(word, UNSEEN) for word in one), EDGE)
        for at in range(2, len(numbers)):
            key = 0
            for many in range(ORDER):
                key += numbers[at - many] * base**many
                keys[many].append(key)
    pairs = [np.unique(np.array(one, dtype=np.int64), return_counts=True) for one in keys]
    return Wording(
        words,
        tuple(key for key, _ in pairs),
        tuple(np.asarray(count, dtype=np.int64) for _, count in pairs),
    )


@cache
def wording(language: str = "english") -> Wording | None:
    """Return the wording of a language's teachers, None where none was counted."""
    if language != "english":
        return None
    with as_file(files(__package__) / "wording.npz") as path, np.load(path) as kept:
        words = {word: at + 2 for at, word in enumerate(str(kept["words"]).split())}
        keys = tuple(np.cumsum(kept[f"steps_{many}"], dtype=np.int64) for many in range(ORDER))
        return Wording(words, keys, tuple(kept[f"counts_{many}"] for many in range(ORDER)))


def arrays(told: Wording) -> dict[str, NDArray[np.generic]]:
    """Return what `wording` reads; keys as steps from one to the next, which pack well."""
    steps = {f"steps_{at}": np.diff(keys, prepend=0) for at, keys in enumerate(told.keys)}
    counts = {
        f"counts_{at}": np.minimum(one, 65535).astype(np.uint16)
        for at, one in enumerate(told.counts)
    }
    return {"words": np.array(" ".join(told.words)), **steps, **counts}
