"""How the hand turns on a way: with the azimuth about the base, and relative to it by an arc.

What the learned way adds to a least-jerk curve turns, too: from the turn about the vertical of
the stretch left behind to that of the next one. The two turns are averaged, not passed through:
so noise of a told place never turns it, and there is no half turn to choose a side for.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from assistant.geometry import Array
from assistant.learning.rigid import Floats, Rows, arc, multiply


class Turn(NamedTuple):
    """How a stretch is turned.

    Parameters
    ----------
    azimuth : float
        Change of its azimuth about the base, in rad.
    rest : four floats
        The turn that remains after it.
    cos, sin : float
        Of its turn about the vertical.
    """

    azimuth: float
    rest: list[float]
    cos: float
    sin: float


NODES = 0.5 - 0.5 * np.cos(np.pi * np.arange(22) / 21.0)
"""Shares of a turn at which it is computed: those of Chebyshev, both ends included."""
_QUARTER = math.pi / 2.0
_SHARES = np.stack([NODES, np.ones(len(NODES))])
_BARYCENTRIC = (-1.0) ** np.arange(22) * np.array([0.5, *([1.0] * 20), 0.5])


def turns(
    middles: Rows,
    turning: Sequence[Rows],
    moves: Sequence[Floats],
    polar: bool,
    onward: frozenset[int] = frozenset(),
) -> list[Turn]:
    """Return how each stretch is turned.

    Parameters
    ----------
    middles : three floats a stretch
        The place whose azimuth counts.
    turning : rotation matrix a stretch
    moves : seven floats a stretch
    polar : bool
        Otherwise azimuths do not count.
    onward : frozenset of int
        Stretches that what is pushed is brought to from the one before: straight, not around the
        base where that lies on the other side of its back.
    """
    found: list[Turn] = []
    for k, (rows, move, (x, y, z)) in enumerate(zip(turning, moves, middles, strict=True)):
        azimuth = 0.0
        if polar:
            after_x = rows[0][0] * x + rows[0][1] * y + rows[0][2] * z + move[0]
            after_y = rows[1][0] * x + rows[1][1] * y + rows[1][2] * z + move[1]
            azimuth = math.atan2(after_y, after_x) - math.atan2(y, x)
            if k in onward:
                before = found[-1].azimuth
                azimuth = before + math.remainder(azimuth - before, 2.0 * math.pi)
        back = [0.0, 0.0, math.sin(-azimuth / 2.0), math.cos(azimuth / 2.0)]
        found.append(Turn(azimuth, multiply(back, move[3:]), *_upright(move[5], move[6])))
    return found


def _upright(z: float, w: float) -> tuple[float, float]:
    """Return cosine and sine of the part about the vertical of a turn xyzw."""
    length = z * z + w * w
    # A hand turned upside down has none.
    return ((w * w - z * z) / length, 2.0 * z * w / length) if length > 1e-12 else (1.0, 0.0)


def nodes_between(made: Array) -> Array:
    """Return the weights of values at `NODES` for shares of the turn made, shape (nodes, m).

    The turn is an analytic function of the share made: through so many values it is led to
    rounding, without a sine of its own for each sample.
    """
    apart = made[None, :] - NODES[:, None]
    met = np.abs(apart) < 1e-15
    weights: Array = _BARYCENTRIC[:, None] / np.where(met, 1.0, apart)
    weights /= np.sum(weights, axis=0)
    weights[:, np.any(met, axis=0)] = 0.0
    weights[met] = 1.0
    return weights


def turned(by: Sequence[Turn]) -> Array:
    """Return how the hand is turned on each way, at the `NODES`, shape (ways, 4, nodes).

    It comes after the learned turn: the arc to the next stretch's, then the azimuth.
    """
    flat = [one for here, there in pairwise(by) for one in _between(here, there)]
    rows = np.fromiter(flat, float).reshape(-1, 6, 4)
    waves: Array = np.cos(rows[:, :2].reshape(-1, 2).dot(_SHARES)).reshape(-1, 4, len(NODES))
    weights: Array = waves[:, :2, None] * waves[:, None, 2:]
    weights = weights.reshape(-1, 4, len(NODES))
    nodes: Array = np.matmul(rows[:, 2:].transpose(0, 2, 1), weights)
    return nodes


def _between(here: Turn, there: Turn) -> list[float]:
    """Return what `turned` needs of a way: eight angles in rad, and four quaternions."""
    rest = x, y, z, w = here.rest
    axis, angle = arc(multiply([-x, -y, -z, w], there.rest))
    a, b, c, d = multiply(rest, [*axis, 0.0])
    half, begin, bent = 0.5 * (there.azimuth - here.azimuth), 0.5 * here.azimuth, 0.5 * angle
    # Change and beginning of each half angle, for its cosine, then for its sine.
    angles = half, begin, half, begin - _QUARTER, bent, 0.0, bent, -_QUARTER
    # The last two quaternions are the first two after half a turn about the vertical.
    return [*angles, x, y, z, w, a, b, c, d, -y, x, w, -z, -b, a, d, -c]


def products(turning: Array, quats: Array) -> Array:
    """Return the terms of products of quaternions, shape (16, m), for `SUMMED` to sum up.

    Parameters
    ----------
    turning, quats : array, shape (4, m)
        Turn by `quats`, then by `turning`.
    """
    terms: Array = turning[:, None] * quats
    return terms.reshape(16, -1)


def _summing() -> Array:
    """Return what sums products of components of two quaternions up to those of their own."""
    units = np.eye(4).tolist()
    return np.array([multiply(a, b) for a in units for b in units]).T.copy()


SUMMED = _summing()
