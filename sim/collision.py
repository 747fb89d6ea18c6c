"""Does the arm, its hand or what it carries touch anything? For whole paths at once.

The links are capsules, palm, fingers and bodies are boxes; cylinders, cups and balls count as
the box around them. The base is no obstacle to the upper arm that turns on it, nor are tables
to the base that may stand on them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from assistant.geometry import Array, quat_to_matrix
from assistant.model.scene import Scene
from sim import a465
from sim.a465 import GRIPPER
from sim.kinematics import Flags, arm_points, forward
from sim.resting import CLEARANCE_M, Carried, Standing
from sim.shapes import Boxes, box_at, boxes_apart, obstacle_box, segment_apart
from sim.urdf import PAD_ROLL_RAD

BESIDE_M = 0.001
"""It keeps at least this far from other bodies, but from the one it is put on."""
FAR = 1.0
NEAR_M = 0.01
"""Only what a quick bound finds nearer than this is looked at closely."""

EXCUSED_M = 0.0005
"""What is touched where the arm stands may come nearer by so much."""

FINGER_TALL_M = GRIPPER.finger_m[0] * np.sin(PAD_ROLL_RAD) + GRIPPER.finger_m[2]
"""From the lowest to the highest corner of a pad, which is rolled a little."""

Indices = NDArray[np.int64]

_BASE_POSE = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])


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
    things = [Standing("floor", floor, bears=True), Standing("base", base)]
    things += [Standing(table.name, obstacle_box(table), bears=True) for table in scene.tables]
    things += [Standing(one.name, obstacle_box(one)) for one in scene.obstacles]
    return tuple(things)


def touches(
    q: Array,
    gripper_m: Array,
    things: tuple[Standing, ...],
    carried: Carried | None = None,
    allowed: Mapping[tuple[str, str], Flags] | None = None,
    excused: Mapping[tuple[str, str], float] | None = None,
    resting: Flags | None = None,
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
    excused : mapping of (part, thing) to float
        By how much these were too near already where the arm stands: they may not come nearer.
    resting : flags, shape (m,), optional
        Samples at which what is carried may rest on what bears it.
    """
    least, part, thing = np.full(len(q), FAR), "", ""
    for where, what, gap in _gaps(_parts(q, gripper_m, carried), things, carried, resting):
        permitted = (allowed or {}).get((where, what))
        gap = gap + (excused or {}).get((where, what), 0.0)
        gap = gap if permitted is None else np.where(permitted, FAR, gap)
        if gap.min() < least.min():
            part, thing = where, what
        least = np.minimum(least, gap)
    return Touch(least, part, thing, int(np.argmin(least)))


def too_near(
    q: Array, gripper_m: float, things: tuple[Standing, ...], carried: Carried | None
) -> dict[tuple[str, str], float]:
    """Return which parts are too near which things for joints, shape (6,), and by how much."""
    parts = _parts(q[None], np.array([gripper_m]), carried)
    found: dict[tuple[str, str], float] = {}
    for part, thing, gap in _gaps(parts, things, carried):
        if gap[0] < 0.0:
            found[part, thing] = max(found.get((part, thing), 0.0), EXCUSED_M - float(gap[0]))
    return found


@dataclass(frozen=True, slots=True, eq=False)
class _Part:
    """A moving part: a capsule where `box` is None, else a box with the ball around it."""

    name: str
    middle: Array
    half: Array
    radius: float
    box: Boxes | None

    def gap(self, thing: Boxes, near: Indices) -> Array:
        """Return the distance from a box at the chosen samples."""
        if self.box is not None:
            return boxes_apart(self.box.at(near), thing.at(near))
        start, end = self.middle - self.half, self.middle + self.half
        return segment_apart(start[near], end[near], thing.at(near)) - self.radius


