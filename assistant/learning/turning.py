"""How the hand turns on a way: with the azimuth about the base, and relative to it by an arc.

What the learned way adds to a least-jerk curve turns, too: from the turn about the vertical of
the stretch left behind to that of the next one. The two turns are averaged, not passed through:
so noise of a told place never turns it, and there is no half turn to choose a side for.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from assistant.geometry import Array
from assistant.learning.rigid import Floats, Rows, arc, left_factor, multiply


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


_UP = (0.0, 0.0, 1.0, 0.0)


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


def turned(here: Turn, there: Turn) -> tuple[Rows, Rows]:
    """Return how the hand turns on a way: azimuth, then the arc, then the learned turn.

    Returns
    -------
    halves : two rows of two floats
        Half of the azimuth's change and of the arc: for the share made, and where it begins.
    factors : sixteen rows of four floats
        The four quaternions, as left factors, that the turns are weighted sums of.
    """
    rest = here.rest
    axis, angle = arc(multiply([-rest[0], -rest[1], -rest[2], rest[3]], there.rest))
    begun = multiply(rest, [*axis, 0.0])
    terms = [rest, begun, multiply(_UP, rest), multiply(_UP, begun)]
    halves = [[0.5 * (there.azimuth - here.azimuth), 0.5 * here.azimuth], [0.5 * angle, 0.0]]
    return halves, [row for term in terms for row in left_factor(term)]


def summed(halves: Array, terms: Array) -> Array:
    """Return the product of both turns and the learned one: a sum with these weights.

    Parameters
    ----------
    halves : array, shape (2, m)
        Half of the azimuth's change and half of the arc, in rad.
    terms : array, shape (4, 4, m)
        The factors of `turned` applied to the learned turns; used up.
    """
    cos, sin = np.cos(halves), np.sin(halves)
    quats: Array = terms[0]
    quats *= cos[0] * cos[1]
    for weight, term in ((cos[0] * sin[1], 1), (sin[0] * cos[1], 2), (sin[0] * sin[1], 3)):
        terms[term] *= weight
        quats += terms[term]
    return quats
