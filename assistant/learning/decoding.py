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

_FREE, _LED, _UNLED = range(3)
"""How a stretch is spent: on no primitive, on the next one, on one after those left empty."""


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
    unled : array, shape (n, n, m)
        For a stretch spent on the m-th primitive where the one before it was left empty right
        there: what leads to it cannot be missing where it leads there itself.
    """

    cuts: Array
    steps: Array
    unnamed: Array
    skips: Array
    unled: Array


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
        into = named_into(lattice, ahead, ahead_skipped, k)
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
        led = best[:k, :-1] + lattice.steps[:k, k, :]
        unled = _leapt(lattice, after, k) + lattice.steps[:k, k, :]
        free = best[:k, :] + lattice.unnamed[:k, k, None]
        best[k] = np.max(free, axis=0)
        source[k, :, 0], source[k, :, 1] = np.argmax(free, axis=0), _FREE
        for told, how in ((led, _LED), (unled, _UNLED)):
            value, better = np.max(told, axis=0), np.max(told, axis=0) > best[k, 1:]
            best[k, 1:] = np.where(better, value, best[k, 1:])
            source[k, 1:, 0] = np.where(better, np.argmax(told, axis=0), source[k, 1:, 0])
            source[k, 1:, 1] = np.where(better, how, source[k, 1:, 1])
        best[k] += lattice.cuts[k]
        after[k], origin[k] = _skipped(best[k], lattice.skips)
    nodes, taken = [n - 1], []
    k, j = n - 1, int(origin[n - 1, m])
    while k > 0:
        k, how = int(source[k, j, 0]), int(source[k, j, 1])
        taken.append(None if how == _FREE else j - 1)
        j = j if how == _FREE else j - 1 if how == _LED else int(origin[k, j - 2])
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
        both[:k, 1:] = named_into(lattice, ahead, skipped, k)
        both[k:] = ahead[:k] + lattice.unnamed[:k, k, None]
        ahead[k] = log_sum(both, 0) + lattice.cuts[k]
        skipped[k] = _sum_skips(ahead[k], lattice.skips)
    return ahead, skipped


def named_into(lattice: Lattice, ahead: Array, skipped: Array, k: int) -> Array:
    """Return what leads through each named stretch to the k-th instant, shape (k, m).

    Parameters
    ----------
    lattice : Lattice
    ahead, skipped : array, shape (n, m + 1)
        Of `forward`, as far as the instants before.
    k : int
    """
    either = np.logaddexp(ahead[:k, :-1], _leapt(lattice, skipped, k))
    return np.asarray(either + lattice.steps[:k, k, :])


def _leapt(lattice: Lattice, skipped: Array, k: int) -> Array:
    """Return what leads to each primitive with the one before it left empty, shape (k, m)."""
    leapt = np.full((k, len(lattice.skips)), -np.inf)
    leapt[:, 1:] = skipped[:k, :-2] + lattice.skips[:-1] + lattice.unled[:k, k, 1:]
    return leapt


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
        led, unled = np.full(m + 1, -np.inf), np.full(m + 1, -np.inf)
        named = onward[:, 1:] + lattice.steps[k, k + 1 :, :]
        led[:-1], unled[:-1] = log_sum(named, 0), log_sum(named + lattice.unled[k, k + 1 :, :], 0)
        free = log_sum(onward + lattice.unnamed[k, k + 1 :, None], 0)
        behind[k] = np.logaddexp(led, free)
        leapt = lattice.skips + _sum_skips(unled[::-1], lattice.skips[::-1])[::-1][1:]
        behind[k, :-1] = np.logaddexp(behind[k, :-1], leapt)
    return behind
