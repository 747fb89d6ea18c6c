"""The joints that follow a driven hand: the arm by its closed form, the wrist led through.

The point between the fingers stays where it is asked to be; see `sim.wrist` for the rest.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assistant.geometry import Array, compose, quat_inverse, quat_multiply, rotate_vector
from assistant.model.motion import Refusal
from assistant.model.scene import Scene
from assistant.ports import ArmLook
from sim import a465
from sim.branches import STRAIGHT_RAD
from sim.driving import Driven
from sim.kinematics import WRIST_NEGATIVE, Flags, branch_of, forward, inverse_all
from sim.wrist import forearm_turn, led, plane_of, suited

AHEAD = np.array([1.0, 0.0, 0.0])
PATH = "next step"
"""By how much the next step is too far says nothing: it is told without."""
STANDS_RAD = 2e-5
ROUNDS, SHARE = 6, 0.6
HAND_M = a465.TCP_M + a465.FLANGE_M
"""From the middle of the wrist to the point between the fingers."""
TABLE_TOUR = (0.7, -0.7)
"""Planes of the wrist with the hand down on the table, to either side of the arm."""


def tour(scene: Scene, look: ArmLook) -> tuple[float, ...]:
    """Return the planes of the wrist where a teacher is likely to go, in likely order.

    A full hand goes to places first, an empty one to what can be grasped. Where nothing is
    known to stand anywhere, it is the table that is gone to, from above.
    """
    known = [(n, scene.bodies[n]) for n in look.bodies if n in scene.bodies and n != look.held]
    known.sort(key=lambda one: (one[1].mass_kg > 0.0) is bool(look.held))
    if not known:
        return TABLE_TOUR
    hands = np.array([compose(look.bodies[name], body.hand_in_body) for name, body in known])
    branch = int(branch_of(look.q)) & ~WRIST_NEGATIVE
    arm = inverse_all(hands)[:, branch, :3]
    planes = plane_of(quat_multiply(quat_inverse(forearm_turn(arm)), hands[:, 3:]))
    return tuple(planes[~np.isnan(planes)].tolist())


def tracked(
    now: Driven, tips: Array, resting: Flags, tour: Sequence[float] = ()
) -> tuple[Array, Array] | Refusal:
    """Return joints, shape (n, 6), that hold the tips, and how far the hand's turn is off.

    Parameters
    ----------
    now : Driven
    tips : array, shape (n, 7)
        As asked; the first is where the arm was asked to be now.
    resting : array of bool, shape (n,)
    tour : sequence of float
        As for `sim.wrist.led`.
    """
    branch = int(branch_of(now.q)) & ~WRIST_NEGATIVE
    ahead = rotate_vector(tips[:, 3:], AHEAD)
    here = rotate_vector(forward(now.q)[3:], AHEAD)
    for _ in range(ROUNDS):
        ahead[0] = here
        arm = arm_joints(tips[:, :3] - HAND_M * ahead, branch)
        if np.isnan(arm).any():
            return Refusal("reach", PATH)
        base = forearm_turn(arm)
        turns = quat_multiply(quat_inverse(base), tips[:, 3:])
        wrist, off = led(turns, now.q[3:], float(now.q_speed[3]), resting, tour)
        if off.max() < STANDS_RAD:
            break
        # The hand is off by a little: the point between the fingers is kept where it should be.
        q = np.concatenate([arm, wrist], axis=1)
        ahead += SHARE * (rotate_vector(forward(q)[:, 3:], AHEAD) - ahead)
        ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    q = np.concatenate([arm, wrist], axis=1)
    q[0] = now.q
    return q, off


def seated(now: Driven, tips: Array, tour: Sequence[float] = ()) -> Driven:
    """Return the arm with a singular wrist split as suits the tips that are asked for."""
    if abs(float(now.q[4])) > STRAIGHT_RAD:
        return now
    branch = int(branch_of(now.q)) & ~WRIST_NEGATIVE
    reach = HAND_M * rotate_vector(tips[:, 3:], AHEAD)
    arm = arm_joints(tips[:, :3] - reach, branch)
    if np.isnan(arm).any():
        return now
    turns = quat_multiply(quat_inverse(forearm_turn(arm)), tips[:, 3:])
    q = np.array(now.q)
    q[3:] = suited(turns, q[3:], tour)
    return Driven.resting(q, now.tip)


def arm_joints(wrists: Array, branch: int) -> Array:
    """Return joints 1 to 3, shape (n, 3), for places of the wrist's middle, shape (n, 3)."""
    poses = np.zeros((len(wrists), 7))
    poses[:, :3], poses[:, 6] = wrists + a465.FLANGE_M * AHEAD, 1.0
    return np.array(inverse_all(poses)[:, branch, :3])
