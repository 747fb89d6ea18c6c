"""Where the arm's reach ends the hand gives way sideways instead of standing still.

A step of a driven hand that leaves what the arm can take is moved, level, by the least that
brings it back: led on along the edge of its reach, the hand follows that edge, at the height that
was asked for. Turned high up it may come lower, too. It is turned as far as was asked for.
"""

from __future__ import annotations

import math

import numpy as np

from assistant.geometry import Array, compose, inverse, rotate_vector
from sim import a465
from sim.driving import TIP
from sim.kinematics import WRIST_NEGATIVE, inverse_all
from sim.tracking import AHEAD, HAND_M

STRETCHED_M = 0.622
"""The middle of the wrist is led no further from the shoulder: the elbow keeps its speed."""
FOLDED_M = float(
    np.sqrt(
        a465.UPPER_ARM_M**2
        + a465.FOREARM_M**2
        + 2.0 * a465.UPPER_ARM_M * a465.FOREARM_M * np.cos(a465.LIMITS[2] - math.radians(1.0))
    )
)
"""Nor nearer: the elbow is folded up there."""
BENDS = (1, 4)
"""Joints whose limits are kept by giving way: the shoulder's and the wrist's bend."""
HIGH_M = 0.2
"""A wrist so far above the shoulder has nothing below the hand."""
ROOM_RAD = math.radians(0.5)
ROUNDS, NUDGE_M = 6, 1e-4
WORTH = 0.3
"""A step along the edge of the reach has to bring the hand on by this share of what was asked."""
MOST_M = 0.03
"""No step gives way further than this: the hand would seem to go on its own."""


def slid(tip: Array, goal: Array, branch: int) -> tuple[Array, ...]:
    """Return poses to go to for one that is asked for, that to be tried first in front.

    Parameters
    ----------
    tip, goal : array, shape (7,)
        Of the point between the fingers, now and as asked.
    branch : int
        As the arm stands.
    """
    level = bool(np.any(goal[:3] != tip[:3]))
    found = _kept(goal, branch, level=level)
    if found is None:
        return (goal,)
    aside = found[:3] - goal[:3]
    asked = goal[:3] - tip[:3]
    far = float(np.linalg.norm(asked))
    worth = far == 0.0 or float((found[:3] - tip[:3]) @ asked) >= WORTH * far**2
    if not aside.any() or not worth or float(np.linalg.norm(aside)) > MOST_M:
        return (goal,)
    # With the elbow nearly straight the hand comes nearer before it turns.
    nearer = np.concatenate([found[:3], tip[3:]])
    return (found, goal) if far else (found, goal, nearer)


def _kept(goal: Array, branch: int, *, level: bool) -> Array | None:
    """Return the pose next to a goal that the arm can take; None where there is none."""
    found = np.array(goal)
    for _ in range(ROUNDS):
        shift = _back(found, branch, level=level)
        if shift is None:
            return None
        if not shift.any():
            break
        found[:3] += shift
    return found


def _back(tip: Array, branch: int, *, level: bool) -> Array | None:
    """Return the way back into what the arm can take, zeros where it is there."""
    wrist = tip[:3] - HAND_M * rotate_vector(tip[3:], AHEAD)
    up, across = float(wrist[2] - a465.BASE_M), float(np.hypot(wrist[0], wrist[1]))
    far = math.hypot(up, across)
    level = level or up <= HIGH_M
    if not level and far > STRETCHED_M:
        # High up there is room below; level, the hand would have to go twice as far.
        return np.array([*wrist[:2], up]) * (STRETCHED_M / far - 1.0)
    if abs(up) >= STRETCHED_M or across < NUDGE_M:
        return None
    most = math.sqrt(STRETCHED_M**2 - up**2)
    least = math.sqrt(max(FOLDED_M**2 - up**2, 0.0))
    radius = min(max(across, least), most)
    if radius != across:
        return np.array([*(wrist[:2] * (radius / across - 1.0)), 0.0])
    return _bent(tip, branch, 2 if level else 3)


def _bent(tip: Array, branch: int, axes: int) -> Array | None:
    """Return the way along so many axes to where no joint is bent too far."""
    nudged = np.stack([tip] * (axes + 1))
    for k in range(axes):
        nudged[k + 1, k] += NUDGE_M
    hands = compose(nudged, np.tile(inverse(TIP), (axes + 1, 1)))
    bent = np.abs(inverse_all(hands)[:, branch & ~WRIST_NEGATIVE])
    if np.isnan(bent).any():
        return None
    over = bent - (a465.LIMITS - ROOM_RAD)
    shift = np.zeros(3)
    for joint in BENDS:
        if over[0, joint] > 0.0:
            slope = (over[1:, joint] - over[0, joint]) / NUDGE_M
            size = float(slope @ slope)
            if size == 0.0:
                return None
            shift[:axes] -= over[0, joint] / size * slope
    return shift
