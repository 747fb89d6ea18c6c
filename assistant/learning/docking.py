"""Docking poses, and the path altered so that docking is straight (paper III-C a, b)."""

from __future__ import annotations

import numpy as np

from assistant.geometry import (
    Array,
    compose,
    quat_from_rotvec,
    quat_inverse,
    quat_to_rotvec,
    relative,
    rotate_vector,
)
from assistant.learning.weights import least_jerk, quintic
from assistant.model.settings import GeneralizationSettings

_LEAST_SETTLING = 25
_WAY = 0.3
"""At least so much of what is traveled between two stations is a way."""
AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def axis_vector(name: str) -> Array:
    """Return the unit vector of an axis such as ``x`` or ``-z``."""
    vector = np.array(AXES[name[-1]])
    return -vector if name.startswith("-") else vector


def lateral_axis(approach_axis: str) -> Array:
    """Return the hand's lateral axis: the fingers' y, or x for a hand that approaches along y."""
    return axis_vector("x" if approach_axis.endswith("y") else "y")


def grasp_ways(approach_axis: str) -> Array:
    """Return the directions, shape (2, 3) in the hand's frame, open from docking to grasp.

    Source: paper III-C a: along the approach, and perpendicular to approach and lateral axes.
    """
    approach = axis_vector(approach_axis)
    return np.array([approach, np.cross(approach, lateral_axis(approach_axis))])


def release_ways(normal_in_world: Array, hand: Array) -> Array:
    """Return the direction, shape (1, 3) in the hand's frame, open from docking to release."""
    return rotate_vector(quat_inverse(hand[3:]), normal_in_world)[None, :]


def level(hand: Array) -> Array:
    """Return the turn about the vertical, shape (4,), of what a hand meets from side or above."""
    ahead = rotate_vector(hand[3:], np.array([1.0, 0.0, 1.0]))
    half = np.arctan2(ahead[1], ahead[0]) / 2.0
    return np.array([0.0, 0.0, np.sin(half), np.cos(half)])


def docking_sample(
    xyz: Array, at: int, suggested: int, earliest: int, settings: GeneralizationSettings
) -> int:
    """Return the sample of the docking pose before a grasp or release.

    Parameters
    ----------
    xyz : array, shape (n, 3)
    at : int
        Where the hand closes or opens.
    suggested : int
        Where the primitive that docks ends.
    earliest : int
        Docking is not sought before this sample, nor so soon after it that no way is left.
    settings : GeneralizationSettings
    """
    earliest = way_end(xyz, earliest, at)
    away = np.linalg.norm(xyz[earliest : at + 1] - xyz[at], axis=1)
    inside = min(suggested - earliest, len(away) - 1)
    if inside >= 0 and settings.docking_near_m <= away[inside] <= settings.docking_far_m:
        return earliest + inside
    # Otherwise where the hand last came within the usual distance.
    outside = np.flatnonzero(away > settings.docking_m)
    return earliest + (int(outside[-1]) + 1 if len(outside) else 0)


def way_end(xyz: Array, earliest: int, at: int) -> int:
    """Return the first sample up to which enough of what is traveled is a way."""
    steps = np.linalg.norm(np.diff(xyz[earliest : at + 1], axis=0), axis=1)
    travel = np.concatenate([[0.0], np.cumsum(steps)])
    return earliest + int(np.searchsorted(travel, _WAY * travel[-1]))


def straightened(
    path: Array,
    at: int,
    docking_at: int,
    ways: Array,
    earliest: int,
    settle_m: float,
    least_m: float = 0.0,
) -> Array:
    """Return the path with everything docking forbids taken out from docking to `at`.

    Before docking it is led away over `settle_m` of path with least jerk, joining place, speed
    and acceleration at both ends, so that the transition stays smooth.

    Parameters
    ----------
    path : array, shape (n, 7)
    at, docking_at, earliest : int
        The altered stretch lies between `earliest` and `at`.
    ways : array, shape (k, 3)
        Orthogonal directions allowed, in the hand's frame at `at`.
    settle_m : float
    least_m : float
        Docking is at least so far away along the only direction allowed: a hand that came from
        the side is led there instead.
    """
    stretch = slice(earliest, at + 1)
    docking = docking_at - earliest
    seen = relative(path[at], path[stretch])
    turns = quat_to_rotvec(seen[:, 3:])
    stray = np.hstack([seen[:, :3] - (seen[:, :3] @ ways.T) @ ways, turns])
    change = -stray
    if len(ways) == 1 and np.linalg.norm(seen[docking, :3]) >= least_m:
        lift = _lifted(seen[:, :3] @ ways[0], docking, least_m)
        change[:, :3] += lift[:, None] * ways[0]
    joined = change[[max(docking - 1, 0), docking, min(docking + 1, len(stray) - 1)]]
    change[:docking] = 0.0
    begin = _settling(path[stretch, :3], docking, settle_m)
    if docking > begin:
        ends = [joined[1], (joined[2] - joined[0]) / 2.0, joined[0] - 2.0 * joined[1] + joined[2]]
        share = np.arange(docking - begin) / (docking - begin)
        change[begin:docking] = quintic(share, docking - begin)[:, 3:] @ np.array(ends)
    kept = np.hstack([seen[:, :3] + change[:, :3], quat_from_rotvec(turns + change[:, 3:])])
    out = path.copy()
    out[stretch] = compose(path[at], kept)
    return out


def _lifted(heights: Array, docking: int, least_m: float) -> Array:
    """Return how much further away a path is led so that its docking is not too near, shape (n,).

    From docking on it comes nearer with least jerk. What comes from beyond is left as it is.
    """
    lacking_m = least_m - float(heights[docking])
    if not 0.0 < lacking_m < 2.0 * least_m:
        return np.zeros(len(heights))
    after = (np.arange(len(heights)) - docking) / max(len(heights) - 1 - docking, 1)
    return np.asarray(lacking_m * (1.0 - least_jerk(np.clip(after, 0.0, 1.0))))


def _settling(xyz: Array, docking: int, settle_m: float) -> int:
    """Return the sample from which the path settles, at least half a second before docking."""
    steps = np.linalg.norm(np.diff(xyz[: docking + 1], axis=0), axis=1)
    travel = np.concatenate([[0.0], np.cumsum(steps)])
    begin = int(np.searchsorted(travel, travel[-1] - settle_m))
    return max(min(begin, docking - _LEAST_SETTLING), 0)
