"""When the hand is where: the demonstration's own times, slower where a bound would be passed.

A way that grew takes longer than shown. What its slowing costs is won back, as far as can be,
where the hand was shown below its greatest speed: it is hurried there, gains speed no quicker
than the demonstration somewhere did, and the way as a whole is never quicker than shown.

Source: paper III-C b ("motion information given in the demonstration and robot speed and
acceleration constraints"); design, "Whole-task motion".
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array

_SUMMED = np.repeat(np.eye(2), (3, 4), axis=1)
"""Sums up the columns of place and those of turn."""
_ALONG = np.ones(3)
_NEARLY = 1e-30
_WORTH = 0.04
"""Less than this share of a way's time is not worth hurrying: smoothing takes as much."""


@dataclass(frozen=True, slots=True, eq=False)
class Hurry:
    """Where and how far the hand may be hurried on ways that grew.

    Parameters
    ----------
    ways : tuple of slice
        Steps of each way that may take no less time than shown as a whole.
    least : array, shape (n - 1,)
        Share of its own time that a step lasts at least; 1 where it is never hurried.
    greatest_m_s2 : float
        Hurried, the hand is accelerated about no more than this.
    """

    ways: tuple[slice, ...]
    least: Array
    greatest_m_s2: float


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
    steps_s: Array,
    path: Array,
    greatest_m_s: float,
    greatest_rad_s: float,
    brake: int,
    hurry: Hurry | None = None,
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
    hurry : Hurry, optional
        Without it no step is shorter than it should be.

    Returns
    -------
    t_s : array, shape (n,)
        From 0.
    """
    t_s = np.empty(len(path))
    t_s[0] = 0.0
    columns = path.T
    moved = columns[:, 1:] - columns[:, :-1]
    need = _need(steps_s, moved, greatest_m_s, greatest_rad_s)
    much = np.flatnonzero(need > 1.0)
    if not len(much):
        np.cumsum(steps_s, out=t_s[1:])
        return t_s
    wanted = np.maximum(need, 1.0)
    begin, end = int(much[0]), int(much[-1])
    if hurry is not None:
        for way in _hurried(wanted, need, steps_s, moved[:3], hurry):
            begin, end = min(begin, way.start), max(end, way.stop)
    # Elsewhere nothing changes: it reaches from a window before the first to one after the last.
    reach = 2 * max(brake // 2, 1)
    inside = slice(max(begin - reach, 0), end + reach + 1)
    lasting = steps_s.copy()
    lasting[inside] *= _spread(wanted[inside], brake)
    np.cumsum(lasting, out=t_s[1:])
    return t_s


def _need(steps_s: Array, moved: Array, greatest_m_s: float, greatest_rad_s: float) -> Array:
    """Return how much longer each step must at least last, shape (n - 1,); 1 is as it is."""
    squares = np.matmul(_SUMMED, moved * moved)
    chords: Array = squares[1]
    # Of both signs of a rotation the nearer counts.
    np.minimum(chords, 4.0 - chords, out=chords)
    # An angle by its chord is the greater, the greater the chord.
    widest = math.sqrt(max(float(np.max(chords, initial=0.0)), _NEARLY))
    by_chord = 4.0 * math.asin(min(widest / 2.0, 1.0)) / widest
    squares[0] *= 1.0 / (greatest_m_s * greatest_m_s)
    chords *= (by_chord / greatest_rad_s) ** 2
    need: Array = np.sqrt(np.maximum(squares[0], chords))
    need /= steps_s
    return need


def _hurried(wanted: Array, need: Array, steps_s: Array, moved: Array, hurry: Hurry) -> list[slice]:
    """Let ways that grew take less than is `wanted`, nowhere below `need`; return which do."""
    grew = [
        (way, over_s)
        for way in hurry.ways
        if (over_s := float(np.vdot(wanted[way], steps_s[way])) - float(np.sum(steps_s[way]))) > 0.0
    ]
    if not grew:
        return []
    bends = moved[:, 1:] - moved[:, :-1]
    bends *= bends
    least = np.sqrt(np.sqrt(_ALONG @ bends) * (1.0 / hurry.greatest_m_s2))
    least /= steps_s[1:]
    spared = np.maximum(need, hurry.least)
    # A bend between two steps bounds both.
    np.maximum(spared[1:], least, out=spared[1:])
    np.maximum(spared[:-1], least, out=spared[:-1])
    np.subtract(wanted, spared, out=spared)
    np.maximum(spared, 0.0, out=spared)
    hurried = []
    for way, over_s in grew:
        whole_s = float(np.vdot(spared[way], steps_s[way]))
        if min(over_s, whole_s) > _WORTH * float(np.sum(steps_s[way])):
            wanted[way] -= min(over_s / whole_s, 1.0) * spared[way]
            hurried.append(way)
    return hurried


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
    # One value more in front: sums of runs are differences of sums from the beginning.
    padded = np.empty(len(need) + 2 * half + 1)
    padded[half + 1 : -half] = need
    padded[: half + 1], padded[-half:] = need[0], need[-1]
    mean = _mean(padded, window)
    lacks = np.empty(len(need) + 4 * half + 1)
    inner = lacks[2 * half + 1 : -2 * half]
    np.subtract(need, mean, out=inner)
    np.maximum(inner, 0.0, out=inner)
    lacks[: 2 * half + 1], lacks[-2 * half :] = inner[0], inner[-1]
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
    """Return the mean of each run of so many values but the first."""
    summed = np.cumsum(values)
    mean: Array = summed[window:] - summed[:-window]
    mean *= 1.0 / window
    return mean
