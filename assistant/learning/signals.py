"""What single signals propose as cuts: gripper, speed, jolts of the hand (paper III-A).

A new signal is one function from the motion to the instants it proposes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.ndimage import gaussian_filter1d, median_filter
from scipy.signal import find_peaks

from assistant.geometry import Array, angle_between
from assistant.learning.smoothing import Smoothed, distinct
from assistant.model.demonstration import Recording
from assistant.model.settings import SignalSettings


@dataclass(frozen=True, slots=True)
class GripperEvent:
    """The hand opened or closed; `at_s` is where the opening crossed half its travel."""

    at_s: float
    kind: Literal["close", "open"]


@dataclass(frozen=True, slots=True)
class Minimum:
    """A local minimum of the speed or a whole rest.

    Parameters
    ----------
    at_s : float
        The middle of the rest, or the minimum itself.
    depth : float
        How far the speed rises on both sides before it falls as low again, in log speed.
    from_s, to_s : float
        The rest; equal where the hand only slows down.
    """

    at_s: float
    depth: float
    from_s: float
    to_s: float


def pace(smoothed: Smoothed, settings: SignalSettings) -> Array:
    """Return the speed of the pose in m/s, shape (n,): turning joined by the stated weight."""
    turning = np.linalg.norm(smoothed.turn_rate, axis=1)
    return np.asarray(np.hypot(smoothed.speed, settings.turn_weight_m * turning))


def gripper_events(recording: Recording, settings: SignalSettings) -> tuple[GripperEvent, ...]:
    """Return the instants at which the gripper crossed half its travel, in order.

    A crossing counts once the opening has gone a band beyond half, so that noise and fingers
    that stop half way cross once. Source: contract, recording.
    """
    if recording.gripper_m is None or len(recording.t_s) < 2:
        return ()
    order = np.argsort(recording.t_s, kind="stable")
    t_s, opening = recording.t_s[order], recording.gripper_m[order]
    low, high = float(np.min(opening)), float(np.max(opening))
    if high - low < settings.least_travel_m:
        return ()
    share = (opening - low) / (high - low) - 0.5
    sure = np.flatnonzero(np.abs(share) > settings.travel_band)
    if len(sure) < 2:
        return ()
    changes = np.flatnonzero(np.sign(share[sure[1:]]) != np.sign(share[sure[:-1]]))
    events = []
    for change in changes:
        first, last = int(sure[change]), int(sure[change + 1])
        kind: Literal["close", "open"] = "close" if share[last] < 0 else "open"
        sign = np.sign(share[last])
        # The last sample before the hand stays on the new side.
        stays = last - int(np.argmax(sign * share[first : last + 1][::-1] <= 0))
        gap = share[stays + 1] - share[stays]
        at = t_s[stays] - share[stays] / gap * (t_s[stays + 1] - t_s[stays])
        events.append(GripperEvent(float(at), kind))
    return tuple(events)


def speed_minima(t_s: Array, speed: Array, settings: SignalSettings) -> tuple[Minimum, ...]:
    """Return local minima of the speed below its mean, and rests, each once.

    Differs: the paper compares mean squared velocity with its mean; here the depth is told in
    log speed, so that one threshold serves slow and fast teachers.
    """
    if len(t_s) < 5:
        return ()
    mean = float(np.mean(speed))
    if mean <= 0.0:
        return ()
    log_speed = np.log(np.maximum(speed / mean, settings.floor))
    inner, found = find_peaks(-log_speed, prominence=settings.depth, plateau_size=1)
    resting = speed < settings.rest * mean
    kept: dict[tuple[int, int], Minimum] = {}
    for k, at in enumerate(inner):
        if speed[at] > mean:
            continue
        left, right = int(found["left_edges"][k]), int(found["right_edges"][k])
        if resting[at]:
            left, right = _stretch(resting, int(at))
        middle = 0.5 * float(t_s[left] + t_s[right]) if resting[at] else float(t_s[at])
        spot = Minimum(middle, float(found["prominences"][k]), float(t_s[left]), float(t_s[right]))
        known = kept.get((left, right))
        if known is None or known.depth < spot.depth:
            kept[left, right] = spot
    return tuple(kept.values())


def jolts(recording: Recording, smoothed: Smoothed, settings: SignalSettings) -> Array:
    """Return instants and strengths, shape (k, 2), of short turns of a hand that hardly moves.

    A gripper that closes on a thing or lets it go turns the wrist a little for an instant;
    where the gripper itself is not recorded this betrays it. The tracked orientation is
    used, hardly smoothed: what lasts a quarter of a second is noise to the smoother.
    """
    t_s, path, _ = distinct(recording, settings.most_jolt_samples)
    steps = np.diff(t_s)
    if len(t_s) < 20 or float(np.median(steps)) > settings.jolt_step_s:
        return np.zeros((0, 2))
    step = float(np.median(steps))
    turning = gaussian_filter1d(
        angle_between(path[:-1], path[1:]) / np.maximum(steps, 0.5 * step), 0.05 / step
    )
    at_s = 0.5 * (t_s[:-1] + t_s[1:])
    window = max(int(settings.jolt_window_s / step) | 1, 3)
    speed = np.interp(at_s, smoothed.t_s, smoothed.speed)
    moving = np.maximum(median_filter(speed, window) / (np.median(speed) + 1e-9), 1.0)
    usual = median_filter(turning, window) + 0.5 * float(np.median(turning)) + 1e-3
    rise = (turning / usual - 1.0) / moving
    peaks, _ = find_peaks(rise, height=settings.jolt, distance=max(int(0.4 / step), 1))
    return np.stack([at_s[peaks], rise[peaks]], axis=1)


def _stretch(inside: np.ndarray[tuple[int], np.dtype[np.bool_]], at: int) -> tuple[int, int]:
    """Return first and last index of the run of true values around an index."""
    outside = np.flatnonzero(~inside)
    after = int(np.searchsorted(outside, at))
    left = int(outside[after - 1]) + 1 if after > 0 else 0
    right = int(outside[after]) - 1 if after < len(outside) else len(inside) - 1
    return left, right
