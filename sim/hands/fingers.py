"""What a driven hand's fingers are near, and how they are opened and closed."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from assistant.geometry import Array, angle_between
from assistant.model.motion import HandPath, HandStop
from assistant.model.scene import Scene
from assistant.ports import ArmLook
from sim.a465 import GRIPPER
from sim.kinematic_arm import between_pads
from sim.world import CONTROL_S

NEAR_M, LOW_M = 0.025, 0.03
"""So near a place where a thing is grasped, or so low above a table, steps are fine ones."""


def near(tip: Array, places: Iterable[Array], scene: Scene) -> bool:
    """Whether the point between the fingers, shape (7,), is near a place or a table.

    Parameters
    ----------
    tip : array, shape (7,)
    places : iterable of array, shape (7,)
    scene : Scene
    """
    tops = (table.xyz_mm[2] + table.size_mm[2] for table in scene.tables)
    low = any(0.0 <= float(tip[2]) - top / 1000.0 < LOW_M for top in tops)
    return low or any(float(np.abs(tip[:3] - one[:3]).max()) < NEAR_M for one in places)


def apart(first: Array, second: Array, most_m: float, most_rad: float) -> bool:
    """Whether two poses, shape (7,), are no further apart than that."""
    far = float(np.linalg.norm(first[:3] - second[:3]))
    return far <= most_m and float(angle_between(first, second)) <= most_rad


def acting(closing: bool, scene: Scene, look: ArmLook) -> HandPath:
    """Return a path of a hand that rests and closes, or opens, where it is.

    Parameters
    ----------
    closing : bool
    scene : Scene
    look : ArmLook
    """
    reached = between_pads(scene, look.bodies, look.hand) if closing else ""
    goal = 0.0 if closing else GRIPPER.open_m
    stop = HandStop(1, "grasp" if closing else "release", look.held or reached, "", 0, 2)
    opening = np.array([look.gripper_m, goal, goal])
    hands = np.tile(look.hand, (3, 1))
    return HandPath(CONTROL_S * np.arange(3.0), hands, opening, np.full(3, -1), (stop,))
