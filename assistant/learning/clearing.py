"""Ways are pressed outward where they would cut across the base, with least jerk.

A way from one place to another far around the base would lead straight through it. It is
pressed away from the base's axis at three instants, each along a direction of its own, just
as far as is needed: of all ways that stay so far out at these instants it has the least jerk.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array
from assistant.learning.rigid import Floats, Rows
from assistant.learning.turning import Turn
from assistant.learning.weights import least_jerk, quintic

INSTANTS, SHARES = (0.3, 0.5, 0.7), (0.25, 0.5, 0.75)
"""Shares of the time at which a way is pressed, and of the azimuth it has then turned.

With these the jerk is within a tenth of the least there is for turns up to 300 degrees.
"""
FAR_ROUND_RAD = math.radians(150.0)
NEARER, NEAREST = 0.2, 0.7
"""A way that turns further about the base than `FAR_ROUND_RAD` keeps less far out: by so much of
its distances for each rad more, down to so much of them. It is long: so it is shorter and
smoother."""
LEAST_SAMPLES = 12
_NEARLY_M = 1e-9
_SUBSETS = [some for some in itertools.product((0.0, 1.0), repeat=3) if any(some)]


@dataclass(frozen=True, slots=True)
class Clearance:
    """How a way is pressed outward, prepared once.

    Parameters
    ----------
    at : three of int
        Which of the samples between the way's ends lie at the instants.
    azimuth, radius : three floats
        Of the learned way there.
    made : three floats
        Share of a displacement made by then.
    stiff : three rows of three floats
        How far a press at one instant moves the way at another.
    begin, end : two floats
        Azimuth and radius of the learned way's ends.
    """

    at: list[int]
    azimuth: Floats
    radius: Floats
    made: Floats
    stiff: Rows
    begin: tuple[float, float]
    end: tuple[float, float]


def bump(share: Array, instant: float) -> Array:
    """Return the least-jerk curve that rests at both ends and is pressed at one instant.

    The way of the press is up to a factor: a reproducing kernel of squared jerk, so that a sum
    of bumps through given places at their instants has the least jerk of all such curves.
    """
    u = 1.0 - instant
    back = quintic(share, 1)[:, 3:] @ np.array([u**5 / 120.0, u**4 / 24.0, u**3 / 6.0])
    # Scaled so that the curve's greatest weights are near 1.
    return np.asarray(1e4 * (back - np.maximum(share - instant, 0.0) ** 5 / 120.0))


def prepared(xy: Array, share: Array) -> tuple[Clearance, Array] | None:
    """Return what a way needs to be pressed, and the bumps, shape (m, 3); None if too short.

    Parameters
    ----------
    xy : array, shape (m + 2, 2)
        The learned way, ends included.
    share : array, shape (m,)
        Of the way's time, ends excluded.
    """
    if len(share) < LEAST_SAMPLES:
        return None
    radius, azimuth = np.hypot(*xy.T), np.unwrap(np.arctan2(xy[:, 1], xy[:, 0]))
    at = [round(instant * (len(share) + 1)) - 1 for instant in INSTANTS]
    there = [k + 1 for k in at]
    bumps = np.stack([bump(share, float(share[k])) for k in at], axis=1)
    clearance = Clearance(
        at,
        azimuth[there].tolist(),
        radius[there].tolist(),
        least_jerk(share[at]).tolist(),
        bumps[at].tolist(),
        (float(azimuth[0]), float(radius[0])),
        (float(azimuth[-1]), float(radius[-1])),
    )
    return clearance, bumps


def presses(clear: Clearance, places: Rows, turns: tuple[Turn, Turn], keep: float) -> Rows:
    """Return the weights of the three bumps, a row of x and y each; no row where all is clear.

    Parameters
    ----------
    clear : Clearance
    places : five rows of xyz
        Of the new way: where it begins, at the three instants, where it ends.
    turns : two of Turn
        Of the stretches at either end.
    keep : float
        Share of the distance from the axis that is kept, against a way that turns evenly, or
        against its nearer end where that is less: no further out than it need be. Less of the
        former where it turns far.
    """
    begin = _changed(places[0], clear.begin, turns[0].azimuth)
    end = _changed(places[4], clear.end, turns[1].azimuth)
    nearer = keep * min(clear.begin[1] + begin[1], clear.end[1] + end[1])
    keep = kept_out(keep, abs(clear.end[0] + end[0] - clear.begin[0] - begin[0]))
    turn, farther = end[0] - begin[0], end[1] - begin[1]
    directions, needs = [], []
    for azimuth, radius, made, share, (x, y, _) in zip(
        clear.azimuth, clear.radius, clear.made, SHARES, places[1:4], strict=True
    ):
        angle = azimuth + begin[0] + turn * share
        out = cos, sin = math.cos(angle), math.sin(angle)
        directions.append(out)
        far_m = min(keep * (radius + begin[1] + farther * made), nearer)
        needs.append(far_m - (cos * x + sin * y))
    if max(needs) <= 0.0:
        return []
    (ax, ay), (bx, by), (cx, cy) = directions
    ab, ac, bc = ax * bx + ay * by, ax * cx + ay * cy, bx * cx + by * cy
    (aa, p, q), (_, bb, r), (_, _, cc) = clear.stiff
    p, q, r = p * ab, q * ac, r * bc
    stiff = [[aa, p, q], [p, bb, r], [q, r, cc]]
    a, b, c = least_presses(stiff, needs)
    return [[a * ax, a * ay], [b * bx, b * by], [c * cx, c * cy]]


def kept_out(keep: float, turned_rad: float) -> float:
    """Return the share of the distance that a way keeps which turns so far about the base."""
    return max(keep - NEARER * max(turned_rad - FAR_ROUND_RAD, 0.0), min(keep, NEAREST))


def _changed(place: Floats, shown: tuple[float, float], turn: float) -> tuple[float, float]:
    """Return by how much azimuth and radius of an end change; the azimuth as `turn` goes."""
    change = math.atan2(place[1], place[0]) - shown[0]
    radius = math.hypot(place[0], place[1]) - shown[1]
    return turn + math.remainder(change - turn, 2.0 * math.pi), radius


def least_presses(stiff: Rows, needs: Floats) -> list[float]:
    """Return the presses, none below zero, that meet all needs with the least squared jerk.

    Parameters
    ----------
    stiff : three rows of three floats
        Positive definite.
    needs : three floats
        How far the way must at least be moved at each instant.

    Notes
    -----
    A quadratic program with three inequalities: exactly one set of presses above zero fits, and
    the answer depends continuously on the needs. The likeliest sets are tried first.
    """
    some = [1.0 if need > 0.0 else 0.0 for need in needs]
    while any(some):
        found = _meeting(stiff, needs, some)
        if _fits(stiff, needs, found):
            return found
        some[min((k for k in range(3) if some[k]), key=found.__getitem__)] = 0.0
    every = (_meeting(stiff, needs, chosen) for chosen in _SUBSETS)
    return next((found for found in every if _fits(stiff, needs, found)), [0.0, 0.0, 0.0])


def _meeting(stiff: Rows, needs: Floats, some: Floats) -> list[float]:
    """Return the presses at some instants (1, others 0) that meet the needs there exactly."""
    i, j, k = some
    # An instant left out has a system of its own, whose answer is 0. Solved by cofactors.
    a, b, c = stiff[0][0] * i + 1.0 - i, stiff[0][1] * i * j, stiff[0][2] * i * k
    d, e, f = stiff[1][1] * j + 1.0 - j, stiff[1][2] * j * k, stiff[2][2] * k + 1.0 - k
    x, y, z = needs[0] * i, needs[1] * j, needs[2] * k
    first, second, last = d * f - e * e, c * e - b * f, b * e - c * d
    middle, cross, end = a * f - c * c, b * c - a * e, a * d - b * b
    whole = a * first + b * second + c * last
    return [
        (first * x + second * y + last * z) / whole,
        (second * x + middle * y + cross * z) / whole,
        (last * x + cross * y + end * z) / whole,
    ]


def _fits(stiff: Rows, needs: Floats, found: Floats) -> bool:
    a, b, c = found
    if a < 0.0 or b < 0.0 or c < 0.0:
        return False
    for (d, e, f), need in zip(stiff, needs, strict=True):
        if d * a + e * b + f * c < need - _NEARLY_M:
            return False
    return True
