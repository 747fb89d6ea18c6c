"""What a driven hand's fingers are near, and how they are opened and closed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import product

import numpy as np

from assistant.geometry import Array, angle_between, transform_points
from assistant.model.motion import HandPath, HandStop, JointPath
from assistant.model.scene import Scene
from assistant.ports import ArmLook
from sim.a465 import FOREARM_RADIUS_M, GRIPPER, WRIST_RADIUS_M
from sim.kinematic_arm import between_pads
from sim.kinematics import arm_points, limit_margin
from sim.world import CONTROL_S

RADII_M = (FOREARM_RADIUS_M, WRIST_RADIUS_M)
"""Of the arm about its elbow and about the middle of its wrist."""
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


def lowest(scene: Scene, look: ArmLook) -> tuple[str, float] | None:
    """Return what of hand and arm is nearest above a table, and how far, m; None over none.

    Parameters
    ----------
    scene : Scene
    look : ArmLook
    """
    found = [
        (part, gap) for part, point in _parts(look) if (gap := _above(scene, point)) is not None
    ]
    return min(found, key=lambda one: one[1], default=None)


def _parts(look: ArmLook) -> Iterator[tuple[str, Array]]:
    palm, finger = GRIPPER.palm_m, GRIPPER.finger_m
    wide = look.gripper_m / 2.0 + finger[1]
    ends = (
        ("fingers", palm[0] + finger[0], wide, finger[2]),
        ("palm", palm[0], palm[1] / 2.0, palm[2]),
    )
    for part, ahead, aside, tall in ends:
        for y, z in product((-aside, aside), (-tall / 2.0, tall / 2.0)):
            yield part, transform_points(look.hand, np.array([ahead, y, z]))
    for point, radius in zip(arm_points(look.q), RADII_M, strict=True):
        yield "arm", point - np.array([0.0, 0.0, radius])


def _above(scene: Scene, point: Array) -> float | None:
    """Return how far a point is above the table under it, m."""
    x, y, z = (1000.0 * point).tolist()
    tops = [
        table.xyz_mm[2] + table.size_mm[2]
        for table in scene.tables
        if abs(x - table.xyz_mm[0]) <= table.size_mm[0] / 2.0
        and abs(y - table.xyz_mm[1]) <= table.size_mm[1] / 2.0
    ]
    return (z - max(tops)) / 1000.0 if tops else None


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


def resting(wanted: HandPath, look: ArmLook) -> JointPath:
    """Return the motion of an arm that stands while its hand acts."""
    count = len(wanted.t_s)
    return JointPath(
        wanted.t_s,
        np.tile(look.q, (count, 1)),
        np.asarray(wanted.gripper_m),
        np.full(count, -1, dtype=np.int64),
        wanted.stops,
        float(np.rad2deg(limit_margin(look.q))),
        0.0,
        0.0,
    )
