"""What a driven hand is asked to do tick by tick: take up a speed, or go to a pose, and rest."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from assistant.geometry import (
    IDENTITY,
    Array,
    compose,
    quat_from_rotvec,
    quat_inverse,
    quat_multiply,
    quat_to_rotvec,
)
from sim import a465
from sim.kinematics import forward
from sim.world import CONTROL_S

TIP = np.array([a465.TCP_M, *IDENTITY[1:]])
"""The point between the fingers, seen from the flange."""
GAIN_M_S2, GAIN_RAD_S2 = 0.8, 4.0
"""How fast the asked speed comes and goes."""
LONGEST_TICKS = 1000
NOTHING = 1e-9

Asked = tuple[Array, Array]
"""Tips, shape (n, 7), and speeds, shape (n, 6), one a tick; the first are those of now."""


@dataclass(frozen=True, slots=True)
class Pace:
    """A try: shares of the asked speed and of the usual gain, and for how many ticks to go on."""

    speed: float
    gain: float
    ticks: int


@dataclass(frozen=True, slots=True, eq=False)
class Driven:
    """Where a driven arm is at one tick.

    Parameters
    ----------
    q, q_speed : array, shape (6,)
        Joints as commanded, and their speeds.
    tip : array, shape (7,)
        Pose asked of the point between the fingers.
    speed : array, shape (6,)
        As asked: m/s and rad/s, along and about the axes of the base.
    """

    q: Array
    q_speed: Array
    tip: Array
    speed: Array

    @classmethod
    def resting(cls, q: Array, tip: Array | None = None) -> Driven:
        """Return an arm at rest; it is where it was asked to be unless told otherwise."""
        here = compose(forward(q), TIP) if tip is None else tip
        return cls(np.array(q), np.zeros(6), here, np.zeros(6))


def driven(now: Driven, speed: Array, pace: Pace) -> Asked:
    """Return tips and speeds that take up a speed, keep it for the pace's ticks, and brake."""
    parts = []
    for part, gain in ((slice(0, 3), GAIN_M_S2), (slice(3, 6), GAIN_RAD_S2)):
        begin, wanted = now.speed[part], speed[part] * pace.speed
        up = gain * (pace.gain if begin @ (wanted - begin) >= 0.0 else 1.0)
        rising = _ramp(begin, wanted, up)[: pace.ticks]
        kept = np.repeat(rising[-1:], pace.ticks - len(rising), axis=0)
        going = np.concatenate([rising, kept])
        parts.append(np.concatenate([going, _ramp(going[-1], np.zeros(3), gain)]))
    count = max(len(part) for part in parts)
    parts = [np.concatenate([part, np.zeros((count - len(part), 3))]) for part in parts]
    speeds = np.concatenate([now.speed[None], np.concatenate(parts, axis=1)])
    return _summed(now.tip, speeds), speeds


def _ramp(begin: Array, end: Array, gain: float) -> Array:
    count = max(math.ceil(float(np.linalg.norm(end - begin)) / (gain * CONTROL_S) - 1e-9), 1)
    return np.asarray(begin + np.arange(1, count + 1)[:, None] / count * (end - begin))


def _summed(tip: Array, speeds: Array) -> Array:
    tips = np.repeat(tip[None], len(speeds), axis=0)
    tips[1:, :3] += np.cumsum(speeds[1:, :3], axis=0) * CONTROL_S
    if speeds[1:, 3:].any():
        turns = quat_from_rotvec(speeds[:, 3:] * CONTROL_S)
        for k in range(1, len(tips)):
            tips[k, 3:] = quat_multiply(turns[k], tips[k - 1, 3:])
    return tips


def stepped(now: Driven, goal: Array, most: tuple[float, float], pace: Pace) -> Asked:
    """Return tips and speeds of a motion to a pose, and exactly there."""
    tip, speed = now.tip, now.speed
    tips, speeds = [tip], [speed]
    for _ in range(LONGEST_TICKS):
        left = (goal[:3] - tip[:3], quat_to_rotvec(quat_multiply(goal[3:], quat_inverse(tip[3:]))))
        if not speed.any() and max(np.abs(part).max() for part in left) < NOTHING:
            break
        gains = (GAIN_M_S2, GAIN_RAD_S2)
        each = zip(left, (speed[:3], speed[3:]), most, gains, strict=True)
        speed = np.concatenate([_nearer(*one, pace) for one in each])
        turn = quat_multiply(quat_from_rotvec(speed[3:] * CONTROL_S), tip[3:])
        tip = np.concatenate([tip[:3] + speed[:3] * CONTROL_S, turn])
        tips.append(tip)
        speeds.append(speed)
    return np.array(tips), np.array(speeds)


def _nearer(left: Array, speed: Array, most: float, gain: float, pace: Pace) -> Array:
    """Return the speed of the next tick towards what is left, to end there at rest."""
    far = float(np.linalg.norm(left))
    if far < NOTHING:
        wanted = np.zeros(3)
    else:
        fast = min(most * pace.speed, math.sqrt(1.4 * gain * far), far / CONTROL_S)
        wanted = left / far * fast
    change = wanted - speed
    up = gain * (pace.gain if speed @ change >= 0.0 else 2.0) * CONTROL_S
    size = float(np.linalg.norm(change))
    return np.asarray(wanted if size <= up else speed + change * (up / size))
