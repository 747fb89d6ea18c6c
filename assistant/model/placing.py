"""How well a released object lies on its target: corners and edges, as in the paper's Table I."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from assistant.geometry import (
    IDENTITY,
    Array,
    angle_between,
    compose,
    inverse,
    quat_inverse,
    rotate_vector,
    transform_points,
)
from assistant.model.motion import Alignment, HandStop
from assistant.model.scene import Body, Scene
from assistant.model.setup import Setup

ON_GAP_M = 0.004
"""An object rests on a target if its base is this close to the target's surface."""
ON_TILT_RAD = np.deg2rad(5.0)
ALIGNED_MM, ALIGNED_DEG = 1.0, 1.0
"""Corners and edges this close to their places are in line, as the paper's worst are."""
ABOVE_M, BESIDE_M = 0.005, 0.030
"""Above begins that high over a place, and ends that far beside it."""


def told_bodies(scene: Scene, setup: Setup) -> dict[str, Array]:
    """Return where the setup says the middle of each body's base is, shape (7,) each."""
    return {name: scene.body_pose(name, place) for name, place in setup.places.items()}


def place_on(
    scene: Scene, setup: Setup, name: str, target: str, bodies: Mapping[str, Array]
) -> Array:
    """Return where the middle of an object's base belongs on a target, shape (7,).

    On a target that can be moved (stacking) it is the middle of its upper face, wherever that
    body now is; on any other it follows from the flange pose of a release there.
    """
    below = _movable(scene, target, bodies)
    if below is not None:
        top = np.array(IDENTITY)
        top[2] = below.size_mm[2] / 1000.0
        return compose(bodies[target], top)
    hand = scene.hand_pose(target, setup.places[target])
    carried = scene.bodies.get(name)
    return compose(hand, inverse(carried.hand_in_body)) if carried else hand


def _movable(scene: Scene, name: str, bodies: Mapping[str, Array]) -> Body | None:
    body = scene.bodies.get(name)
    return body if body is not None and body.mass_kg > 0 and name in bodies else None


def place_of(scene: Scene, setup: Setup, stop: HandStop, bodies: Mapping[str, Array]) -> Array:
    """Return where what is let go at a stop belongs, shape (7,): moved as the teacher corrected.

    A correction moves the place along the surface and turns it there; what is let go higher or
    tilted still comes to lie on the surface.
    """
    place = place_on(scene, setup, stop.object, stop.frame, bodies)
    below = _movable(scene, stop.frame, bodies)
    frame = (
        compose(bodies[stop.frame], below.hand_in_body)
        if below is not None
        else scene.hand_pose(stop.frame, setup.places[stop.frame])
    )
    moved = compose(frame, compose(np.array(stop.shift), inverse(frame)))
    along = compose(inverse(place), compose(moved, place))
    # The part within the surface: two directions and the turn about its normal.
    flat = np.array([along[0], along[1], 0.0, 0.0, 0.0, along[5], along[6]])
    flat[3:] /= max(float(np.linalg.norm(flat[3:])), 1e-12)
    return compose(place, flat)


def base_corners(body: Body) -> Array:
    """Return the corners of a body's base in its own frame, shape (4, 3), in m."""
    half_x, half_y = body.size_mm[0] / 2000.0, body.size_mm[1] / 2000.0
    signs = np.array([[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]])
    return np.column_stack([signs * [half_x, half_y], np.zeros(4)])


def is_round(body: Body) -> bool:
    """Return whether a body looks the same however it is turned about its vertical axis."""
    return body.shape != "box" and body.size_mm[0] == body.size_mm[1]


def turned_back(body: Body, pose: Array, place: Array) -> Array:
    """Return a body's pose, shape (7,), turned as its place is as far as that cannot be seen.

    A round body turns about its axis, a ball about its middle.
    """
    if not is_round(body):
        return pose
    back = compose(inverse(pose), place)[3:]
    if body.shape != "sphere":
        # The part of the turn that is about the axis.
        about = np.array([0.0, 0.0, back[2], back[3]])
        length = float(np.linalg.norm(about))
        back = about / length if length > 0.0 else np.array(IDENTITY[3:])
    up_m = body.size_mm[2] / 2000.0 if body.shape == "sphere" else 0.0
    middle = np.array([0.0, 0.0, up_m])
    return compose(pose, np.concatenate([middle - rotate_vector(back, middle), back]))


