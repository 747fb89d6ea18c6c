"""Families of words that mean alike, so that a word nobody listed is no stranger.

They are neighbors in the vectors a sentence model gives to single words, grouped finely and
coarsely by `tests/benchmarks/fit_families.py` and shipped as ``families.npz`` of a language.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path

import numpy as np

from assistant.language.phrasebook import LANGUAGES

NONE = (-1, -1)


def families(word: str, language: str) -> tuple[int, int]:
    """Return the small and the large family a word belongs to; -1 for none."""
    return _known(language).get(word, NONE)


@cache
def _known(language: str) -> Mapping[str, tuple[int, int]]:
    path = Path(__file__).parent / LANGUAGES[language.lower()] / "families.npz"
    if not path.exists():
        return {}
    with np.load(path) as file:
        both = zip(file["small"].tolist(), file["large"].tolist(), strict=True)
        return dict(zip(str(file["words"]).split(), both, strict=True))
