"""Could this setup be done at all? A slow, plain check that shares no code with the planner's.

A setup counts as reachable where one joint branch holds the start and the docking, grasp and
release poses within the limits and touches nothing there. Links, hand and carried body are
clouds of points; whatever has a point inside it is touched.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, inverse, pose_from_mm_deg, transform_points
from assistant.model.scene import Scene
from sim import a465
from sim.a465 import GRIPPER
from sim.kinematics import arm_points, forward, inverse_all, within_limits
from sim.urdf import PAD_ROLL_RAD

GRID_M = 0.006
KEEP_M = 0.0035
"""Points nearer than this count as inside: a little more than the planner keeps."""
SLACK_M = 0.001


@dataclass(frozen=True, slots=True, eq=False)
class Posture:
    """A pose the hand must be able to take.

    Parameters
    ----------
    hand : array, shape (7,)
        The flange.
    gripper_m : float
    held : str
        Body in the hand, empty for none, with `held_in_hand`, shape (7,), its base.
    standing : mapping of name to array, shape (7,)
        Bodies elsewhere, by their base.
    near : tuple of str
        Bodies the fingers may touch here.
    joined : bool
        Reached from the posture before with nothing in between where a joint could turn back.
    """

    hand: Array
    gripper_m: float
    held: str
    held_in_hand: Array
    standing: dict[str, Array]
    near: tuple[str, ...] = ()
    joined: bool = False


def reachable(postures: Sequence[Posture], scene: Scene) -> bool:
    """Return whether one branch holds all postures, within limits and touching nothing."""
    answers = inverse_all(np.stack([posture.hand for posture in postures]))
    fit = np.asarray(within_limits(answers)).all(axis=0)
    joined = np.array([posture.joined for posture in postures[1:]], dtype=bool)
    # A joint that comes out at its other end would have had to turn through its limits.
    turns = np.abs(np.diff(answers, axis=0)).max(axis=-1)[joined]
    fit &= np.all(turns < np.pi, axis=0)
    for branch in np.flatnonzero(fit):
        pairs = zip(answers[:, branch], postures, strict=True)
        if not any(_touches(q, posture, scene) for q, posture in pairs):
            return True
    return False


def _touches(q: Array, posture: Posture, scene: Scene) -> bool:
    boxes = list(_boxes(posture, scene))
    for name, points, keep in _clouds(q, posture, scene):
        for thing, pose, size in boxes:
            if name == "upper arm" and thing in ("base", "floor"):
                continue
            if thing in posture.near and (name in ("fingers", "carried") or _marks(scene, thing)):
                continue
            local = transform_points(inverse(pose), points) - [0.0, 0.0, size[2] / 2]
            if np.any(np.all(np.abs(local) < size / 2 + keep, axis=1)):
                return True
    return False


def _marks(scene: Scene, name: str) -> bool:
    """Return whether a body only marks a place, or stands open for what is put there."""
    body = scene.bodies.get(name)
    return body is not None and body.mass_kg == 0.0 and not any(body.hole_mm)


def _boxes(posture: Posture, scene: Scene) -> Iterator[tuple[str, Array, Array]]:
    origin = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])
    wide = 1.7 * a465.BASE_RADIUS_M
    yield "base", origin, np.array([wide, wide, a465.BASE_M - a465.BASE_RADIUS_M])
    yield "floor", origin - [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0], np.array([4.0, 4.0, 1.0])
    for thing in (*scene.tables, *scene.obstacles):
        pose = pose_from_mm_deg(thing.xyz_mm, thing.rpy_deg)
        yield thing.name, pose, np.array(thing.size_mm) / 1000.0
    for name, pose in posture.standing.items():
        size = np.array(scene.bodies[name].size_mm) / 1000.0
        if name != posture.held and np.all(size > 0):
            yield name, pose, size


def _clouds(q: Array, posture: Posture, scene: Scene) -> Iterator[tuple[str, Array, float]]:
    elbow, wrist = arm_points(q)
    hand = forward(q)
    shoulder = np.array([0.0, 0.0, a465.BASE_M])
    yield "upper arm", _along(shoulder, elbow), a465.UPPER_ARM_RADIUS_M + KEEP_M
    yield "arm", _along(elbow, wrist), a465.FOREARM_RADIUS_M + KEEP_M
    yield "arm", _along(wrist, hand[:3]), a465.WRIST_RADIUS_M + KEEP_M
    palm, finger = np.array(GRIPPER.palm_m), np.array(GRIPPER.finger_m)
    finger[2] += finger[0] * np.sin(PAD_ROLL_RAD)
    yield "palm", transform_points(hand, _grid(palm, (palm[0] / 2, 0.0, 0.0))), KEEP_M
    aside = (posture.gripper_m + finger[1]) / 2
    for side in (aside, -aside):
        points = _grid(finger, (palm[0] + finger[0] / 2, side, 0.0))
        yield "fingers", transform_points(hand, points), KEEP_M
    if posture.held:
        size = np.array(scene.bodies[posture.held].size_mm) / 1000.0
        points = transform_points(posture.held_in_hand, _grid(size, (0.0, 0.0, size[2] / 2)))
        yield "carried", transform_points(hand, points), -SLACK_M


def _along(start: Array, end: Array) -> Array:
    count = int(np.linalg.norm(end - start) / GRID_M) + 2
    return np.linspace(start, end, count)


def _grid(size: Array, middle: tuple[float, float, float]) -> Array:
    axes = [np.linspace(-edge / 2, edge / 2, int(edge / GRID_M) + 2) for edge in size]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    return np.asarray(points + np.array(middle))
