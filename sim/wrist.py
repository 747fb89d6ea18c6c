"""The wrist led through its singularity while the hand goes on.

Where joint 5 is straight, joints 4 and 6 turn about one line, and joint 5 can lean the hand in
one plane only: the one joint 4 happens to stand in. A hand that is driven does not wait for
joint 4. Joint 4 keeps to the plane that is asked for where it can; where that plane turns
faster than it may, it begins early and catches up late, and it takes either sign of joint 5,
whichever is nearer. Joints 5 and 6 meanwhile come as near as they can to what is asked; how far
off that is belongs to the answer.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from assistant.geometry import Array, quat_inverse, quat_multiply, rotate_vector
from sim.a465 import ACCELERATIONS, LIMITS, SPEEDS
from sim.kinematics import Flags
from sim.world import CONTROL_S

SLACK_RAD = math.radians(0.6)
"""So far the approach may be off on purpose while joint 4 begins early or catches up late."""
RESTS_RAD = 1e-6
"""So far it may be off where the hand comes to rest."""
STRAIGHT_RAD = 1e-7
"""Below this lean no plane is asked for."""
CENTERED = 0.2
"""How much the middle of joint 4's range is preferred where either way would do."""
BEYOND = 100.0
"""How much more an angle beyond joint 4's end weighs than one it has to swing."""
ENDS = float(LIMITS[3]) - math.radians(0.05)
"""Joint 4 is kept so far within its limits: what that costs at a slight lean is nothing."""
TURNS = 0.96 * SPEEDS[3]
GAINS = 0.9 * ACCELERATIONS[3]
EARLY = 0.8
"""Share of joint 4's speed it reckons with when it begins early."""


def forearm_turn(q: Array) -> Array:
    """Return the forearm's rotations, shape (n, 4), for joints 1 to 3, shape (n, 3)."""
    yaw, pitch = q[:, 0] / 2.0, (q[:, 1] + q[:, 2] - math.pi / 2) / 2.0
    cz, sz, cy, sy = np.cos(yaw), np.sin(yaw), np.cos(pitch), np.sin(pitch)
    return np.stack([-sz * sy, cz * sy, sz * cy, cz * cy], axis=-1)


def led(
    turns: Array, q: Array, speed: float, resting: Flags, tour: Sequence[float] = ()
) -> tuple[Array, Array]:
    """Return joints 4 to 6 along a motion and how far they leave the hand's asked turn.

    Parameters
    ----------
    turns : array, shape (n, 4)
        Of the hand as asked, seen from the forearm; the first is where it is now.
    q : array, shape (3,)
        Joints 4 to 6 now.
    speed : float
        Of joint 4 now, rad/s.
    resting : array of bool, shape (n,)
        Where the hand rests, and the asked turn is to be met.
    tour : sequence of float
        Planes the hand is likely to be led to later, as `plane_of` tells them.

    Returns
    -------
    wrist : array, shape (n, 3)
    off_rad : array, shape (n,)
    """
    approach = rotate_vector(turns, np.array([1.0, 0.0, 0.0]))
    lean = np.hypot(approach[:, 1], approach[:, 2])
    planes = asked_planes(approach, lean, float(q[0]), resting, tour)
    slack = np.where(resting, RESTS_RAD, SLACK_RAD)
    room = np.arcsin(np.minimum(slack / np.maximum(lean, 1e-12), 1.0))
    return _completed(turns, _swung(planes, room, float(q[0]), speed), float(q[2]))


def suited(turns: Array, q: Array, tour: Sequence[float] = ()) -> Array:
    """Return the same turn of a singular wrist, joints 4 to 6, ready for a motion.

    Parameters
    ----------
    turns : array, shape (n, 4)
        Of the hand as asked, seen from the forearm.
    q : array, shape (3,)
        Joints 4 to 6, joint 5 straight.
    tour : sequence of float
        As for `led`.
    """
    approach = rotate_vector(turns, np.array([1.0, 0.0, 0.0]))
    lean = np.hypot(approach[:, 1], approach[:, 2])
    joint4 = asked_planes(approach, lean, None, np.ones(len(lean), dtype=bool), tour)[0]
    return np.array([joint4, q[1], q[0] + q[2] - joint4])


