"""When the hand is where: the demonstration's own times, slower where a bound would be passed.

Source: paper III-C b ("motion information given in the demonstration and robot speed and
acceleration constraints"); design, "Whole-task motion".
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from assistant.geometry import Array

_SUMMED = np.repeat(np.eye(2), (3, 4), axis=1)
"""Sums up the columns of place and those of turn."""
_MOST_TURN = math.pi / math.sqrt(2.0)
"""Half a turn by its chord, to the nearer sign of its quaternion: no turn has a larger one."""


def hand_speeds(t_s: Array, path: Array) -> Array:
    """Return the speed of the flange between samples in m/s, shape (n - 1,)."""
    steps = np.diff(path[:, :3], axis=0)
    return np.asarray(np.sqrt(np.sum(steps * steps, axis=1)) / np.diff(t_s))


def turn_speeds(t_s: Array, path: Array) -> Array:
    """Return how fast the hand turns between samples in rad/s, shape (n - 1,)."""
    # A chord of unit quaternions is twice the sine of a quarter of the angle; of both signs of
    # a rotation the nearer counts.
    first, second = path[:-1, 3:], path[1:, 3:]
    apart, across = np.sum((second - first) ** 2, axis=1), np.sum((second + first) ** 2, axis=1)
    half = np.sqrt(np.minimum(apart, across))
    return np.asarray(4.0 * np.arcsin(np.minimum(half / 2.0, 1.0)) / np.diff(t_s))


def bounded_times(
    steps_s: Array, path: Array, greatest_m_s: float, greatest_rad_s: float, brake: int
) -> Array:
    """Return the times of the samples, slowed down smoothly where a bound would be passed.

    Parameters
    ----------
    steps_s : array, shape (n - 1,)
        Times between samples as they should be.
    path : array, shape (n, 7)
        Quaternions may change their sign: both are one rotation.
    greatest_m_s, greatest_rad_s : float
        Speed and turning never exceed these.
    brake : int
        Number of samples over which slowing down is spread.

    Returns
    -------
    t_s : array, shape (n,)
        From 0.
    """
    t_s = np.empty(len(path))
    t_s[0] = 0.0
    need = _need_squared(steps_s, path, greatest_m_s, greatest_rad_s)
    much = np.flatnonzero(need > 1.0)
    if not len(much):
        np.cumsum(steps_s, out=t_s[1:])
        return t_s
    # Elsewhere nothing changes: it reaches from a window before the first to one after the last.
    reach = 2 * max(brake // 2, 1)
    inside = slice(max(int(much[0]) - reach, 0), int(much[-1]) + reach + 1)
    slower = steps_s.copy()
    slower[inside] *= _spread(np.sqrt(np.maximum(need[inside], 1.0)), brake)
    np.cumsum(slower, out=t_s[1:])
    return t_s


def _need_squared(steps_s: Array, path: Array, greatest_m_s: float, greatest_rad_s: float) -> Array:
    """Return how much longer each step must at least last, squared; 1 is as it is.

    Shape (n - 1,). Where that is no more than 1 it may be too little.
    """
    columns = path.T
    steps = columns[:, 1:] - columns[:, :-1]
    steps *= steps
    speeds = np.matmul(_SUMMED, steps)
    speeds /= steps_s * steps_s
    need: Array = speeds[0]
    need *= 1.0 / (greatest_m_s * greatest_m_s)
    # As in `turn_speeds`, a turn is at most so many times its chord.
    if _MOST_TURN**2 * float(np.max(speeds[1], initial=0.0)) <= greatest_rad_s**2:
        return need
    turning = turn_speeds(np.concatenate([[0.0], np.cumsum(steps_s)]), path) / greatest_rad_s
    return np.maximum(need, turning * turning)


def resting_steps(t_s: Array, acts: Sequence[int], dwell_s: float) -> Array:
    """Return which steps between samples lie in the rests around given samples, bool (n - 1,)."""
    middles = (t_s[1:] + t_s[:-1]) / 2.0
    resting = np.zeros(len(middles), dtype=bool)
    for at in acts:
        resting |= np.abs(middles - t_s[at]) <= dwell_s / 2.0
    return resting


def rms_jerk(xyz: Array, step_s: float) -> float:
    """Return the root-mean-square jerk of evenly sampled places, in m/s^3."""
    third = np.diff(xyz, n=3, axis=0) / step_s**3
    return float(np.sqrt(np.mean(np.sum(third * third, axis=1))))


def _spread(need: Array, width: int) -> Array:
    """Return a smooth curve nowhere below `need`: its mean nearby, and what that lacks spread."""
    half = max(width // 2, 1)
    window = 2 * half + 1
    padded = np.empty(len(need) + 2 * half)
    padded[half:-half] = need
    padded[:half], padded[-half:] = need[0], need[-1]
    mean = _mean(padded, window)
    lacks = np.empty(len(need) + 4 * half)
    lacks[2 * half : -2 * half] = np.maximum(need - mean, 0.0)
    lacks[: 2 * half], lacks[-2 * half :] = lacks[2 * half], lacks[-2 * half - 1]
    # The greatest of ever longer runs, each joined from two shorter ones.
    length = 1
    while length < window:
        ahead = min(length, window - length)
        lacks = np.maximum(lacks[:-ahead], lacks[ahead:])
        length += ahead
    mean += _mean(lacks, window)
    # Rounding must not take it below.
    return np.maximum(mean, need, out=mean)


def _mean(values: Array, window: int) -> Array:
    """Return the mean of each run of so many values."""
    summed = np.cumsum(values)
    mean = summed[window - 1 :].copy()
    mean[1:] -= summed[:-window]
    mean *= 1.0 / window
    return mean
