"""Cuts and assignment decided together: a semi-Markov chain over the introduced primitives.

States are positions among the primitives; a stretch between two instants is spent on the
next primitive, or on a step nobody introduced (insert); a primitive may stay empty (skip).
So the introduction is evidence and not a constraint (design, "The introduction").
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array
from assistant.model.motion import Indices


@dataclass(frozen=True, slots=True, eq=False)
class Lattice:
    """All that the decoder weighs, in log odds.

    Parameters
    ----------
    cuts : array, shape (n,)
        For a cut at each instant; the first and the last, start and end, are 0.
    steps : array, shape (n, n, m)
        For a stretch spent on the m-th primitive in order.
    unnamed : array, shape (n, n)
        For a stretch spent on no primitive.
    skips : array, shape (m,)
        For leaving a primitive empty.
    """

    cuts: Array
    steps: Array
    unnamed: Array
    skips: Array


@dataclass(frozen=True, slots=True, eq=False)
class Reading:
    """The best reading of a demonstration, and how sure each part of it is.

    Parameters
    ----------
    score : float
        Of the best reading.
    evidence : float
        Log of the sum over all readings.
    nodes : tuple of int
        Instants of the best reading, start and end included.
    taken : tuple of (int or None)
        For each stretch the primitive's position, None for an unnamed one.
    cut_chances : array, shape (n,)
        Probability of a cut at each instant.
    step_chances : array, shape (n, m)
        Probability that a stretch on the m-th primitive ends at each instant.
    """

    score: float
    evidence: float
    nodes: tuple[int, ...]
    taken: tuple[int | None, ...]
    cut_chances: Array
    step_chances: Array


def decode(lattice: Lattice) -> Reading:
    """Return the best reading and the probabilities of its parts."""
    score, nodes, taken = _best(lattice)
    ahead, ahead_skipped = forward(lattice)
    behind = backward(lattice)
    total = float(ahead_skipped[-1, -1])
    cut = log_sum(ahead + behind, 1) - total
    step = np.full((len(lattice.cuts), lattice.steps.shape[2]), -np.inf)
    for k in range(1, len(lattice.cuts)):
        into = ahead_skipped[:k, :-1] + lattice.steps[:k, k, :]
        step[k] = log_sum(into, 0) + lattice.cuts[k] + behind[k, 1:] - total
    return Reading(
        score,
        total,
        nodes,
        taken,
        np.exp(np.minimum(cut, 0.0)),
        np.exp(np.minimum(step, 0.0)),
    )


def _skipped(row: Array, skips: Array) -> tuple[Array, Indices]:
    """Return scores after skipping any primitives from each position, and where from (best)."""
    out, origin = row.copy(), np.arange(len(row), dtype=np.int64)
    for j in range(len(skips)):
        if out[j] + skips[j] > out[j + 1]:
            out[j + 1], origin[j + 1] = out[j] + skips[j], origin[j]
    return out, origin


def _best(lattice: Lattice) -> tuple[float, tuple[int, ...], tuple[int | None, ...]]:
    n, _, m = lattice.steps.shape
    best = np.full((n, m + 1), -np.inf)
    after = np.full((n, m + 1), -np.inf)
    origin = np.zeros((n, m + 1), dtype=int)
    source = np.zeros((n, m + 1, 2), dtype=int)
    best[0, 0] = 0.0
    after[0], origin[0] = _skipped(best[0], lattice.skips)
    for k in range(1, n):
        named = after[:k, :-1] + lattice.steps[:k, k, :]
        free = after[:k, :] + lattice.unnamed[:k, k, None]
        from_named, from_free = np.argmax(named, axis=0), np.argmax(free, axis=0)
        value = free[from_free, np.arange(m + 1)]
        source[k, :, 0], source[k, :, 1] = from_free, 0
        better = named[from_named, np.arange(m)] > value[1:]
        value[1:] = np.where(better, named[from_named, np.arange(m)], value[1:])
        source[k, 1:, 0] = np.where(better, from_named, source[k, 1:, 0])
        source[k, 1:, 1] = better
        best[k] = value + lattice.cuts[k]
        after[k], origin[k] = _skipped(best[k], lattice.skips)
    nodes, taken = [n - 1], []
    k, j = n - 1, int(origin[n - 1, m])
    while k > 0:
        previous, named_step = int(source[k, j, 0]), bool(source[k, j, 1])
        taken.append(j - 1 if named_step else None)
        j = int(origin[previous, j - 1 if named_step else j])
        k = previous
        nodes.append(k)
    return float(after[-1, m]), tuple(reversed(nodes)), tuple(reversed(taken))


def log_sum(values: Array, axis: int) -> Array:
    """Return the log of the sum of exponentials along an axis; nothing at all is -inf."""
    top = np.max(values, axis=axis, keepdims=True)
    top = np.where(np.isfinite(top), top, 0.0)
    with np.errstate(divide="ignore"):
        told = np.log(np.sum(np.exp(values - top), axis=axis))
    return np.asarray(told + np.squeeze(top, axis=axis))


def forward(lattice: Lattice) -> tuple[Array, Array]:
    """Return what leads to an instant: before skipping, and with skips taken there.

    Primitives are skipped right before a named stretch or at the end, nowhere else: so each
    reading is counted once.
    """
    n, _, m = lattice.steps.shape
    ahead = np.full((n, m + 1), -np.inf)
    skipped = np.full((n, m + 1), -np.inf)
    ahead[0, 0] = 0.0
    skipped[0] = _sum_skips(ahead[0], lattice.skips)
    for k in range(1, n):
        both = np.full((2 * k, m + 1), -np.inf)
        both[:k, 1:] = skipped[:k, :-1] + lattice.steps[:k, k, :]
        both[k:] = ahead[:k] + lattice.unnamed[:k, k, None]
        ahead[k] = log_sum(both, 0) + lattice.cuts[k]
        skipped[k] = _sum_skips(ahead[k], lattice.skips)
    return ahead, skipped


def _sum_skips(row: Array, skips: Array) -> Array:
    out = row.copy()
    for j in range(len(skips)):
        out[j + 1] = np.logaddexp(out[j + 1], out[j] + skips[j])
    return out


def backward(lattice: Lattice) -> Array:
    """Return what follows an instant, skips taken there included."""
    n, _, m = lattice.steps.shape
    behind = np.full((n, m + 1), -np.inf)
    end = np.full(m + 1, -np.inf)
    end[m] = 0.0
    behind[-1] = _sum_skips(end[::-1], lattice.skips[::-1])[::-1]
    for k in range(n - 2, -1, -1):
        onward = behind[k + 1 :] + lattice.cuts[k + 1 :, None]
        named = np.full(m + 1, -np.inf)
        named[:-1] = log_sum(onward[:, 1:] + lattice.steps[k, k + 1 :, :], 0)
        free = log_sum(onward + lattice.unnamed[k, k + 1 :, None], 0)
        behind[k] = np.logaddexp(_sum_skips(named[::-1], lattice.skips[::-1])[::-1], free)
    return behind
