"""Times a joint path: the demonstration's own profile, slowed smoothly where a limit binds.

The path is given on the hand's own time u. Real time runs slower by sigma(u) >= 1, the least
smooth curve above what speeds, accelerations and the hand's limit ask for; rests keep their
length. A path that begins or ends in motion is led in and out from rest.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, angle_between
from sim.a465 import ACCELERATIONS, CONTROL_HZ, SPEEDS
from sim.kinematics import forward

SMOOTH_S = 0.16
"""Half the width over which the slowing comes and goes."""
USE_SPEED, USE_ACCELERATION = 0.97, 0.92
"""Shares of the limits that are used; the rest is for the control ticks' grid."""
TURN_RAD_S = 1.6
"""The hand turns no faster, wherever it is led: a body in it would slip."""
ROUNDS = 14
REST_RAD_S, REST_M_S = 2e-3, 5e-4
LEAD_S = 0.3


@dataclass(frozen=True, slots=True, eq=False)
class Timed:
    """A path on control ticks.

    Parameters
    ----------
    t_s : array, shape (n,)
    q : array, shape (n, 6)
    u_s : array, shape (n,)
        The hand's own time at each tick.
    """

    t_s: Array
    q: Array
    u_s: Array


def timed(u_s: Array, q: Array, hand: Array, hand_speed_m_s: float) -> Timed:
    """Return the path on control ticks within speeds, accelerations and the hand's speed.

    Parameters
    ----------
    u_s : array, shape (g,)
        Increasing.
    q : array, shape (g, 6)
    hand : array, shape (g, 3)
        Where the flange is.
    hand_speed_m_s : float
    """
    from scipy.interpolate import CubicSpline

    curve = CubicSpline(u_s, q)
    speed, bend = np.abs(curve(u_s, 1)), np.abs(curve(u_s, 2))
    hand_speed = _speed(u_s, hand)
    rest = (speed.max(axis=1) < REST_RAD_S) & (hand_speed < REST_M_S)
    need = np.max(speed / (USE_SPEED * SPEEDS), axis=1)
    need = np.maximum(need, hand_speed / (USE_SPEED * hand_speed_m_s))
    need = np.maximum(need, _turning(u_s, q) / (USE_SPEED * TURN_RAD_S))
    need = np.maximum(need, np.sqrt(np.max(bend / (USE_ACCELERATION * ACCELERATIONS), axis=1)))
    need = np.maximum(need, 1.0)
    for _ in range(ROUNDS):
        result = _ticks(u_s, _smooth(u_s, need, rest), curve, rest)
        over = _overload(result, hand_speed_m_s)
        if over.max() <= 1.0:
            break
        worst = _worst(u_s, result.u_s, over)
        need = need * np.where(worst > 1.0, 1.0 + 1.05 * (np.sqrt(worst) - 1.0) + 0.005, 1.0)
    return result


def _speed(u_s: Array, hand: Array) -> Array:
    return np.asarray(np.linalg.norm(np.gradient(hand, u_s, axis=0), axis=1))


def _turning(u_s: Array, q: Array) -> Array:
    hand = forward(q)
    rates = np.asarray(angle_between(hand[1:], hand[:-1])) / np.diff(u_s)
    return np.asarray(np.maximum(np.append(rates, 0.0), np.insert(rates, 0, 0.0)))


def _smooth(u_s: Array, need: Array, rest: Array) -> Array:
    from scipy.ndimage import convolve1d, maximum_filter1d

    # On an even grid: the weighted mean, and what that lacks spread out: its greatest within the
    # window, then their mean. It is never less than what is needed, and as smooth as the window.
    even = np.linspace(u_s[0], u_s[-1], max(int((u_s[-1] - u_s[0]) * CONTROL_HZ), 2) + 1)
    half = max(round(SMOOTH_S * CONTROL_HZ), 1)
    window = np.hanning(2 * half + 3)[1:-1]
    window /= window.sum()
    needed = _peaks(u_s, need, even)
    level = convolve1d(needed, window, mode="nearest")
    lacks = maximum_filter1d(np.maximum(needed - level, 0.0), 2 * half + 1, mode="nearest")
    level += convolve1d(lacks, window, mode="nearest")
    return np.asarray(np.where(rest, 1.0, np.interp(u_s, even, level)))


def _peaks(u_s: Array, values: Array, even: Array) -> Array:
    bins = np.clip(np.searchsorted(even, u_s, side="right") - 1, 0, len(even) - 1)
    level = np.interp(even, u_s, values)
    np.maximum.at(level, bins, values)
    return np.asarray(level)


def _ticks(u_s: Array, sigma: Array, curve: Callable[[Array], Array], rest: Array) -> Timed:
    steps = 0.5 * (sigma[1:] + sigma[:-1]) * np.diff(u_s)
    t_s = np.concatenate([[0.0], np.cumsum(steps)])
    t_s = _led(t_s, not rest[0], not rest[-1])
    ticks = np.arange(int(np.ceil(t_s[-1] * CONTROL_HZ - 1e-9)) + 1) / CONTROL_HZ
    at = np.interp(ticks, t_s, u_s)
    return Timed(ticks, np.asarray(curve(at)), at)


def _led(t_s: Array, lead_in: bool, lead_out: bool) -> Array:
    # From rest: the clock of the path starts slowly and has caught up after twice LEAD_S.
    if lead_in:
        t_s = _ramp(t_s)
    if lead_out:
        t_s = t_s[-1] - t_s[::-1]
        t_s = _ramp(t_s)
        t_s = t_s[-1] - t_s[::-1]
    return t_s


def _ramp(t_s: Array) -> Array:
    total = t_s[-1]
    lead = min(LEAD_S, total / 2)
    real = np.linspace(0.0, 2 * lead, 65)
    s = real / (2 * lead)
    # Speed of the clock 3 s^2 - 2 s^3: it runs through `lead` in twice that time.
    clock = 2 * lead * (s**3 - s**4 / 2)
    slow = t_s < lead
    return np.asarray(np.where(slow, np.interp(t_s, clock, real), t_s + lead))


def _overload(result: Timed, hand_speed_m_s: float) -> Array:
    q = result.q
    over = np.zeros(len(q))
    if len(q) < 3:
        return over
    speed = np.max(np.abs(np.diff(q, axis=0)) * CONTROL_HZ / SPEEDS, axis=1)
    place = forward(q)[:, :3]
    hand_speed = np.linalg.norm(np.diff(place, axis=0), axis=1) * CONTROL_HZ / hand_speed_m_s
    over[1:] = np.maximum(speed, hand_speed) ** 2
    padded = np.concatenate([q[:1], q, q[-1:]])
    bend = np.abs(np.diff(padded, 2, axis=0)) * CONTROL_HZ**2 / ACCELERATIONS
    return np.asarray(np.maximum(over, np.max(bend, axis=1)))


def _worst(u_s: Array, ticks_u_s: Array, over: Array) -> Array:
    worst = np.interp(u_s, ticks_u_s, _widest(over, 3))
    # Where time is slowed a lot, many ticks lie between two samples: both answer for them.
    before = np.clip(np.searchsorted(u_s, ticks_u_s, side="right") - 1, 0, len(u_s) - 2)
    np.maximum.at(worst, before, over)
    np.maximum.at(worst, before + 1, over)
    return np.asarray(worst)


def _widest(values: Array, reach: int) -> Array:
    from scipy.ndimage import maximum_filter1d

    return np.asarray(maximum_filter1d(values, 2 * reach + 1, mode="nearest"))
