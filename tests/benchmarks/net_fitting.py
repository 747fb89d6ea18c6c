"""Fitting of the two small nets: steps of Adam over sentences of like length.

Source: adam (Kingma and Ba 2015), dropout (Srivastava and others 2014), averaging
(Polyak and Juditsky 1992).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from assistant.language.families import row_of
from assistant.language.nets import (
    OWN,
    Scores,
    own_row,
)

OWN_WIDE = 24
"""How much is learned for a word itself."""
_DROPPED, UNHEARD = 0.3, 0.1
"""The share of what a net sees, and of whole words, that does not count in a step."""
_RATE, _LAST_RATE, _DECAY = 2e-3, 1e-4, 1e-3
MOST = 40
_SETTLED = 2 / 3
"""The share of the steps behind which weights only go to and fro."""
_EPSILON = 1e-8
NEVER = np.float32(-1e4)
Slopes = dict[str, Scores]
Rows = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Told:
    """A clause as a net takes it in: rows of vectors and of own words, marks, context."""

    vectors: Rows
    own: Rows
    marks: Scores
    context: Scores


@dataclass(frozen=True, eq=False)
class Batch:
    """Clauses side by side; `real` tells where there are words, (clauses, words)."""

    vectors: Rows
    own: Rows
    marks: Scores
    context: Scores
    real: NDArray[np.bool_]


def told(words: Sequence[str], language: str, context: Scores, marks: Scores | None = None) -> Told:
    """Return a clause as a net takes it in."""
    words = [*words[:MOST]] or [""]
    return Told(
        np.array([row_of(one, language) for one in words]),
        np.array([own_row(one) for one in words]),
        np.zeros((len(words), 0), np.float32) if marks is None else marks[:MOST],
        context,
    )


def batch(part: Sequence[Told]) -> Batch:
    """Return clauses side by side."""
    many, size = len(part), max(len(one.own) for one in part)
    rows, own = np.zeros((many, size), np.int64), np.zeros((many, size), np.int64)
    marks = np.zeros((many, size, part[0].marks.shape[1]), np.float32)
    real = np.zeros((many, size), bool)
    for n, one in enumerate(part):
        count = len(one.own)
        rows[n, :count], own[n, :count], marks[n, :count] = one.vectors, one.own, one.marks
        real[n, :count] = True
    return Batch(rows, own, marks, np.stack([one.context for one in part]), real)


def taken(one: Batch, weights: Mapping[str, Scores], known: Scores, heard: Scores) -> Scores:
    """Return what the net takes in, (clauses, words, n); words that are not heard are nothing."""
    parts = [known[one.vectors] * heard, weights["own"][one.own] * heard * one.real[..., None]]
    return np.concatenate([*parts, one.marks], axis=2)


def own_slope(one: Batch, slope: Scores) -> Scores:
    """Return the slopes of the rows learned for words themselves."""
    places = one.own.ravel()
    ends = np.arange(len(places) + 1)
    table = csr_matrix((np.ones(len(places), np.float32), places, ends), (len(places), OWN))
    found = np.asarray(table.T @ slope.reshape(len(places), -1), dtype=np.float32)
    found[0] = 0.0
    return found


def unwindowed(slope: Scores, width: int, edge: int, size: int) -> Scores:
    """Return the slopes of the rows that windows were made of."""
    many, count, wide = slope.shape
    parts = slope.reshape(many, count, width, wide // width)
    found = np.zeros((many, size + 2 * edge, wide // width), np.float32)
    for at in range(width):
        found[:, at : at + count] += parts[:, :, at]
    return found[:, edge : edge + size]


def kept(rng: np.random.Generator, shape: tuple[int, ...]) -> Scores:
    """Return what counts in a step, and by how much more for what does not."""
    return np.asarray((rng.random(shape) > _DROPPED) / np.float32(1 - _DROPPED), np.float32)


def random(rng: np.random.Generator, *shape: int) -> Scores:
    """Return weights to begin with."""
    return np.asarray(rng.normal(size=shape) * np.sqrt(1.5 / shape[0]), np.float32)


def softmax(scores: Scores) -> Scores:
    """Return shares that sum to one along the last axis."""
    odds = np.exp(scores - scores.max(axis=-1, keepdims=True))
    return np.asarray(odds / odds.sum(axis=-1, keepdims=True), np.float32)


def product(left: Scores, right: Scores) -> Scores:
    """Return the sum over all words of what comes in times what is sloped."""
    return left.reshape(-1, left.shape[-1]).T @ right.reshape(-1, right.shape[-1])


def descended(
    weights: Slopes,
    sizes: NDArray[np.int64],
    counts: NDArray[np.float64],
    slopes: Callable[[NDArray[np.int64], Slopes, np.random.Generator], Slopes],
    epochs: int,
    rng: np.random.Generator,
) -> Slopes:
    """Return the mean of the weights of the last steps of Adam: single steps go to and fro.

    An example that counts little is seen seldom.
    """
    mean, spread = ({k: np.zeros_like(v) for k, v in weights.items()} for _ in range(2))
    found, taken, step = {k: v.copy() for k, v in weights.items()}, 0, 0
    for epoch in range(epochs):
        rate = np.float32(_RATE * (1 - epoch / epochs) + _LAST_RATE)
        for part in _parts(sizes, counts, rng):
            step += 1
            for key, slope in slopes(part, weights, rng).items():
                mean[key] += 0.1 * (slope - mean[key])
                spread[key] += 0.001 * (slope * slope - spread[key])
                moved = (mean[key] / (1 - 0.9**step)) / (
                    np.sqrt(spread[key] / (1 - 0.999**step)) + _EPSILON
                )
                decay = 0.0 if key == "own" else _DECAY
                weights[key] -= rate * np.asarray(moved + decay * weights[key], np.float32)
            taken += epoch >= epochs * _SETTLED
            for key in weights if taken else ():
                found[key] += (weights[key] - found[key]) / np.float32(taken)
    return found


def _parts(
    sizes: NDArray[np.int64], counts: NDArray[np.float64], rng: np.random.Generator
) -> Iterator[NDArray[np.int64]]:
    """Yield the examples of an epoch, those of like length together."""
    taken = np.flatnonzero(rng.random(len(sizes)) < counts)
    taken = taken[np.argsort(sizes[taken] + 2 * rng.random(len(taken)))]
    parts = [taken[at : at + 64] for at in range(0, len(taken), 64)]
    yield from (parts[at] for at in rng.permutation(len(parts)))
