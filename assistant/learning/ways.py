"""The default blending: stretches kept rigid, the ways between carried with least jerk.

Around each station the path is moved rigidly with its object or target. Between two stations
a correction is added that joins both ends with their speed and acceleration, the quintic,
which of all such corrections has the least squared jerk. Distance from the base's axis,
azimuth and height are corrected, not xyz, so that the way turns with the azimuth of object
and target and never cuts across the base.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array
from assistant.learning.rigid import Floats, Rows, arc, left_factor, matrix, multiply
from assistant.learning.weights import least_jerk, quintic

Span = tuple[int, int]
Turn = tuple[float, list[float]]

_UP = (0.0, 0.0, 1.0, 0.0)


@dataclass(frozen=True, slots=True)
class End:
    """The sample at an end of a way, between its two neighbors.

    Parameters
    ----------
    near : three rows of three floats
        xyz.
    around : three rows of three floats
        The same as distance, azimuth and height; or xyz again.
    """

    near: Rows
    around: Rows


@dataclass(frozen=True, slots=True, eq=False)
class Between:
    """The way from one stretch to the next, prepared once.

    Parameters
    ----------
    first, last : int
        Last sample of the one stretch, first of the other; those between are carried.
    hermite : array, shape (6, m)
        Weights of value, slope and curvature (a sample's step being 1) at both ends.
    share : array, shape (2, m)
        Share of the turn made, and 1.
    quats : array, shape (4, m)
    ends : two of End
    """

    first: int
    last: int
    hermite: Array
    share: Array
    quats: Array
    ends: tuple[End, End]


@dataclass(frozen=True, slots=True, eq=False)
class Ways:
    """A learned path prepared for blending.

    Parameters
    ----------
    path : array, shape (n, 7)
    held : tuple of (first, last)
        Stretches that keep their shape: the start, each station, perhaps the end.
    stretches : array, shape (m, 8), for each
        Their xyz, 1 and quaternion.
    middles : three floats a stretch
        A place within each, whose azimuth the hand's turning follows.
    polar : bool
        Whether the way turns with the azimuth about the base.
    between : tuple of Between
        One fewer than `held`.
    around : array, shape (3, l)
        Distance, azimuth and height, or xyz, of all samples between stretches.
    """

    path: Array
    held: tuple[Span, ...]
    stretches: tuple[Array, ...]
    middles: Rows
    polar: bool
    between: tuple[Between, ...]
    around: Array


def prepare(path: Array, held: tuple[Span, ...], least_radius_m: float) -> Ways:
    """Return what `smooth_way` needs and does not depend on a setup.

    Parameters
    ----------
    path : array, shape (n, 7)
    held : tuple of (first, last)
        In order; the first begins at sample 0, the last ends at n - 1.
    least_radius_m : float
        A path that comes nearer to the base's axis is carried in xyz.
    """
    radius = np.hypot(path[:, 0], path[:, 1])
    polar = bool(np.min(radius) >= least_radius_m)
    around = path[:, :3].copy()
    if polar:
        around[:, 0], around[:, 1] = radius, np.unwrap(np.arctan2(path[:, 1], path[:, 0]))
    between = tuple(
        _between(path, around, first, last) for (_, first), (last, _) in itertools.pairwise(held)
    )
    middles = [path[last, :3].tolist() for _, last in held]
    ones = np.ones((len(path), 1))
    rows = np.hstack([path[:, :3], ones, path[:, 3:]])
    stretches = tuple(rows[first : last + 1].copy() for first, last in held)
    free = [around[way.first + 1 : way.last] for way in between]
    carried = np.ascontiguousarray(np.vstack([*free, np.zeros((0, 3))]).T)
    return Ways(path, held, stretches, middles, polar, between, carried)


def smooth_way(ways: Ways, moves: Sequence[Floats]) -> Array:
    """Return the path with each held stretch moved rigidly and the ways between carried.

    Parameters
    ----------
    ways : Ways
    moves : seven floats a stretch
        How each stretch moves, in the world.

    Returns
    -------
    path : array, shape (n, 7)
        Exact on the held stretches. The hand turns with the azimuth of its surroundings, and
        relative to it along the shorter arc; a half turn relative to it is made to the left
        (counterclockwise seen from above).
    """
    out = np.empty_like(ways.path)
    turning = [matrix(move[3:]) for move in moves]
    for k, (first, last) in enumerate(ways.held):
        np.matmul(ways.stretches[k], _rigid(turning[k], moves[k]), out=out[first : last + 1])
    if ways.around.shape[1]:
        _carry(ways, turning, moves, out)
    return out


def _between(path: Array, around: Array, first: int, last: int) -> Between:
    length = max(last - first, 1)
    share = np.arange(1, length) / length
    inside = slice(first + 1, last)
    return Between(
        first,
        last,
        np.ascontiguousarray(quintic(share, length).T),
        np.stack([least_jerk(share), np.ones(len(share))]),
        np.ascontiguousarray(path[inside, 3:].T),
        (_about(path, around, first), _about(path, around, last)),
    )


def _about(path: Array, around: Array, end: int) -> End:
    # Slope and curvature at an end are taken from its two neighbors; at the path's own ends
    # the sample itself stands in for the missing one.
    samples = np.clip([end - 1, end, end + 1], 0, len(path) - 1)
    return End(path[samples, :3].tolist(), around[samples].tolist())


def _rigid(turning: Rows, move: Floats) -> Array:
    """Return the matrix, shape (8, 7), that moves rows of xyz, 1 and quaternion."""
    (a, b, c), (d, e, f), (g, h, i) = turning
    px, py, pz, x, y, z, w = move
    return np.array(
        [
            [a, d, g, 0.0, 0.0, 0.0, 0.0],
            [b, e, h, 0.0, 0.0, 0.0, 0.0],
            [c, f, i, 0.0, 0.0, 0.0, 0.0],
            [px, py, pz, 0.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, w, z, -y, -x],
            [0.0, 0.0, 0.0, -z, w, x, -y],
            [0.0, 0.0, 0.0, y, -x, w, -z],
            [0.0, 0.0, 0.0, x, y, z, w],
        ]
    )


def _end(end: End, turning: Rows, move: Floats, polar: bool) -> Rows:
    """Return value, slope and curvature of the correction at an end, one row each."""
    (a, b, c), (d, e, f), (g, h, i) = turning
    px, py, pz = move[:3]
    changes = []
    middle = 0.0
    for k in (1, 0, 2):
        x, y, z = end.near[k]
        first, second = a * x + b * y + c * z + px, d * x + e * y + f * z + py
        if polar:
            azimuth = math.atan2(second, first)
            middle = azimuth if k == 1 else middle
            # The three neighbors lie together; only between stations may azimuths differ much.
            first, second = (
                math.hypot(first, second),
                middle + math.remainder(azimuth - middle, 2.0 * math.pi),
            )
        was = end.around[k]
        changes.append((first - was[0], second - was[1], g * x + h * y + i * z + pz - was[2]))
    (x, y, z), (xa, ya, za), (xb, yb, zb) = changes
    return [
        [x, y, z],
        [(xb - xa) / 2.0, (yb - ya) / 2.0, (zb - za) / 2.0],
        [xa - 2.0 * x + xb, ya - 2.0 * y + yb, za - 2.0 * z + zb],
    ]


def _carry(ways: Ways, turning: Sequence[Rows], moves: Sequence[Floats], out: Array) -> None:
    """Carry all samples between stretches at once: small arrays cost more than long ones."""
    samples = ways.around.shape[1]
    # Rows of `angles`: the azimuth, half of its change, half of the arc.
    carried, angles, terms = np.empty((3, samples)), np.empty((3, samples)), np.empty((16, samples))
    turns = _turns(ways, turning, moves)
    done = 0
    for k, way in enumerate(ways.between):
        inside = slice(done, done + way.share.shape[1])
        ends = [
            *_end(way.ends[0], turning[k], moves[k], ways.polar),
            *_end(way.ends[1], turning[k + 1], moves[k + 1], ways.polar),
        ]
        np.matmul(np.array(ends).T, way.hermite, out=carried[:, inside])
        halves, factors = _turned(turns[k], turns[k + 1])
        np.matmul(np.array(halves), way.share, out=angles[1:, inside])
        np.matmul(np.array(factors), way.quats, out=terms[:, inside])
        done = inside.stop
    carried += ways.around
    angles[0] = carried[1]
    cos, sin = np.cos(angles), np.sin(angles)
    if ways.polar:
        np.multiply(carried[0], sin[0], out=carried[1])
        carried[0] *= cos[0]
    quats = _summed(cos, sin, terms.reshape(4, 4, samples))
    done = 0
    for way in ways.between:
        rows, inside = out[way.first + 1 : way.last], slice(done, done + way.share.shape[1])
        rows[:, :3], rows[:, 3:] = carried[:, inside].T, quats[:, inside].T
        done = inside.stop


def _summed(cos: Array, sin: Array, terms: Array) -> Array:
    """Return the product of both turns and the learned one: a sum with these weights."""
    quats: Array = terms[0]
    quats *= cos[1] * cos[2]
    for weight, term in ((cos[1] * sin[2], 1), (sin[1] * cos[2], 2), (sin[1] * sin[2], 3)):
        terms[term] *= weight
        quats += terms[term]
    return quats


def _turns(ways: Ways, turning: Sequence[Rows], moves: Sequence[Floats]) -> list[Turn]:
    """Return each stretch's change of azimuth and the turn that remains after it."""
    turns = []
    for rows, move, (x, y, z) in zip(turning, moves, ways.middles, strict=True):
        azimuth = 0.0
        if ways.polar:
            after_x = rows[0][0] * x + rows[0][1] * y + rows[0][2] * z + move[0]
            after_y = rows[1][0] * x + rows[1][1] * y + rows[1][2] * z + move[1]
            azimuth = math.atan2(after_y, after_x) - math.atan2(y, x)
        back = [0.0, 0.0, math.sin(-azimuth / 2.0), math.cos(azimuth / 2.0)]
        turns.append((azimuth, multiply(back, move[3:])))
    return turns


def _turned(here: Turn, there: Turn) -> tuple[Rows, Rows]:
    """Return how the hand turns on a way: azimuth, then the arc, then the learned turn.

    Returns
    -------
    halves : two rows of two floats
        Half of the azimuth's change and of the arc: for the share made, and where it begins.
    factors : sixteen rows of four floats
        The four quaternions, as left factors, that the turns are weighted sums of.
    """
    (from_azimuth, rest), (to_azimuth, end) = here, there
    back = [-rest[0], -rest[1], -rest[2], rest[3]]
    axis, angle = arc(multiply(back, end))
    begun = multiply(rest, [*axis, 0.0])
    terms = [rest, begun, multiply(_UP, rest), multiply(_UP, begun)]
    halves = [[0.5 * (to_azimuth - from_azimuth), 0.5 * from_azimuth], [0.5 * angle, 0.0]]
    return halves, [row for term in terms for row in left_factor(term)]