def alignment(body: Body, pose: Array, place: Array, target: str) -> Alignment:
    """Return the worst distance between a corner and its place, and the angle between edges.

    Parameters
    ----------
    body : Body
    pose, place : array, shape (7,)
        Middle of the body's base, as it is and as it should be. How a round body is turned
        about its axis does not count, nor how a ball is turned at all.
    target : str
    """
    corners, pose = base_corners(body), turned_back(body, pose, place)
    gaps = transform_points(pose, corners) - transform_points(place, corners)
    worst = float(np.max(np.sqrt(np.sum(gaps * gaps, axis=-1))))
    angle = float(angle_between(pose, place))
    return Alignment(body.name, target, worst * 1000.0, float(np.rad2deg(angle)))


def in_line(body: Body, pose: Array, place: Array, target: str) -> bool:
    """Return whether corners and edges are as close to their places as the paper's worst."""
    found = alignment(body, pose, place, target)
    return found.distance_mm <= ALIGNED_MM and found.angle_deg <= ALIGNED_DEG


def is_above(gap: Array) -> NDArray[np.bool_]:
    """Return whether an object is above its place.

    Parameters
    ----------
    gap : array, shape (..., 3)
        From the place to the object, in the place's frame, in m.
    """
    beside = np.hypot(gap[..., 0], gap[..., 1])
    return np.asarray((gap[..., 2] > ABOVE_M) & (beside < BESIDE_M))


def rests_on(scene: Scene, name: str, target: str, pose: Array, place: Array) -> bool:
    """Return whether an object lies on a target: at its surface, upright, its middle above it."""
    pose = turned_back(scene.bodies[name], pose, place)
    gap = rotate_vector(quat_inverse(place[3:]), pose[:3] - place[:3])
    surface = scene.bodies.get(target) or scene.bodies[name]
    half_x, half_y = surface.size_mm[0] / 2000.0, surface.size_mm[1] / 2000.0
    up = rotate_vector(pose[3:], np.array([0.0, 0.0, 1.0]))
    normal = rotate_vector(place[3:], np.array([0.0, 0.0, 1.0]))
    upright = float(up @ normal) > float(np.cos(ON_TILT_RAD))
    inside = bool(abs(gap[0]) <= half_x and abs(gap[1]) <= half_y)
    return bool(abs(gap[2]) <= ON_GAP_M and inside and upright)


def states(
    scene: Scene, setup: Setup, stop: HandStop, bodies: Mapping[str, Array]
) -> tuple[str, ...]:
    """Return which of ``on`` and ``aligned`` hold of what was let go at a stop."""
    place, pose = place_of(scene, setup, stop, bodies), bodies[stop.object]
    if not rests_on(scene, stop.object, stop.frame, pose, place):
        return ()
    fine = in_line(scene.bodies[stop.object], pose, place, stop.frame)
    return ("on", "aligned") if fine else ("on",)


def alignments(
    scene: Scene, setup: Setup, released: Sequence[HandStop], bodies: Mapping[str, Array]
) -> tuple[Alignment, ...]:
    """Return how well everything that was let go lies; what has no told place is left out."""
    found = []
    for stop in released:
        body = scene.bodies.get(stop.object)
        if body is None or stop.object not in bodies or stop.frame not in setup.places:
            continue
        pose, place = bodies[stop.object], place_of(scene, setup, stop, bodies)
        away = pose[:2] - place_on(scene, setup, stop.object, stop.frame, bodies)[:2]
        x_mm, y_mm = (1000.0 * float(one) for one in away)
        lies = alignment(body, pose, place, stop.frame)
        found.append(replace(lies, x_mm=x_mm, y_mm=y_mm))
    return tuple(found)
