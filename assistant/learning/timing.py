"""When the hand is where: the demonstration's own times, slower where a bound would be passed.

Source: paper III-C b ("motion information given in the demonstration and robot speed and
acceleration constraints"); design, "Whole-task motion".
"""

from __future__ import annotations

import numpy as np

from assistant.geometry import Array


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
    greatest_m_s, greatest_rad_s : float
        Speed and turning never exceed these.
    brake : int
        Number of samples over which slowing down is spread.

    Returns
    -------
    t_s : array, shape (n,)
        From 0.
    """
    t_s = np.concatenate([[0.0], np.cumsum(steps_s)])
    need = np.maximum(
        hand_speeds(t_s, path) / greatest_m_s, turn_speeds(t_s, path) / greatest_rad_s
    )
    if np.max(need, initial=0.0) <= 1.0:
        return t_s
    slower = _spread(np.maximum(need, 1.0), brake)
    return np.concatenate([[0.0], np.cumsum(steps_s * slower)])


def rms_jerk(xyz: Array, step_s: float) -> float:
    """Return the root-mean-square jerk of evenly sampled places, in m/s^3."""
    third = np.diff(xyz, n=3, axis=0) / step_s**3
    return float(np.sqrt(np.mean(np.sum(third * third, axis=1))))


def _spread(need: Array, width: int) -> Array:
    """Return a smooth curve nowhere below `need`: the mean of its greatest values nearby."""
    half = max(width // 2, 1)
    padded = np.pad(need, 2 * half, mode="edge")
    window = 2 * half + 1
    greatest = np.max(np.lib.stride_tricks.sliding_window_view(padded, window), axis=1)
    return np.convolve(greatest, np.full(window, 1.0 / window), mode="valid")
