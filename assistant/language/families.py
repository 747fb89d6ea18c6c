"""Families of words that mean alike, so that a word nobody listed is no stranger.

They are neighbors in the vectors a sentence model gives to single words, grouped finely and
coarsely by `tests/benchmarks/fit_families.py` and shipped as ``families.npz`` of a language,
beside the vectors of common words along their first axes.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from assistant.language.phrasebook import LANGUAGES

NONE = (-1, -1)
_NUMBER = "seven"
LENGTH = 2.0
"""How long vectors are."""


def families(word: str, language: str) -> tuple[int, int]:
    """Return the small and the large family a word belongs to; -1 for none."""
    return _known(language).get(word, NONE)


@lru_cache(maxsize=1 << 14)
def row_of(word: str, language: str) -> int:
    """Return the row of a word's vector; of an unknown word that without its ending, or zero."""
    rows = _rows(language)
    if word[:1].isdigit():
        return rows.get(_NUMBER, 0)
    return rows.get(word) or rows.get(word.removesuffix("s"), 0)


@cache
def vectors(language: str) -> NDArray[np.float32]:
    """Return the vectors of words, an array of shape (words, n); the first is no word's."""
    path = _path(language)
    if not path.exists():
        return np.zeros((1, 0), np.float32)
    with np.load(path) as file:
        points = file["points"].astype(np.float32)
    points *= LENGTH / np.linalg.norm(points, axis=1, keepdims=True)
    return np.concatenate([np.zeros((1, points.shape[1]), np.float32), points])


def _path(language: str) -> Path:
    return Path(__file__).parent / LANGUAGES[language.lower()] / "families.npz"


@cache
def _rows(language: str) -> Mapping[str, int]:
    count = len(vectors(language)) - 1
    return {word: at + 1 for at, word in enumerate(list(_known(language))[:count])}


@cache
def _known(language: str) -> Mapping[str, tuple[int, int]]:
    path = _path(language)
    if not path.exists():
        return {}
    with np.load(path) as file:
        both = zip(file["small"].tolist(), file["large"].tolist(), strict=True)
        return dict(zip(str(file["words"]).split(), both, strict=True))
