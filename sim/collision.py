"""Does the arm, its hand or what it carries touch anything? For whole paths at once.

The links are capsules, palm, fingers and bodies are boxes; cylinders, cups and balls count as
the box around them. The base is no obstacle to the upper arm that turns on it, nor are tables
to the base that may stand on them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, compose
from assistant.model.scene import Scene
from sim import a465
from sim.a465 import GRIPPER
from sim.kinematics import Flags, arm_points, forward
from sim.shapes import Boxes, body_box, box_at, boxes_apart, obstacle_box, segment_apart

CLEARANCE_M = 0.003
"""Arm and hand keep at least this far from everything."""
CARRIED_SLACK_M = 0.0015
"""What is carried rests on tables and on other bodies: it may touch, not sink in."""
FAR = 1.0

_BASE_POSE = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True, eq=False)
class Standing:
    """A thing the arm must not touch.

    Parameters
    ----------
    name : str
    box : Boxes
        At one place.
    for_arm : bool
        Whether the arm's links and hand must keep clear of it.
    """

    name: str
    box: Boxes
    for_arm: bool = True


@dataclass(frozen=True, slots=True, eq=False)
class Carried:
    """A body in the hand: its box and where its base's middle is, seen from the flange."""

    name: str
    in_hand: Array
    middle: Array
    size: Array


@dataclass(frozen=True, slots=True, eq=False)
class Touch:
    """The closest a path comes to anything.

    Parameters
    ----------
    gap : array, shape (m,)
        Distance beyond what must be kept, negative where something is too near.
    part, thing : list of str
        At the worst sample.
    worst : int
    """

    gap: Array
    part: str
    thing: str
    worst: int

    @property
    def free(self) -> bool:
        """Whether nothing is touched anywhere."""
        return bool(self.gap[self.worst] >= 0.0)


def fixed_things(scene: Scene) -> tuple[Standing, ...]:
    """Return floor, base, tables and obstacles of a scene."""
    radius, height = a465.BASE_RADIUS_M, a465.BASE_M - a465.BASE_RADIUS_M
    base = box_at(_BASE_POSE, (0.0, 0.0, height / 2), (1.7 * radius, 1.7 * radius, height))
    floor = box_at(_BASE_POSE, (0.0, 0.0, -0.5), (4.0, 4.0, 1.0))
    things = [Standing("floor", floor), Standing("base", base)]
    for obstacle in (*scene.tables, *scene.obstacles):
        things.append(Standing(obstacle.name, obstacle_box(obstacle)))
    return tuple(things)


def touches(
    q: Array,
    gripper_m: Array,
    things: tuple[Standing, ...],
    carried: Carried | None = None,
    allowed: dict[tuple[str, str], Flags] | None = None,
) -> Touch:
    """Return how near a path of the joints comes to anything.

    Parameters
    ----------
    q : array, shape (m, 6)
    gripper_m : array, shape (m,)
    things : tuple of Standing
        Bodies, and `fixed_things`.
    carried : Carried, optional
    allowed : mapping of (part, thing) to flags, shape (m,)
        Samples at which these may touch. Parts are ``arm``, ``palm``, ``fingers`` and
        ``carried``.
    """
    poses, points = forward(q), arm_points(q)
    least, part, thing = np.full(len(q), FAR), "", ""
    for where, what, gap in _gaps(poses, points, gripper_m, things, carried):
        permitted = (allowed or {}).get((where, what))
        gap = gap if permitted is None else np.where(permitted, FAR, gap)
        if gap.min() < least.min():
            part, thing = where, what
        least = np.minimum(least, gap)
    return Touch(least, part, thing, int(np.argmin(least)))


def _gaps(
    poses: Array,
    points: tuple[Array, Array],
    gripper_m: Array,
    things: tuple[Standing, ...],
    carried: Carried | None,
) -> Iterator[tuple[str, str, Array]]:
    links = _links(poses, *points)
    boxes = [("palm", _palm(poses)), *(("fingers", box) for box in _fingers(poses, gripper_m))]
    for thing in things:
        for number, (start, end, radius) in enumerate(links):
            # The upper arm turns on the base; what lies under the base's rim is out of reach.
            if thing.for_arm and (number > 0 or thing.name not in ("base", "floor")):
                gap = _link_gap(start, end, radius, thing.box)
                yield "arm", thing.name, gap - CLEARANCE_M
        if thing.for_arm:
            for part, box in boxes:
                yield part, thing.name, _box_gap(box, thing.box) - CLEARANCE_M
    if carried is None:
        upper = links[0]
        yield "palm", "upper arm", _link_gap(*upper, boxes[0][1]) - CLEARANCE_M
        return
    held = box_at(compose(poses, carried.in_hand), carried.middle, carried.size)
    for start, end, radius in links[:2]:
        yield "carried", "arm", _link_gap(start, end, radius, held) - CLEARANCE_M
    for thing in things:
        yield "carried", thing.name, _box_gap(held, thing.box) + CARRIED_SLACK_M


def _links(poses: Array, elbow: Array, wrist: Array) -> list[tuple[Array, Array, float]]:
    shoulder = np.broadcast_to(np.array([0.0, 0.0, a465.BASE_M]), elbow.shape)
    return [
        (shoulder, elbow, a465.UPPER_ARM_RADIUS_M),
        (elbow, wrist, a465.FOREARM_RADIUS_M),
        (wrist, poses[:, :3], a465.WRIST_RADIUS_M),
    ]


def _palm(poses: Array) -> Boxes:
    length, width, height = GRIPPER.palm_m
    return box_at(poses, (length / 2, 0.0, 0.0), (length, width, height))


def _fingers(poses: Array, gripper_m: Array) -> list[Boxes]:
    length, thick, tall = GRIPPER.finger_m
    box = box_at(poses, (GRIPPER.palm_m[0] + length / 2, 0.0, 0.0), (length, thick, tall))
    aside = box.turn[:, :, 1] * (gripper_m[:, None] + thick) / 2
    return [Boxes(box.center + side * aside, box.turn, box.half) for side in (1.0, -1.0)]


def _box_gap(box: Boxes, thing: Boxes) -> Array:
    apart = box.center - thing.center
    gap = np.sqrt(np.einsum("ij,ij->i", apart, apart)) - box.radius - thing.radius
    near = np.flatnonzero(gap < 0.02)
    if len(near):
        gap[near] = boxes_apart(box.at(near), thing.at(near))
    return np.asarray(gap)


def _link_gap(start: Array, end: Array, radius: float, thing: Boxes) -> Array:
    middle, half = (start + end) / 2, (end - start) / 2
    local = np.einsum("...k,...kj->...j", middle - thing.center, thing.turn)
    reach = np.einsum("...k,...kj->...j", half, thing.turn)
    # The box around the segment gives a quick bound; only what is near is looked at closely.
    outside = np.maximum(np.abs(local) - np.abs(reach) - thing.half, 0.0)
    gap = np.sqrt(np.einsum("ij,ij->i", outside, outside)) - radius
    near = np.flatnonzero(gap < 0.02)
    if len(near):
        gap[near] = segment_apart(start[near], end[near], thing.at(near)) - radius
    return np.asarray(gap)


def carried_body(scene: Scene, name: str, in_hand: Array) -> Carried | None:
    """Return a body of the scene as carried, its base at `in_hand`; None if it has no shape."""
    body = scene.bodies.get(name)
    if body is None:
        return None
    box = body_box(body, _BASE_POSE)
    return Carried(name, in_hand, box.center[0], 2 * box.half)
