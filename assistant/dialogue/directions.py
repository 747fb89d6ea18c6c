"""From the teacher's directions to displacements of a frame (paper III-D b).

World frame: x forward, y left, z up as the robot sees it. Turns left and right are about world
z, up and down about the hand's lateral axis, forward and backward lean the hand's top along
world x, clockwise is about the approach axis seen from behind the hand.
"""

from __future__ import annotations

import numpy as np

from assistant.dialogue.knowledge import Facing, Knowledge
from assistant.geometry import Array, rotate_vector
from assistant.geometry.quaternions import quat_inverse
from assistant.model.directions import WAYS, Triple
from assistant.model.feedback import Feedback
from assistant.model.lesson import Station
from assistant.model.task import primitives

CLOSING: Triple = (0.0, 1.0, 0.0)
UPRIGHT: Triple = (0.0, 0.0, 1.0)
"""Axes of the hand: the fingers close along the first, and meet flat about the second."""
NOTICED = 0.2
"""A smaller share of a correction is not worth a word."""

_WORLD_TURNS: dict[str, Triple] = {
    "left": (0.0, 0.0, 1.0),
    "right": (0.0, 0.0, -1.0),
    "forward": (0.0, 1.0, 0.0),
    "backward": (0.0, -1.0, 0.0),
}
_HAND_TURNS: dict[str, Triple] = {
    "up": (0.0, -1.0, 0.0),
    "down": (0.0, 1.0, 0.0),
    "clockwise": (1.0, 0.0, 0.0),
    "counterclockwise": (-1.0, 0.0, 0.0),
}
_MIRRORED = ("left", "right", "forward", "backward")
_LEANS = ("forward", "backward")


def depends_on_facing(kind: str, direction: str) -> bool:
    """Whether a direction depends on where the teacher stands."""
    return direction in (_MIRRORED if kind == "translate" else _LEANS)


def move_in_world(direction: str, facing: Facing | None) -> Array:
    """Return the unit vector, shape (3,), of a direction in the world frame."""
    unit = np.array(WAYS[direction])
    return -unit if facing == "facing" and direction in _MIRRORED else unit


def turn_in_world(direction: str, facing: Facing | None, hand_quat: Array) -> Array:
    """Return the unit rotation axis, shape (3,), of a turn in the world frame.

    Parameters
    ----------
    hand_quat : array, shape (4,)
        Orientation of the hand, xyzw, where the turn is wanted.
    """
    if direction in _HAND_TURNS:
        return np.asarray(rotate_vector(hand_quat, np.array(_HAND_TURNS[direction])))
    axis = np.array(_WORLD_TURNS[direction])
    return -axis if facing == "facing" and direction in _LEANS else axis


def direction_of(known: Knowledge, feedback: Feedback) -> str:
    """Return the teacher's word that comes nearest to where a correction goes."""
    station = station_of(known, feedback.primitive)
    quat = frame_quat(known, station)
    told = feedback.offset_m if feedback.kind == "translate" else feedback.turn_rad
    vector = rotate_vector(quat, np.array(told))
    if feedback.kind == "translate":
        units = {word: move_in_world(word, known.facing) for word in WAYS}
    else:
        turns = (*_WORLD_TURNS, *_HAND_TURNS)
        units = {word: turn_in_world(word, known.facing, quat) for word in turns}
    return max(units, key=lambda word: float(units[word] @ vector))


def station_of(known: Knowledge, primitive: str) -> Station | None:
    """Return the grasp or release a primitive leads to; the last one for what comes after.

    Without a primitive it is the last one: what a teacher sees when a run is over.
    """
    lesson = known.lesson
    if lesson is None or not lesson.stations:
        return None
    order = [leaf.name for leaf in primitives(known.task.tree)]
    if primitive not in order:
        return lesson.stations[-1]
    at = order.index(primitive)
    later = (one for one in lesson.stations if _position(order, one.primitive) >= at)
    return next(later, lesson.stations[-1])


def squeezed(known: Knowledge, feedback: Feedback) -> float | None:
    """Return how much of a correction closing fingers take away, in mm or deg; None if little.

    Both fingers close as one and lie flat on what they grasp: it comes to the middle between
    them, and is turned along them, wherever the hand was brought.
    """
    station = station_of(known, feedback.primitive)
    if station is None or station.kind != "grasp" or feedback.frame != station.frame:
        return None
    moves = feedback.kind == "translate"
    told = 1000.0 * np.array(feedback.offset_m) if moves else np.rad2deg(feedback.turn_rad)
    axis = rotate_vector(station.hand_in_frame[3:], np.array(CLOSING if moves else UPRIGHT))
    lost = abs(float(told @ axis))
    return round(lost, 1) if lost > NOTICED * float(np.linalg.norm(told)) else None


def _position(order: list[str], name: str) -> int:
    return order.index(name) if name in order else len(order)


def in_frame(known: Knowledge, station: Station | None, vector: Array) -> Triple:
    """Return a world vector in the axes of a station's frame as the setup has it now."""
    x, y, z = rotate_vector(quat_inverse(frame_quat(known, station)), vector)
    return (float(x), float(y), float(z))


def frame_quat(known: Knowledge, station: Station | None) -> Array:
    """Return the orientation, xyzw, of a station's frame in the present setup."""
    if station is None:
        return np.array((0.0, 0.0, 0.0, 1.0))
    place = known.setup.places.get(station.frame)
    if place is None:
        return station.frame_to_world[3:]
    return known.scene.hand_pose(station.frame, place)[3:]