def _parts(q: Array, gripper_m: Array, carried: Carried | None) -> list[_Part]:
    poses, (elbow, wrist) = forward(q), arm_points(q)
    shoulder = np.broadcast_to(np.array([0.0, 0.0, a465.BASE_M]), elbow.shape)
    still = np.zeros_like(elbow)
    links = (
        (shoulder, elbow, a465.UPPER_ARM_RADIUS_M),
        (elbow, wrist, a465.FOREARM_RADIUS_M),
        (wrist, poses[:, :3], a465.WRIST_RADIUS_M),
    )
    parts = [_Part("arm", (a + b) / 2, (b - a) / 2, radius, None) for a, b, radius in links]
    palm, fingers = _hand(poses, gripper_m)
    parts.append(_Part("palm", palm.center, still, palm.radius, palm))
    parts += [_Part("fingers", box.center, still, box.radius, box) for box in fingers]
    if carried is not None:
        held = carried.box(poses)
        parts.append(_Part("carried", held.center, still, held.radius, held))
    return parts


def _hand(poses: Array, gripper_m: Array) -> tuple[Boxes, list[Boxes]]:
    turn, (length, width, height) = quat_to_matrix(poses[:, 3:]), GRIPPER.palm_m
    (long, thick, _), tall = GRIPPER.finger_m, FINGER_TALL_M
    ahead, left = turn[:, :, 0], turn[:, :, 1]
    palm = Boxes(poses[:, :3] + ahead * length / 2, turn, np.array([length, width, height]) / 2)
    between = poses[:, :3] + ahead * (length + long / 2)
    aside = left * (gripper_m[:, None] + thick) / 2
    half = np.array([long, thick, tall]) / 2
    return palm, [Boxes(between + side * aside, turn, half) for side in (1.0, -1.0)]


def _gaps(
    parts: list[_Part],
    things: tuple[Standing, ...],
    carried: Carried | None,
    resting: Flags | None = None,
) -> Iterator[tuple[str, str, Array]]:
    far = _bounds(parts, things)
    for k, part in enumerate(parts):
        for j, thing in enumerate(things):
            # The upper arm turns on the base; what lies under the base's rim is out of reach.
            if not (k == 0 and thing.name in ("base", "floor")):
                keeps: Array = np.full(len(part.middle), CLEARANCE_M)
                if carried is not None and part.name == "carried":
                    keeps = carried.keeps(part.middle, thing, resting)
                yield part.name, thing.name, _refined(far[k, j], part, thing.box, keeps)
    for part in parts[3:]:
        for name, link in (("upper arm", parts[0]), ("forearm", parts[1])):
            if part.name == "carried" or (part.name == "palm" and name == "upper arm"):
                yield part.name, name, _self_gap(part, link)


def _bounds(parts: list[_Part], things: tuple[Standing, ...]) -> Array:
    """Return lower bounds of the distance of each part to each thing, shape (p, t, m)."""
    center = np.stack([thing.box.center[0] for thing in things])
    turn = np.stack([thing.box.turn[0] for thing in things])
    size = np.stack([thing.box.half for thing in things])[:, None, :]
    middle = np.stack([part.middle for part in parts])[:, None]
    half = np.stack([part.half for part in parts])[:, None]
    radius = np.array([part.radius for part in parts])[:, None, None]
    outside = np.abs((middle - center[:, None, :]) @ turn) - np.abs(half @ turn) - size
    outside = np.maximum(outside, 0.0)
    return np.asarray(np.sqrt(np.einsum("...k,...k->...", outside, outside)) - radius)


def _refined(bound: Array, part: _Part, thing: Boxes, keeps: Array) -> Array:
    gap = bound - keeps
    near = np.flatnonzero(gap < NEAR_M)
    if len(near):
        gap[near] = part.gap(thing, near) - keeps[near]
    return np.asarray(gap)


def _self_gap(part: _Part, link: _Part) -> Array:
    long = np.sqrt(np.einsum("ij,ij->i", link.half, link.half))
    away = part.middle - link.middle
    apart = np.sqrt(np.einsum("ij,ij->i", away, away))
    gap = np.asarray(apart - long - link.radius - part.radius)
    if part.box is None:
        return gap - CLEARANCE_M
    return _refined(gap, link, part.box, np.full(len(gap), CLEARANCE_M))
