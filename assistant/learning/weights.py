"""Blending weights lambda1 and lambda2 along a path (paper III-D a, Fig. 5).

Both are a six-order polynomial of the distance traveled, so that they come and go without a
kink: lambda1 belongs to the frame of the object or target the hand is at, lambda2 to where
the hand comes from.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from assistant.geometry import Array
from assistant.model.settings import BlendingSettings


def six_order(share: ArrayLike) -> Array:
    """Return the weight of a share of the way: 0 at 0, 1 at 1, clipped outside.

    First and second derivatives vanish at both ends, the third at 1, where the hand docks.
    Source: design, "Blending"; adapted from the paper's [28].
    """
    s = np.clip(np.asarray(share, dtype=float), 0.0, 1.0)
    # Rounding would let the sum pass 1 by a digit near the end.
    weight = s**3 * (20.0 + s * (-45.0 + s * (36.0 - 10.0 * s)))
    return np.asarray(np.minimum(weight, 1.0))


def least_jerk(share: ArrayLike) -> Array:
    """Return the share of a displacement made by a share of the time, with least jerk."""
    s = np.clip(np.asarray(share, dtype=float), 0.0, 1.0)
    return np.asarray(s**3 * (10.0 + s * (-15.0 + 6.0 * s)))


@dataclass(frozen=True, slots=True, eq=False)
class FrameWeights:
    """Weights of every sample, and whose frames they belong to.

    Parameters
    ----------
    lambda1, lambda2 : array, shape (n,)
    near : array of int, shape (n,)
        Station whose frame lambda1 weighs.
    left : array of int, shape (n,)
        Station whose frame lambda2 weighs; -1 for where the robot started.
    """

    lambda1: Array
    lambda2: Array
    near: np.ndarray[tuple[int], np.dtype[np.int64]]
    left: np.ndarray[tuple[int], np.dtype[np.int64]]


def frame_weights(
    xyz: Array, stretches: tuple[tuple[int, int], ...], settings: BlendingSettings | None = None
) -> FrameWeights:
    """Return lambda1 and lambda2 for a path with any number of stations.

    Parameters
    ----------
    xyz : array, shape (n, 3)
        The learned path.
    stretches : tuple of (docking_at, at)
        Samples of each station, in order: docking pose, and hand closed or opened.
    settings : BlendingSettings, optional

    Notes
    -----
    Source: paper III-D a, eq. (6). Differs: after a grasp lambda1 falls back smoothly, still
    in the object's frame, while lambda2 is 1 in that same frame, so the path has no jump.
    """
    settings = settings or BlendingSettings()
    travel = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(xyz, axis=0), axis=1))])
    samples = len(xyz)
    lambda1, lambda2 = np.zeros(samples), np.zeros(samples)
    near, left = np.zeros(samples, dtype=np.int64), np.full(samples, -1, dtype=np.int64)
    begin = 0
    for station, (docking_at, at) in enumerate(stretches):
        way = slice(begin, docking_at + 1)
        share = _share(travel[way])
        rise = six_order((share - settings.rise_from) / (1.0 - settings.rise_from))
        fall = 1.0 - six_order(share / settings.fall_by)
        old = (station > 0) & (share < settings.fall_by)
        lambda1[way] = np.where(old, fall, rise)
        lambda2[way] = 1.0 - six_order(share / settings.depart_by)
        near[way] = np.where(old, station - 1, station)
        left[begin : at + 1] = station - 1
        lambda1[docking_at : at + 1] = 1.0
        near[docking_at : at + 1] = station
        begin = at
    if stretches:
        lambda1[begin:], near[begin:], left[begin:] = 1.0, len(stretches) - 1, len(stretches) - 1
    return FrameWeights(lambda1, lambda2, near, left)


def _share(travel: Array) -> Array:
    whole = float(travel[-1] - travel[0])
    if whole <= 0.0:
        return np.linspace(0.0, 1.0, len(travel))
    return np.asarray((travel - travel[0]) / whole)


def quintic(share: Array, length: int) -> Array:
    """Return the weights, shape (m, 6), of a correction's ends at shares of the way.

    Columns: value, slope and curvature where it begins, then where it ends, a sample's step
    being 1 and the way `length` steps. Of all curves with these ends the sum has least jerk.
    """
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
