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
    if not len(steps_s):
        return _times(steps_s)
    columns = path.T
    moved = columns[:, 1:] - columns[:, :-1]
    need = _need(steps_s, moved, greatest_m_s, greatest_rad_s)
    much = need > 1.0
    begin, end = int(much.argmax()), len(much) - int(much[::-1].argmax())
    if not much[begin]:
        return _times(steps_s)
    half = max(brake // 2, 1)
    roomy = np.empty(len(need) + 6 * half + 2)
    wanted: Array = np.maximum(need, 1.0, out=_inner(roomy, half))
    if hurry is not None:
        for way in _hurried(wanted, need, steps_s, moved[:3], hurry):
            begin, end = min(begin, way.start), max(end, way.stop)
    roomy[: 3 * half + 2], roomy[-3 * half :] = wanted[0], wanted[-1]
    # Elsewhere nothing changes: it reaches from a window before the first to one after the last.
    begin, end = max(begin - 2 * half, 0), min(end + 2 * half, len(need))
    lasting = steps_s.copy()
    lasting[begin:end] *= _spread(roomy[begin : end + 6 * half + 2], half)
    return _times(lasting)


def _times(lasting: Array) -> Array:
    """Return the times of samples from what the steps between them last."""
    t_s = np.empty(len(lasting) + 1)
    t_s[0] = 0.0
    np.add.accumulate(lasting, out=t_s[1:])
    return t_s


def _need(steps_s: Array, moved: Array, greatest_m_s: float, greatest_rad_s: float) -> Array:
    """Return how much longer each step must at least last, shape (n - 1,); 1 is as it is."""
    squares: Array = _SUMMED.dot(moved * moved)
    need: Array = squares[0]
    chords: Array = squares[1]
    widest = float(chords[chords.argmax()])
    if widest > 2.0:
        # Of both signs of a rotation the nearer counts.
        np.minimum(chords, 4.0 - chords, out=chords)
        widest = float(chords[chords.argmax()])
    # An angle by its chord is the greater, the greater the chord.
    widest = math.sqrt(max(widest, _NEARLY))
    by_chord = 4.0 * math.asin(min(widest / 2.0, 1.0)) / widest
    chords *= (by_chord * greatest_m_s / greatest_rad_s) ** 2
    np.maximum(need, chords, out=need)
    np.sqrt(need, out=need)
    need *= 1.0 / greatest_m_s
    need /= steps_s
    return need


def _hurried(wanted: Array, need: Array, steps_s: Array, moved: Array, hurry: Hurry) -> list[slice]:
    """Let ways that grew take less than is `wanted`, nowhere below `need`; return which do."""
    grew = []
    for way in hurry.ways:
        shown_s = float(np.add.reduce(steps_s[way]))
        over_s = float(wanted[way].dot(steps_s[way])) - shown_s
        if over_s > _WORTH * shown_s:
            grew.append((way, shown_s, over_s))
    if not grew:
        return []
    begin, end = max(grew[0][0].start - 1, 0), grew[-1][0].stop + 1
    spared = np.empty(len(wanted))
    spared[begin:end] = _spared(wanted, need, steps_s, moved, hurry, slice(begin, end))
    hurried = []
    for way, shown_s, over_s in grew:
        whole_s = float(spared[way].dot(steps_s[way]))
        if whole_s > _WORTH * shown_s:
            wanted[way] -= min(over_s / whole_s, 1.0) * spared[way]
            hurried.append(way)
    return hurried


def _spared(
    wanted: Array, need: Array, steps_s: Array, moved: Array, hurry: Hurry, steps: slice
) -> Array:
    """Return how much less than is `wanted` each of some steps could take."""
    moved = moved[:, steps]
    bends = moved[:, 1:] - moved[:, :-1]
    bends *= bends
    bent = _ALONG.dot(bends)
    bent *= 1.0 / hurry.greatest_m_s2**2
    np.sqrt(bent, out=bent)
    np.sqrt(bent, out=bent)
    bent /= steps_s[steps][1:]
    spared: Array = np.maximum(need[steps], hurry.least[steps])
    # A bend between two steps bounds both.
    np.maximum(spared[1:], bent, out=spared[1:])
    np.maximum(spared[:-1], bent, out=spared[:-1])
    np.subtract(wanted[steps], spared, out=spared)
    return np.maximum(spared, 0.0, out=spared)


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


def _inner(roomy: Array, half: int) -> Array:
    """Return the steps themselves of values with room for what `_spread` looks at around them."""
    return roomy[3 * half + 2 : -3 * half]


def _spread(roomy: Array, half: int) -> Array:
    """Return a smooth curve nowhere below what is needed: its mean nearby, and what that lacks.

    What it lacks is spread, too. The values have room around them, see `_inner`.
    """
    window = 2 * half + 1
    mean = _mean(roomy, window)
    lacks = roomy[half + 1 : -half] - mean
    np.maximum(lacks, 0.0, out=lacks)
    # The greatest of ever longer runs, each joined from two shorter ones.
    length = 1
    while length < window:
        ahead = min(length, window - length)
        lacks = np.maximum(lacks[:-ahead], lacks[ahead:])
        length += ahead
    curve = _mean(lacks, window)
    curve += mean[window : 1 - window]
    # Rounding must not take it below.
    return np.maximum(curve, _inner(roomy, half), out=curve)


def _mean(values: Array, window: int) -> Array:
    """Return the mean of each run of so many values but the first."""
    summed = np.add.accumulate(values)
    mean: Array = summed[window:] - summed[:-window]
    mean *= 1.0 / window
    return mean
