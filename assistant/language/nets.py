"""Two small nets over vectors of words: which act a clause is, and which slot each word is in.

Beside the linear models, which know words and pairs of words one by one, these know words by
what they mean, and so those in whose place a speaker takes others. Both look at windows of
neighboring words. They are fitted by `tests/benchmarks/fit_language.py` and `fit_slots.py`.

Source: convolutional nets for sentences (Kim 2014), for tags (Collobert and others 2011).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from assistant.language.families import row_of, vectors

Scores = NDArray[np.float32]
OWN = 1 << 11
"""Rows learned for words themselves, by a hash of their text; the first is no word's."""
ACT_WINDOWS = (1, 2, 3)
"""Words seen together by the net of acts."""
TAG_REACH = 2
"""How far to either side the net of tags sees, in each of its two layers."""
MARKS = 3


@dataclass(frozen=True, slots=True, eq=False)
class Net:
    """A net's weights by name, and what it is told beside the words.

    Parameters
    ----------
    context : tuple of str
        What may hold for a clause: its question, its stage, its kind.
    """

    weights: Mapping[str, Scores]
    context: tuple[str, ...]


def told_beside(asked: str | None, stage: str, kind: str = "") -> tuple[str, ...]:
    """Return what holds for a clause beside its words."""
    return f"?{asked}", f"!{stage}", f"={kind}"


def context_of(told: Iterable[str], net: Net) -> Scores:
    """Return what holds for a clause as a net takes it in."""
    found = np.zeros(len(net.context), np.float32)
    found[[net.context.index(one) for one in told if one in net.context]] = 1.0
    return found


@lru_cache(maxsize=1 << 14)
def own_row(word: str) -> int:
    """Return the row a net has learned for a word; all numbers in digits share one."""
    return 1 + crc32(("#" if word[:1].isdigit() else word).encode()) % (OWN - 1)


def inputs(words: Sequence[str], net: Net, language: str, marks: Scores | None = None) -> Scores:
    """Return what a net takes in of each word, an array of shape (words, n)."""
    known = vectors(language)
    parts = [
        known[[row_of(one, language) for one in words]],
        net.weights["own"][[own_row(one) for one in words]],
    ]
    return np.concatenate(parts if marks is None else [*parts, marks], axis=1)


def windows(told: Scores, width: int, edge: int) -> Scores:
    """Return neighbors side by side, nothing beyond the edges: (..., words, n) to wider rows."""
    *many, size, wide = told.shape
    padded = np.zeros((*many, size + 2 * edge, wide), np.float32)
    padded[..., edge : edge + size, :] = told
    count = size + 2 * edge - width + 1
    return np.concatenate([padded[..., at : at + count, :] for at in range(width)], axis=-1)


def act_odds(
    words: Sequence[str], asked: str | None, stage: str, net: Net, language: str
) -> Scores:
    """Return how likely each label is for a clause, which sum to one."""
    if not words:
        words = ("",)
    weights, told = net.weights, inputs(words, net, language)
    peaks = [
        (windows(told, width, min(width - 1, 1)) @ weights[f"see{width}"]).max(axis=0)
        + weights[f"see{width}_from"]
        for width in ACT_WINDOWS
    ]
    context = context_of(told_beside(asked, stage), net)
    seen = np.concatenate([np.maximum(np.concatenate(peaks), 0.0), context])
    inner = np.maximum(seen @ weights["inner"] + weights["inner_from"], 0.0)
    scores = inner @ weights["label"] + weights["label_from"] + context @ weights["context"]
    odds = np.exp(scores - scores.max())
    return np.asarray(odds / odds.sum(), dtype=np.float32)


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """What the net of tags sees of a clause before its kind is known."""

    told: Scores
    first: Scores
    beside: tuple[str, ...]


def seen_by(
    words: Sequence[str], marks: Scores, asked: str | None, stage: str, net: Net, language: str
) -> Seen:
    """Return what is the same for all kinds of act a clause may be."""
    told = inputs(words, net, language, marks)
    first = windows(told, 2 * TAG_REACH + 1, TAG_REACH) @ net.weights["near"]
    return Seen(told, first, told_beside(asked, stage))


def tag_scores(seen: Seen, kind: str, net: Net) -> Scores:
    """Return what speaks for each tag of each word, an array of shape (words, tags)."""
    weights = net.weights
    context = context_of((*seen.beside, f"={kind}"), net)
    near = np.maximum(seen.first + context @ weights["near_context"], 0.0)
    far = windows(near, 2 * TAG_REACH + 1, TAG_REACH) @ weights["far"]
    far = np.maximum(far + context @ weights["far_context"], 0.0)
    told = np.concatenate([near, far, seen.told], axis=1)
    return np.asarray(told @ weights["tag"] + context @ weights["tag_context"])


def packed(net: Net, name: str) -> dict[str, Any]:
    """Return a net as it is kept: weights in steps of a 127th of the largest."""
    found: dict[str, Any] = {f"{name}:context": np.array(net.context)}
    for key, told in net.weights.items():
        scale = float(np.abs(told).max()) / 127 or 1.0
        found[f"{name}.{key}"] = np.round(told / scale).astype(np.int8)
        found[f"{name}.{key}.scale"] = np.float32(scale)
    return found


def unpacked(file: Mapping[str, Any], name: str) -> Net | None:
    """Return the net that is kept under a name; None if there is none."""
    if f"{name}:context" not in file:
        return None
    start = f"{name}."
    keys = [key for key in file if key.startswith(start) and f"{key}.scale" in file]
    weights = {
        key.removeprefix(start): file[key].astype(np.float32) * np.float32(file[f"{key}.scale"])
        for key in keys
    }
    return Net(weights, tuple(str(one) for one in file[f"{name}:context"]))