def plane_of(turns: Array) -> Array:
    """Return the planes, shape (n,), joint 4 stands in at turns where joint 5 is positive."""
    approach = rotate_vector(turns, np.array([1.0, 0.0, 0.0]))
    return np.asarray(np.arctan2(approach[:, 1], -approach[:, 2]))


def asked_planes(
    approach: Array,
    lean: Array,
    now: float | None,
    resting: Flags,
    tour: Sequence[float] = (),
) -> Array:
    """Return the planes, shape (n,), that joint 4 should stand in, each near the one before.

    Half a turn further is the same plane, with the other sign of joint 5. While the hand leans
    hardly at all any plane does: the next that matters is taken. Without `now` joint 4 may
    begin anywhere.
    """
    known = lean > np.where(resting, STRAIGHT_RAD, SLACK_RAD)
    if not known.any():
        return np.full(len(lean), now or 0.0)
    found = np.arctan2(approach[known, 1], -approach[known, 2])
    found = np.unwrap(found, period=math.pi)
    first = float(found[0])
    if now is not None and lean[0] > SLACK_RAD:
        found += round((now - first) / math.pi) * math.pi
    else:
        found += _half_turns(first, now, tour) * math.pi
    places = np.flatnonzero(known)
    following = np.minimum(np.searchsorted(places, np.arange(len(lean))), len(places) - 1)
    return np.asarray(np.clip(found[following], -ENDS, ENDS))


def _half_turns(plane: float, now: float | None, tour: Sequence[float]) -> int:
    """Return how many half turns to begin with, so that joint 4 has room for the whole tour."""

    def effort(count: int) -> float:
        goal = farthest = at = plane + count * math.pi
        for one, following in pairwise((plane, *tour)):
            at += math.remainder(following - one, 2.0 * math.pi)
            farthest = max(farthest, at, key=abs)
        beyond = max(abs(farthest) - ENDS, 0.0) + 10.0 * max(abs(goal) - ENDS - STRAIGHT_RAD, 0.0)
        swing = 0.0 if now is None else abs(goal - now)
        return swing + CENTERED * abs(goal) + BEYOND * beyond

    return min(range(-2, 3), key=effort)


def _swung(planes: Array, room: Array, now: float, speed: float) -> Array:
    """Return joint 4: as near to its plane as its speed allows, and early for what is ahead."""
    drift = EARLY * TURNS * CONTROL_S * np.arange(len(planes))
    low = np.maximum.accumulate((planes - room - drift)[::-1])[::-1] + drift
    high = np.minimum.accumulate((planes + room + drift)[::-1])[::-1] - drift
    goals = np.where(low <= high, np.clip(planes, low, high), (low + high) / 2.0)
    most = float(TURNS)
    gain = float(GAINS) * CONTROL_S
    out = [now]
    wanted = goals.tolist()
    for before, goal in pairwise(wanted):
        # A goal that moves is caught up with so that the speeds meet where the angles do.
        gap, pace = goal - out[-1], (goal - before) / CONTROL_S
        catch = math.sqrt(2.0 * 0.7 * float(GAINS) * abs(gap))
        aim = min(max(gap / CONTROL_S, pace - catch), pace + catch)
        aim = min(max(aim, speed - gain), speed + gain)
        speed = min(max(aim, -most), most)
        out.append(min(max(out[-1] + speed * CONTROL_S, -ENDS), ENDS))
        speed = (out[-1] - out[-2]) / CONTROL_S
    return np.array(out)


def _completed(turns: Array, joint4: Array, joint6: float) -> tuple[Array, Array]:
    left = quat_multiply(quat_inverse(_about(0, joint4)), turns)
    approach = rotate_vector(left, np.array([1.0, 0.0, 0.0]))
    joint5 = np.arctan2(-approach[:, 2], approach[:, 0])
    rest = quat_multiply(quat_inverse(_about(1, joint5)), left)
    last = 2.0 * np.arctan2(rest[:, 0], rest[:, 3])
    last = np.unwrap(np.concatenate([[joint6], last]))[1:]
    off = np.arcsin(np.minimum(np.abs(approach[:, 1]), 1.0))
    return np.stack([joint4, joint5, last], axis=-1), off


def _about(axis: int, angles: Array) -> Array:
    quats = np.zeros((len(angles), 4))
    quats[:, axis], quats[:, 3] = np.sin(angles / 2.0), np.cos(angles / 2.0)
    return quats
