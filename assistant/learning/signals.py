"""What single signals propose as cuts: gripper and speed (paper III-A).

A new signal is one function from the motion to the instants it proposes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
from scipy.ndimage import median_filter
from scipy.signal import find_peaks

from assistant.geometry import Array
from assistant.learning.smoothing import Smoothed
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
    that stop half way cross once; a hand that is back at once, by a fumble or a fault of its
    sensor, has done neither. Source: contract, recording.
    """
    if recording.gripper_m is None or len(recording.t_s) < 2:
        return ()
    order = np.argsort(recording.t_s, kind="stable")
    t_s, opening = recording.t_s[order], recording.gripper_m[order]
    usual = median_filter(opening, 3, mode="nearest")
    low, high = float(np.min(usual)), float(np.max(usual))
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
    return _held(events, settings.least_held_s)


def _held(events: Sequence[GripperEvent], least_s: float) -> tuple[GripperEvent, ...]:
    """Return events without those that are taken back sooner, the soonest first."""
    found = list(events)
    while len(found) > 1:
        lasting = [then.at_s - here.at_s for here, then in pairwise(found)]
        soonest = min(range(len(lasting)), key=lasting.__getitem__)
        if lasting[soonest] >= least_s:
            break
        del found[soonest : soonest + 2]
    return tuple(found)


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
        spot = Minimum(
            float(t_s[at]), float(found["prominences"][k]), float(t_s[at]), float(t_s[at])
        )
        if resting[at]:
            left, right = _stretch(resting, int(at))
            begin, end = _rest(t_s, speed, left, right, settings.rest * mean)
            spot = Minimum(0.5 * (begin + end), spot.depth, begin, end)
        known = kept.get((left, right))
        if known is None or known.depth < spot.depth:
            kept[left, right] = spot
    return tuple(kept.values())


def _rest(t_s: Array, speed: Array, left: int, right: int, slow: float) -> tuple[float, float]:
    """Return when the hand came to rest and when it left again, within a slow stretch."""
    lowest = left + int(np.argmin(speed[left : right + 1]))
    at_s = float(t_s[lowest])
    begin = at_s - _sets_in(at_s - t_s[lowest::-1], speed[lowest::-1], slow)
    end = at_s + _sets_in(t_s[lowest:] - at_s, speed[lowest:], slow)
    return begin, end


def _sets_in(away_s: Array, speed: Array, slow: float) -> float:
    """Return after how long motion sets in, going away from a minimum of the speed.

    The speed of a reach rises, and ends, with the square of time: its root, followed down from
    two levels below the neighboring peak, points at the instant whatever the reach's length.
    """
    highest = np.maximum.accumulate(speed)
    fallen = np.flatnonzero((highest > slow) & (speed < 0.6 * highest))
    peak = int(np.argmax(speed[: fallen[0]] if len(fallen) else speed))
    rise = speed[peak] - speed[0]
    crossings = []
    for level in (0.04, 0.16):
        below = int(np.flatnonzero(speed[: peak + 1] <= speed[0] + level * rise)[-1])
        above = min(below + 1, len(speed) - 1)
        gap = speed[above] - speed[below]
        share = (speed[0] + level * rise - speed[below]) / gap if gap > 0.0 else 0.0
        crossings.append(away_s[below] + share * (away_s[above] - away_s[below]))
    return float(np.clip(2.0 * crossings[0] - crossings[1], 0.0, crossings[0]))


def _stretch(inside: np.ndarray[tuple[int], np.dtype[np.bool_]], at: int) -> tuple[int, int]:
    """Return first and last index of the run of true values around an index."""
    outside = np.flatnonzero(~inside)
    after = int(np.searchsorted(outside, at))
    left = int(outside[after - 1]) + 1 if after > 0 else 0
    right = int(outside[after]) - 1 if after < len(outside) else len(inside) - 1
    return left, right
