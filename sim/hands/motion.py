"""How a hand moves along its way: minimum-jerk submovements, hesitations, tremor, drift, rests.

Source: minimum jerk as the shape of human reaches (Flash and Hogan, 1985); a reach is a main
submovement that falls short and a corrective one that overlaps it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from assistant.geometry import (
    Array,
    angle_between,
    distance_between,
    quat_from_rotvec,
    quat_inverse,
    quat_multiply,
    quat_to_rotvec,
)
from sim.hands.habits import Habits
from sim.hands.route import Leg

RATE_HZ = 50.0
PEAK_OF_MEAN = 1.875
"""Peak over mean speed of a minimum-jerk movement."""
TURN_SPEED_RAD_S = 0.8
SHORTEST_S = 0.5


@dataclass(slots=True)
class Shown:
    """The motion as it grows.

    Parameters
    ----------
    poses : list of array, shape (7,)
    openings, loose : list of float
        Opening of the gripper, and how freely the hand moves: 0 steadied, 1 free.
    leg_ends : list of int
        Last sample of each leg.
    """

    poses: list[Array] = field(default_factory=list)
    openings: list[float] = field(default_factory=list)
    loose: list[float] = field(default_factory=list)
    leg_ends: list[int] = field(default_factory=list)

    def add(self, poses: Array, openings: Array, loose: Array) -> None:
        """Append samples."""
        self.poses.extend(poses)
        self.openings.extend(openings.tolist())
        self.loose.extend(loose.tolist())


def minimum_jerk(share: Array) -> Array:
    """Return the travelled share, 0 to 1, of a minimum-jerk movement at shares of its time."""
    s = np.clip(share, 0.0, 1.0)
    return np.asarray(s**3 * (10.0 - 15.0 * s + 6.0 * s * s))


def move(
    start: Array, opening_m: float, legs: Sequence[Leg], habits: Habits, random: np.random.Generator
) -> Shown:
    """Return the motion of a hand along its legs, at `RATE_HZ`."""
    shown = Shown()
    _hold(shown, start, opening_m, opening_m, random.uniform(0.5, 0.9))
    hand, opening = start, opening_m
    waiting: list[Array] = []
    for leg in legs:
        if leg.kind == "pass":
            waiting.append(leg.goal)
        elif leg.kind in ("reach", "careful"):
            _reach(shown, [hand, *waiting, leg.goal], leg, habits, random)
            waiting = []
        elif leg.kind == "grip":
            _hold(shown, hand, opening, leg.opening_m, habits.gripper_s)
        else:
            _hold(shown, hand, opening, opening, habits.rest_s * random.uniform(0.6, 1.4))
        if leg.kind != "pass":
            hand, opening = leg.goal, leg.opening_m
        shown.leg_ends.append(len(shown.poses) - 1)
    _unsteady(shown, habits, random)
    return shown


def _hold(shown: Shown, hand: Array, before_m: float, after_m: float, seconds: float) -> None:
    count = max(2, round(seconds * RATE_HZ))
    share = minimum_jerk(np.arange(1, count + 1) / count)
    openings = before_m + (after_m - before_m) * share
    shown.add(np.tile(hand, (count, 1)), openings, np.zeros(count))


def _reach(
    shown: Shown, ways: list[Array], leg: Leg, habits: Habits, random: np.random.Generator
) -> None:
    for begin, end in pairwise(ways):
        peak = habits.careful_speed_m_s if leg.kind == "careful" else habits.peak_speed_m_s
        speed = peak * random.uniform(0.85, 1.0)
        seconds = PEAK_OF_MEAN * float(distance_between(begin, end)) / speed
        turn_s = PEAK_OF_MEAN * float(angle_between(begin, end)) / TURN_SPEED_RAD_S
        seconds = max(seconds, turn_s, SHORTEST_S)
        poses = _straight(begin, end, seconds, leg, habits, random)
        share = np.arange(1, len(poses) + 1) / len(poses)
        free = np.sin(np.pi * share) ** 2 * (0.3 if leg.kind == "careful" else 1.0)
        shown.add(poses, np.full(len(poses), leg.opening_m), free)
        if leg.kind == "reach" and random.uniform() < habits.hesitation / 2:
            _hold(shown, end, leg.opening_m, leg.opening_m, random.uniform(0.1, 0.25))


def _straight(
    begin: Array, end: Array, seconds: float, leg: Leg, habits: Habits, random: np.random.Generator
) -> Array:
    short = 0.0 if leg.kind == "careful" else habits.undershoot * random.uniform(0.5, 1.5)
    total = seconds * (1.0 + 0.25 * (short > 0))
    count = max(2, round(total * RATE_HZ))
    t = np.arange(1, count + 1) / count * total
    late = 0.75 * seconds
    main = minimum_jerk(t / seconds)
    fix = minimum_jerk((t - late) / (total - late)) if short else np.zeros(count)
    share = (1.0 - short) * main + short * fix
    turn = quat_to_rotvec(quat_multiply(end[3:], quat_inverse(begin[3:])))
    xyz = begin[:3] + share[:, None] * (end[:3] - begin[:3])
    # The main submovement also misses a little sideways, and the second one mends that.
    side = np.zeros(3) if not short else short * random.normal(0.0, 0.15, 3)
    reach = float(distance_between(begin, end))
    xyz = xyz + (main - fix)[:, None] * reach * side * (1.0 if short else 0.0)
    quats = quat_multiply(quat_from_rotvec(share[:, None] * turn), begin[3:])
    poses = np.concatenate([xyz, quats], axis=-1)
    poses[-1] = end
    return poses


def _unsteady(shown: Shown, habits: Habits, random: np.random.Generator) -> None:
    """Add tremor and drift where the hand is free."""
    count = len(shown.poses)
    t = np.arange(count) / RATE_HZ
    loose = np.array(shown.loose)[:, None]
    shake = np.zeros((count, 3))
    for _ in range(3):
        phase = random.uniform(0.0, 2.0 * np.pi, 3)
        frequency = random.uniform(6.0, 10.0)
        shake += np.sin(2.0 * np.pi * frequency * t[:, None] + phase) / 3.0
    drift = np.zeros((count, 3))
    for _ in range(3):
        phase = random.uniform(0.0, 2.0 * np.pi, 3)
        drift += np.sin(2.0 * np.pi * random.uniform(0.1, 0.5) * t[:, None] + phase) / 3.0
    offset = loose * (habits.tremor_m * shake + habits.drift_m * drift)
    shown.poses = [
        np.concatenate([pose[:3] + extra, pose[3:]])
        for pose, extra in zip(shown.poses, offset, strict=True)
    ]
