"""The default blending: stretches kept rigid, the ways between carried with least jerk.

Around each station the path is moved rigidly with its object or target. Between two stations
a correction is added that joins both ends with their speed and acceleration, the quintic,
which of all such corrections has the least squared jerk. Distance from the base's axis,
azimuth and height are corrected, not xyz, so that the way turns with the azimuth of object
and target and never cuts across the base.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, quat_inverse, quat_multiply, quat_to_rotvec
from assistant.learning.weights import least_jerk

Span = tuple[int, int]


@dataclass(frozen=True, slots=True, eq=False)
class Between:
    """The way from one stretch to the next, prepared once.

    Parameters
    ----------
    first, last : int
        Last sample of the one stretch, first of the other; those between are carried.
    hermite : array, shape (m, 6)
        Weights of value, slope and curvature (a sample's step being 1) at both ends.
    share : array, shape (m,)
        Share of the turn made.
    quats : array, shape (m, 4)
    around : array, shape (m, 3)
        Distance, azimuth and height; or xyz.
    near : array, shape (2, 3, 3)
        xyz of the three samples about each end.
    near_around : array, shape (2, 3, 3)
        The same as distance, azimuth and height.
    """

    first: int
    last: int
    hermite: Array
    share: Array
    quats: Array
    around: Array
    near: Array
    near_around: Array


@dataclass(frozen=True, slots=True, eq=False)
class Ways:
    """A learned path prepared for blending.

    Parameters
    ----------
    path : array, shape (n, 7)
    held : tuple of (first, last)
        Stretches that keep their shape: the start, each station, perhaps the end.
    middles : array, shape (len(held), 3)
        A place within each, whose azimuth the hand's turning follows.
    polar : bool
        Whether the way turns with the azimuth about the base.
    between : tuple of Between
        One fewer than `held`.
    """

    path: Array
    held: tuple[Span, ...]
    middles: Array
    polar: bool
    between: tuple[Between, ...]


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
    middles = np.array([path[last, :3] for _, last in held])
    return Ways(path, held, middles, polar, between)


def smooth_way(ways: Ways, moves: Array) -> Array:
    """Return the path with each held stretch moved rigidly and the ways between carried.

    Parameters
    ----------
    ways : Ways
    moves : array, shape (len(held), 7)
        How each stretch moves, in the world.

    Returns
    -------
    path : array, shape (n, 7)
        Exact on the held stretches. The hand turns with the azimuth of its surroundings, and
        relative to it along the shorter arc; a half turn relative to it is made to the left
        (counterclockwise seen from above).
    """
    out = np.empty_like(ways.path)
    matrices = _matrices(moves[:, 3:])
    lefts = _left_factors(moves[:, 3:])
    for k, (first, last) in enumerate(ways.held):
        stretch = slice(first, last + 1)
        out[stretch, :3] = ways.path[stretch, :3] @ matrices[k].T + moves[k, :3]
        out[stretch, 3:] = ways.path[stretch, 3:] @ lefts[k].T
    if ways.between:
        ends = _ends(ways, matrices, moves)
        azimuths, turns, axes, angles = _turns(ways, matrices, moves)
        for k, way in enumerate(ways.between):
            if way.last > way.first + 1:
                inside = slice(way.first + 1, way.last)
                out[inside, :3] = _places(way, ends[k], ways.polar)
                out[inside, 3:] = _turned(way, azimuths[k : k + 2], turns[k], axes[k], angles[k])
    return out


def _between(path: Array, around: Array, first: int, last: int) -> Between:
    length = max(last - first, 1)
    share = np.arange(1, length) / length
    inside = slice(first + 1, last)
    # Slope and curvature at an end are taken from its two neighbors; at the path's own ends
    # the sample itself stands in for the missing one.
    about = np.clip([[end - 1, end, end + 1] for end in (first, last)], 0, len(path) - 1)
    return Between(
        first,
        last,
        _hermite(share, length),
        least_jerk(share),
        path[inside, 3:].copy(),
        around[inside].copy(),
        path[about, :3].copy(),
        around[about].copy(),
    )


def _hermite(share: Array, length: int) -> Array:
    t = share
    t2, t3 = t * t, t * t * t
    last = t3 * (10.0 - 15.0 * t + 6.0 * t2)
    weights = [
        1.0 - last,
        length * (t - t3 * (6.0 - 8.0 * t + 3.0 * t2)),
        length**2 * (t2 / 2.0 - t3 * (1.5 - 1.5 * t + 0.5 * t2)),
        last,
        -length * t3 * (4.0 - 7.0 * t + 3.0 * t2),
        length**2 * t3 * (0.5 - t + 0.5 * t2),
    ]
    return np.stack(weights, axis=1)


def _ends(ways: Ways, matrices: Array, moves: Array) -> Array:
    """Return value, slope and curvature of the correction at both ends, shape (ways, 6, 3)."""
    near = np.array([way.near for way in ways.between])
    before = np.array([way.near_around for way in ways.between])
    turning = np.stack([matrices[:-1], matrices[1:]], axis=1)
    shift = np.stack([moves[:-1, :3], moves[1:, :3]], axis=1)
    moved = near @ turning.transpose(0, 1, 3, 2) + shift[:, :, None, :]
    if ways.polar:
        azimuth = np.arctan2(moved[..., 1], moved[..., 0])
        # The three neighbors lie together; only between stations may azimuths differ much.
        middle = azimuth[..., 1:2]
        azimuth = middle + (azimuth - middle + np.pi) % (2.0 * np.pi) - np.pi
        moved = np.stack([np.hypot(moved[..., 0], moved[..., 1]), azimuth, moved[..., 2]], axis=-1)
    change = moved - before
    values = change[:, :, 1]
    slopes = (change[:, :, 2] - change[:, :, 0]) / 2.0
    bends = change[:, :, 2] - 2.0 * values + change[:, :, 0]
    joined = np.stack([values, slopes, bends], axis=2)
    return joined.reshape(len(near), 6, 3)


def _places(way: Between, ends: Array, polar: bool) -> Array:
    carried = way.around + way.hermite @ ends
    if not polar:
        return np.asarray(carried)
    radius, azimuth = carried[:, 0], carried[:, 1]
    out = np.empty_like(carried)
    np.multiply(radius, np.cos(azimuth), out=out[:, 0])
    np.multiply(radius, np.sin(azimuth), out=out[:, 1])
    out[:, 2] = carried[:, 2]
    return out


def _turns(ways: Ways, matrices: Array, moves: Array) -> tuple[Array, Array, Array, Array]:
    """Return each stretch's change of azimuth, and between them the remaining turn.

    The turn of a stretch is its change of azimuth after a rest, D; between two of them D is
    led along the shorter arc, given here as D at the begin, the arc's axis and its angle.
    """
    azimuths = np.zeros(len(moves))
    if ways.polar:
        after = (matrices @ ways.middles[:, :, None])[:, :, 0] + moves[:, :3]
        before = ways.middles
        azimuths = np.arctan2(after[:, 1], after[:, 0]) - np.arctan2(before[:, 1], before[:, 0])
    back = np.zeros((len(moves), 4))
    back[:, 2], back[:, 3] = np.sin(-azimuths / 2.0), np.cos(azimuths / 2.0)
    rests = quat_multiply(back, moves[:, 3:])
    vectors = quat_to_rotvec(quat_multiply(quat_inverse(rests[:-1]), rests[1:]))
    angles = np.sqrt(np.sum(vectors * vectors, axis=1))
    half = angles > np.pi - 1e-9
    vectors = np.where((half & (vectors[:, 2] < 0.0))[:, None], -vectors, vectors)
    axes = vectors / np.where(angles < 1e-12, 1.0, angles)[:, None]
    return azimuths, rests[:-1], axes, angles


def _turned(way: Between, azimuths: Array, rest: Array, axis: Array, angle: float) -> Array:
    """Return the hand's quaternions on a way: azimuth, then the arc, then the learned turn."""
    about_z = (azimuths[0] + (azimuths[1] - azimuths[0]) * way.share) / 2.0
    along = (angle / 2.0) * way.share
    arc = quat_multiply(rest, np.append(axis, 0.0))
    # The product of both turns is a sum of four fixed quaternions with these weights.
    cos_z, sin_z, cos_a, sin_a = np.cos(about_z), np.sin(about_z), np.cos(along), np.sin(along)
    z = np.array([0.0, 0.0, 1.0, 0.0])
    terms = np.stack([rest, arc, quat_multiply(z, rest), quat_multiply(z, arc)])
    weights = np.stack([cos_z * cos_a, cos_z * sin_a, sin_z * cos_a, sin_z * sin_a])
    factors = _left_factors(terms)
    whole = way.quats @ factors.transpose(2, 0, 1).reshape(4, 16)
    return np.asarray(np.einsum("nij,in->nj", whole.reshape(-1, 4, 4), weights))


def _matrices(quats: Array) -> Array:
    x, y, z, w = quats.T
    rows = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    return np.asarray(rows.transpose(2, 0, 1))


def _left_factors(quats: Array) -> Array:
    """Return matrices, shape (m, 4, 4), that multiply a quaternion from the left."""
    x, y, z, w = quats.T
    rows = np.array([[w, -z, y, x], [z, w, -x, y], [-y, x, w, z], [-x, -y, -z, w]])
    return np.asarray(rows.transpose(2, 0, 1))
