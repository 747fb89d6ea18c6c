"""Corrects a motion after the grasp, by where the body was seen to sit in the hand.

The release moves by the difference between where the body sits and where the plan supposed
it; the difference comes in smoothly between lifting and docking, so that the last stretch to
the target keeps its direction. The corrected motion is checked again: reach, limits, speeds
and collision. Where all of it cannot be done, a part is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from assistant.geometry import (
    IDENTITY,
    Array,
    angle_between,
    compose,
    interpolate,
    inverse,
)
from assistant.model.motion import HandStop, JointPath
from sim import a465
from sim.kinematics import BRANCHES, forward, inverse_all, limit_margin
from sim.world import Fault

LARGEST_M = 0.010
LARGEST_RAD = np.deg2rad(8.0)
"""A body that sits further off than this was not grasped as planned: the run is halted."""

SHARES = (1.0, 0.75, 0.5, 0.25)
"""Of a correction, tried in this order."""
FINE_M, FINE_RAD = 2e-4, np.deg2rad(0.1)


def release_offset(supposed: Array, seen: Array) -> Array | None:
    """Return the pose to append to the flange at release, shape (7,); None if it is too large.

    Parameters
    ----------
    supposed, seen : array, shape (7,)
        The body's base in the flange's frame, as planned and as the sensor tells.
    """
    offset = compose(supposed, inverse(seen))
    away_m, turned_rad = _apart(offset)
    return None if away_m > LARGEST_M or turned_rad > LARGEST_RAD else offset


def slipped(name: str, supposed: Array, seen: Array) -> Fault:
    """Return what halts a run whose body sits elsewhere in the hand than can be corrected.

    Parameters
    ----------
    name : str
    supposed, seen : array, shape (7,)
        As for `release_offset`.
    """
    away_m, turned_rad = _apart(compose(supposed, inverse(seen)))
    if away_m > LARGEST_M:
        return Fault("slipped", name, amount=1000.0 * away_m, unit="mm")
    return Fault("slipped", name, amount=float(np.rad2deg(turned_rad)), unit="deg")


def _apart(offset: Array) -> tuple[float, float]:
    return float(np.linalg.norm(offset[:3])), float(angle_between(offset, IDENTITY))


def checked(
    motion: JointPath,
    offset: Array,
    begin: int,
    full: int,
    stop: HandStop,
    free: Callable[[JointPath], bool],
) -> tuple[JointPath, Array] | None:
    """Return the motion with as much of a correction as can be done, and that much of it.

    Parameters
    ----------
    motion, offset, begin, full, stop
        As in `corrected`.
    free : callable
        Whether a motion touches nothing.

    Returns
    -------
    motion, offset : JointPath and array, shape (7,)
        None where not even a quarter can be done.
    """
    for share in SHARES:
        part = interpolate(IDENTITY, offset, np.array(share))
        # Where the hand cannot leave as corrected it comes back to the plan as it leaves.
        for kept in (stop.left_at, stop.at):
            better = corrected(motion, part, begin, full, stop, kept)
            if better is not None and free(better):
                return better, part
    return None


def matters(offset: Array) -> bool:
    """Return whether a body that is off by so much does not lie finely any more."""
    far = float(np.linalg.norm(offset[:3])) > FINE_M
    return far or float(angle_between(offset, IDENTITY)) > FINE_RAD


def corrected(
    motion: JointPath, offset: Array, begin: int, full: int, stop: HandStop, kept: int | None = None
) -> JointPath | None:
    """Return the motion with its release moved by an offset; None if that cannot be done.

    Parameters
    ----------
    motion : JointPath
    offset : array, shape (7,)
        In the flange's frame, see `release_offset`.
    begin, full : int
        Samples from which the offset may come in, and by which it must be there.
    stop : HandStop
        The release.
    kept : int, optional
        The sample up to which the offset is kept; where the hand has left if not given. An
        offset that is given up earlier is gone by then.
    """
    last = _next_start(motion, stop)
    q = np.array(motion.q)
    part = slice(begin, last)
    samples = np.arange(begin, last, dtype=float)
    kept = stop.left_at if kept is None else kept
    gone = stop.left_at if kept < stop.left_at else last - 1
    weight = _ramp(samples, begin, full, kept, gone)
    # Only from docking on must the hand be exactly there; on its way the joints drift along.
    first, left = min(max(begin, stop.docking_at), stop.at), min(stop.left_at, last - 1)
    exact = slice(first, left + 1)
    poses = interpolate(IDENTITY, offset, weight[first - begin : left + 1 - begin])
    q[exact] = _nearest(compose(forward(q[exact]), poses), q[exact])
    before, after = slice(begin, first), slice(left + 1, last)
    for free, sample in ((before, first), (after, left)):
        drift = weight[free.start - begin : free.stop - begin, None]
        drifted = motion.q[free] + drift * (q[sample] - motion.q[sample])
        q[free] = np.clip(drifted, -a465.LIMITS, a465.LIMITS)
    if not _still_good(q, motion, part):
        return None
    margin = float(np.rad2deg(np.min(limit_margin(q))))
    return replace(motion, q=q, joint_margin_deg=min(margin, motion.joint_margin_deg))


def _next_start(motion: JointPath, stop: HandStop) -> int:
    later = [other.docking_at for other in motion.stops if other.at > stop.at]
    return min([*later, len(motion.t_s)])


def _ramp(samples: Array, begin: int, full: int, fall: int, end: int) -> Array:
    rise = np.clip((samples - begin) / max(full - begin, 1), 0.0, 1.0)
    away = np.clip((samples - fall) / max(end - fall, 1), 0.0, 1.0)
    if end <= fall:
        away = np.zeros_like(rise)
    share = rise - away
    return np.asarray(share**3 * (10.0 - 15.0 * share + 6.0 * share**2))


def _nearest(poses: Array, q: Array) -> Array:
    answers = inverse_all(poses)
    turns = np.rint((q[:, None, :] - answers) / (2.0 * np.pi))
    answers = answers + 2.0 * np.pi * turns
    gaps = np.max(np.abs(answers - q[:, None, :]), axis=-1)
    gaps = np.where(np.isnan(gaps), np.inf, gaps)
    best = np.argmin(gaps, axis=-1)
    assert answers.shape[1] == BRANCHES
    return np.asarray(answers[np.arange(len(q)), best])


def _still_good(q: Array, motion: JointPath, part: slice) -> bool:
    if not np.all(np.isfinite(q)) or float(np.min(limit_margin(q[part]))) < 0.0:
        return False
    steps = np.diff(motion.t_s)[:, None]
    speed = np.abs(np.diff(q, axis=0)) / steps
    planned = np.abs(np.diff(motion.q, axis=0)) / steps
    # Where the plan itself is at its bound, the correction may not add to it noticeably.
    return bool(np.all(speed <= np.maximum(a465.SPEEDS, 1.02 * planned)))
