"""What a learned way adds to a least-jerk curve, evened out as far as a setup asks for it.

A far setup makes ways longer in the same time, which costs jerk. It is won back from the small
unevenness of the teacher's hand: the way is led, in part or wholly, along the least-jerk curve
through a few of its own places, and never further than a bound from where it would be.
"""

from __future__ import annotations

import math

import numpy as np

from assistant.geometry import Array
from assistant.learning.clearing import bump

COUNTS = (3, 5, 7, 9, 12, 16, 24, 32, 48)
"""How many places a way may be led through, evenly spread over its time."""


def even(details: Array, share: Array, most_m: float) -> Array:
    """Return the least-jerk curve through the fewest places that stays within `most_m`.

    Parameters
    ----------
    details : array, shape (m, 3)
        Zero with speed and acceleration beyond both ends.
    share : array, shape (m,)
        Of the way's time, ends excluded.
    most_m : float

    Returns
    -------
    curve : array, shape (m, 3)
        The details themselves where no curve stays near enough or has less jerk.
    """
    rough = np.sum(third(details.T) ** 2)
    for count in COUNTS:
        if len(details) < 2 * count:
            break
        at = np.round(np.linspace(0.0, len(details) + 1, count + 2)[1:-1]).astype(int) - 1
        bumps = np.stack([bump(share, float(share[k])) for k in at], axis=1)
        curve = np.asarray(bumps @ np.linalg.solve(bumps[at], details[at]))
        near = float(np.max(np.linalg.norm(curve - details, axis=1))) <= most_m
        if near and np.sum(third(curve.T) ** 2) < rough:
            return curve
    return details


def third(rows: Array) -> Array:
    """Return third differences along the last axis, shape (k, m - 3)."""
    once = rows[:, 1:] - rows[:, :-1]
    twice = once[:, 1:] - once[:, :-1]
    return np.asarray(twice[:, 1:] - twice[:, :-1])


def share_needed(have: float, slope: float, bend: float, most: float) -> float:
    """Return the least share, in [0, 1], of a change that brings squared jerk to a bound.

    Parameters
    ----------
    have, slope, bend : float
        Products of third differences: of the way with itself, of the way with the whole
        change, of the change with itself.
    most : float
        Sum of squares allowed; where it cannot be had, the share with the least.
    """
    if have <= most or slope >= 0.0:
        return 0.0
    left = slope * slope - bend * (have - most)
    return min((-slope - math.sqrt(max(left, 0.0))) / bend, 1.0)
