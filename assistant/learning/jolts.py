"""Jolts: what the gripper does to the wrist, a signal where the gripper is not recorded.

A gripper that meets a thing, or lets it go, turns the wrist of a resting hand for a fraction
of a second. Letting go jolts as the fingers set out; gripping jolts when they have arrived,
mostly after half their travel. Which of the two a jolt is shows in what follows (a hand that
has let go draws back) and in its sense: fingers that open turn the wrist the other way.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter1d, median_filter
from scipy.signal import find_peaks

from assistant.geometry import Array, quat_inverse, quat_multiply, quat_to_rotvec
from assistant.learning.smoothing import Smoothed, distinct
from assistant.model.demonstration import Recording
from assistant.model.motion import Indices
from assistant.model.settings import JoltSettings

_FEWEST_SAMPLES = 20


def jolts(recording: Recording, smoothed: Smoothed, settings: JoltSettings) -> Array:
    """Return instants and strengths, shape (k, 2), at which jolts say the gripper acted.

    Strengths are in local medians of the turning rate. The tracked orientation is used,
    hardly smoothed: what lasts a quarter of a second is noise to the smoother.
    """
    t_s, path, _ = distinct(recording, settings.most_samples)
    steps = np.diff(t_s)
    known = recording.gripper_m is not None
    if known or len(t_s) < _FEWEST_SAMPLES or np.median(steps) > settings.longest_step_s:
        return np.zeros((0, 2))
    step = float(np.median(steps))
    turns = quat_to_rotvec(quat_multiply(quat_inverse(path[:-1, 3:]), path[1:, 3:]))
    at_s = 0.5 * (t_s[:-1] + t_s[1:])
    speed = np.interp(at_s, smoothed.t_s, smoothed.speed)
    rates = turns / np.maximum(steps, 0.5 * step)[:, None]
    first, _ = _peaks(rates, speed, step, settings)
    if len(first) == 0:
        return np.zeros((0, 2))
    # The same fingers turn the wrist about the same axis: along it, weaker jolts stand out.
    axis = np.linalg.svd(_senses(first, turns, step), full_matrices=False)[2][:1]
    peaks, rises = _peaks(rates @ axis.T, speed, step, settings)
    opening = _opening(peaks, _senses(peaks, turns, step) @ axis[0], speed, step)
    shift = opening * settings.open_after_s - (1.0 - opening) * settings.close_before_s
    return np.stack([at_s[peaks] + shift, rises], axis=1)


def _peaks(
    rates: Array, speed: Array, step_s: float, settings: JoltSettings
) -> tuple[Indices, Array]:
    """Return where the turning, shape (n, axes), rises above its usual, and how far."""
    turning = np.linalg.norm(gaussian_filter1d(rates, settings.width_s / step_s, axis=0), axis=1)
    window = max(int(settings.window_s / step_s) | 1, 3)
    moving = np.maximum(median_filter(speed, window) / (np.median(speed) + 1e-9), 1.0)
    usual = median_filter(turning, window) + 0.5 * float(np.median(turning)) + 1e-3
    rise = (turning / usual - 1.0) / moving
    found, _ = find_peaks(rise, height=settings.least, distance=max(int(0.4 / step_s), 1))
    return found.astype(np.int64), rise[found]


def _senses(peaks: Indices, turns: Array, step_s: float) -> Array:
    """Return the rotation vector of each jolt as a whole, shape (k, 3)."""
    reach = max(int(0.3 / step_s), 1)
    return np.array([np.sum(turns[max(at - reach, 0) : at + reach + 1], axis=0) for at in peaks])


def _opening(peaks: Indices, sense: Array, speed: Array, step_s: float) -> Array:
    """Return the probability that the hand opened, for each jolt, shape (k,)."""
    beyond = max(int(1.5 / step_s), 1)
    drawn = np.zeros(len(peaks))
    for k, at in enumerate(peaks):
        before = np.max(speed[max(at - beyond, 0) : at + 1])
        drawn[k] = np.log((np.max(speed[at : at + beyond]) + 1e-4) / (before + 1e-4)) - np.log(2.0)
    clear = np.clip(drawn, -1.5, 1.5)
    alike = float(np.mean(np.sign(sense) * clear)) if len(peaks) > 1 else 0.0
    return np.asarray(1.0 / (1.0 + np.exp(-2.0 * (clear + 2.0 * np.sign(sense) * alike))))
