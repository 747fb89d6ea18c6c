"""How much of all readings together agrees with the best one: sums over the decoder's chain.

A cut is as sure as the share of readings that end the same primitive near it; a lesson is as
sure as the share that has all of its cuts so, and no other.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assistant.geometry import Array
from assistant.learning.decoding import Lattice, Reading, backward, forward, log_sum

_SAME_END_S = 0.4
"""Steps whose ends lie so near to each other's are one and the same."""
_MOST_PLACES, _LEAST_CHANCE = 5, 0.01
"""So many places are told, and none that is less likely."""


def cut_shares(
    reading: Reading, at_s: Array, cuts_s: Array, taken: Sequence[int | None], within_s: float
) -> Array:
    """Return how likely the same primitives end near the cuts of another reading, shape (k,).

    Parameters
    ----------
    reading : Reading
    at_s : array, shape (n,)
        Its instants.
    cuts_s : array, shape (k,)
    taken : sequence of (int or None), length k + 1
        Positions of the primitives between the cuts; None asks for any cut.
    within_s : float
    """
    near = np.abs(at_s[:, None] - cuts_s) <= within_s
    near[0], near[-1] = False, False
    ends = [
        reading.cut_chances if position is None else reading.step_chances[:, position]
        for position in taken[:-1]
    ]
    told = np.stack(ends, axis=1) if ends else np.zeros((len(at_s), 0))
    return np.asarray(np.minimum(np.sum(told * near, axis=0), 1.0))


def whole_evidence(
    lattice: Lattice, at_s: Array, cuts_s: Array, taken: Sequence[int | None], within_s: float
) -> float:
    """Return the log of the sum over the readings that have just these cuts and primitives.

    Against `Reading.evidence` it tells the probability that the whole reading is right.
    Parameters are those of `cut_shares`.
    """
    windows = [np.flatnonzero(np.abs(at_s[1:-1] - cut) <= within_s) + 1 for cut in cuts_s]
    if any(len(window) == 0 for window in windows):
        return -np.inf
    nodes = [np.array([0]), *windows, np.array([len(at_s) - 1])]
    ahead, done = np.zeros(1), 0
    for before, after, position in zip(nodes[:-1], nodes[1:], taken, strict=True):
        between = np.ix_(before, after)
        if position is None:
            spent = lattice.unnamed[between]
        else:
            spent = lattice.steps[:, :, position][between] + np.sum(lattice.skips[done:position])
            spent = spent + lattice.unled[:, :, position][between] * (done < position)
            done = position + 1
        later = at_s[after][None, :] > at_s[before][:, None]
        spent = np.where(later, spent, -np.inf)
        ahead = log_sum(ahead[:, None] + spent, 0) + lattice.cuts[after]
    return float(log_sum(ahead, 0) + np.sum(lattice.skips[done:]))


def unnamed_chances(lattice: Lattice) -> Array:
    """Return how likely a step nobody introduced spans from one instant to another, shape (n, n).

    The sum is how many such steps are to be expected.
    """
    ahead, skipped = forward(lattice)
    onward = backward(lattice) + lattice.cuts[:, None] - skipped[-1, -1]
    spent = ahead[:, None] + lattice.unnamed[:, :, None] + onward
    return np.asarray(np.triu(np.sum(np.exp(np.minimum(spent, 0.0)), axis=2), 1))


def unnamed_places(lattice: Lattice, at_s: Array) -> tuple[tuple[float, float, float], ...]:
    """Return where steps nobody introduced may lie, the likeliest place first.

    Readings differ in where just such a step begins and ends, but agree in what it spans: places
    are told apart by instants in the midst of them.

    Parameters
    ----------
    lattice : Lattice
    at_s : array, shape (n,)
        Its instants.

    Returns
    -------
    places : tuple of (float, float, float)
        From when to when, in s, the likeliest such step there lasts, and how likely there is one.
    """
    chances = unnamed_chances(lattice)
    found: list[tuple[float, float, float]] = []
    alike = (np.abs(at_s[:, None] - at_s) <= _SAME_END_S).astype(float)
    while len(found) < _MOST_PLACES:
        begun = np.cumsum(chances, axis=0)[:-1]
        spanned = np.array([np.sum(row[k + 1 :]) for k, row in enumerate(begun)])
        at = int(np.argmax(spanned))
        if spanned[at] < _LEAST_CHANCE:
            break
        over = np.zeros_like(chances)
        over[: at + 1, at + 1 :] = chances[: at + 1, at + 1 :]
        together = np.where(over > 0.0, alike @ over @ alike, 0.0)
        first, last = np.unravel_index(int(np.argmax(together)), together.shape)
        found.append((float(at_s[first]), float(at_s[last]), float(min(spanned[at], 1.0))))
        chances = chances - over
    return tuple(found)
