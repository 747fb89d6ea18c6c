"""Joint angles to stand at where nothing else decides: nearest to READY, within the limits."""

from __future__ import annotations

import numpy as np

from assistant.geometry import Array, angle_between, distance_between
from sim import a465
from sim.kinematics import inverse_all, within_limits

SAME_PLACE_M, SAME_TURN_RAD = 1e-4, 1e-3


def joints_at(pose: Array) -> Array:
    """Return joint angles, shape (6,), that hold the flange at a pose, shape (7,).

    Of the answers within the limits the one nearest to READY is taken. Where there is none,
    the arm stands at READY: the planner refuses such a start, with the reason.
    """
    answers = inverse_all(pose[None, :])[0]
    fine = [q for q in answers if np.all(np.isfinite(q)) and bool(within_limits(q))]
    if not fine:
        return np.array(a465.READY)
    return min(fine, key=lambda q: float(np.sum(np.abs(q - a465.READY))))


def same_pose(first: Array, second: Array) -> bool:
    """Return whether two flange poses, shape (7,), are the same place and turn."""
    near = float(distance_between(first, second)) < SAME_PLACE_M
    return near and float(angle_between(first, second)) < SAME_TURN_RAD
