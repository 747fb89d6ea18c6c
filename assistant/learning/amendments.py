"""Spoken corrections applied to a learned path (paper III-D b; design, "Feedback").

A correction at a grasp or release moves that whole station in its own frame, so that the
shape around it is kept; one at a grasp changes how the object is held, not where it is put. One
elsewhere bends the free way, ramped over all of it. Exactness at the other stations is not
touched.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from assistant.geometry import (
    IDENTITY,
    Array,
    compose,
    inverse,
    quat_from_rotvec,
    rotate_vector,
)
from assistant.learning.docking import axis_vector
from assistant.learning.weights import least_jerk
from assistant.model.feedback import Feedback
from assistant.model.lesson import LearnedPath, Lesson, Station
from assistant.model.task import Task, primitives

Span = tuple[int, int]


@dataclass(frozen=True, slots=True, eq=False)
class Bend:
    """A correction of a free way.

    Parameters
    ----------
    begin, end : int
        Samples between which it acts.
    weight : array, shape (end - begin,)
        0 at both ends, 1 where it is full.
    station : int
        Whose frame's axes it is told in; -1 for the world.
    offset_m, turn_rad : array, shape (3,)
    """

    begin: int
    end: int
    weight: Array
    station: int
    offset_m: Array
    turn_rad: Array


def station_of(feedback: Feedback, task: Task, lesson: Lesson) -> int | None:
    """Return the station a correction moves, or None if it bends a free way.

    A correction "during" a primitive that docks, grasps or releases moves its station; without
    a primitive, the last station of its frame.
    """
    stations = lesson.stations
    names = [leaf.name for leaf in primitives(task.tree)]
    if feedback.primitive not in names:
        same = [k for k, one in enumerate(stations) if one.frame == feedback.frame]
        return same[-1] if same and feedback.frame else None
    if feedback.when != "during" or lesson.path is None:
        return None
    position = names.index(feedback.primitive)
    for k, station in enumerate(stations):
        leaf = lesson.path.primitive_at
        docking = leaf[max(station.docking_at - 1, 0)] == position
        if station.primitive == feedback.primitive or docking:
            return k
    return None


def station_moves(task: Task, lesson: Lesson, tool_m: float) -> Array:
    """Return how the teacher moved each station within its own frame, shape (stations, 7).

    Parameters
    ----------
    task : Task
    lesson : Lesson
    tool_m : float
        The hand is turned about the point so far ahead of the flange.
    """
    moves = np.tile(IDENTITY, (len(lesson.stations), 1))
    ahead = tool_m * axis_vector(lesson.approach_axis)
    for feedback in lesson.feedback:
        at = station_of(feedback, task, lesson)
        if feedback.kind not in ("translate", "rotate") or at is None:
            continue
        hand = compose(moves[at], lesson.stations[at].hand_in_frame)
        pivot = hand[:3] + rotate_vector(hand[3:], ahead)
        turn = quat_from_rotvec(np.array(feedback.turn_rad))
        shift = pivot - rotate_vector(turn, pivot) + np.array(feedback.offset_m)
        moves[at] = compose(np.concatenate([shift, turn]), moves[at])
    return moves


def hand_moves(stations: Sequence[Station], told: Array) -> Array:
    """Return how the hand is moved at each station, within its frame, shape (stations, 7).

    A hand that grasps elsewhere on an object holds it elsewhere, and lets go of it as much
    elsewhere: the object comes to lie where it was shown, or where a correction told there
    wants it. The same holds wherever the object is led to while it is held.

    Parameters
    ----------
    stations : sequence of Station
    told : array, shape (stations, 7)
        As `station_moves` gives them.
    """
    moves = np.array(told)
    grasps: dict[str, int] = {}
    for k, station in enumerate(stations):
        if station.kind == "grasp":
            grasps[station.object] = k
        elif station.object in grasps:
            grasp = grasps[station.object]
            # The object as it is held, seen from where the hand should be with it.
            across = compose(station.hand_in_frame, inverse(stations[grasp].hand_in_frame))
            moves[k] = compose(told[k], compose(across, compose(told[grasp], inverse(across))))
        if station.kind == "release":
            grasps.pop(station.object, None)
    return moves


def bends(task: Task, lesson: Lesson, path: LearnedPath, held: Sequence[Span]) -> tuple[Bend, ...]:
    """Return the corrections of free ways.

    Parameters
    ----------
    task : Task
    lesson : Lesson
    path : LearnedPath
    held : sequence of (first, last)
        Stretches that must not be touched.
    """
    names = [leaf.name for leaf in primitives(task.tree)]
    found = []
    for feedback in lesson.feedback:
        moving = feedback.kind in ("translate", "rotate")
        if not moving or station_of(feedback, task, lesson) is not None:
            continue
        middle = _middle(feedback, names, path)
        ways = [(a, b) for (_, a), (b, _) in itertools.pairwise(held) if b > a + 4]
        if ways:
            found.append(_bend(feedback, middle, ways, lesson.stations))
    return tuple(found)


def speed_factors(task: Task, lesson: Lesson, path: LearnedPath) -> Array:
    """Return the factor of the demonstration's speed at each sample, shape (n,)."""
    factors = np.full(len(path.t_s), lesson.speed)
    names = [leaf.name for leaf in primitives(task.tree)]
    for feedback in lesson.feedback:
        if feedback.kind != "speed":
            continue
        if feedback.primitive not in names:
            factors *= feedback.factor
        else:
            inside = path.primitive_at == names.index(feedback.primitive)
            factors *= np.where(_scope(inside, feedback), feedback.factor, 1.0)
    return _blurred(factors)


def commanded(task: Task, lesson: Lesson, path: LearnedPath) -> Array:
    """Return the opening of the gripper at each sample with spoken commands, shape (n,)."""
    shown = path.gripper_m if path.gripper_m is not None else np.zeros(len(path.t_s))
    opening = np.array(shown)
    names = [leaf.name for leaf in primitives(task.tree)]
    levels = {"open": float(np.max(shown)), "close": float(np.min(shown))}
    for feedback in lesson.feedback:
        if feedback.kind != "hand" or feedback.hand is None or feedback.primitive not in names:
            continue
        inside = np.flatnonzero(path.primitive_at == names.index(feedback.primitive))
        if len(inside):
            begin = inside[-1] if feedback.when == "after" else inside[0]
            later = [one.at for one in lesson.stations if one.at > begin]
            opening[begin : later[0] if later else len(opening)] = levels[feedback.hand]
    return opening


def _middle(feedback: Feedback, names: Sequence[str], path: LearnedPath) -> int:
    """Return the sample at which a correction of a free way is full."""
    inside = np.flatnonzero(
        path.primitive_at == (names.index(feedback.primitive) if feedback.primitive in names else 0)
    )
    if not len(inside):
        return len(path.t_s) // 2
    if feedback.when == "during":
        return int(inside[len(inside) // 2])
    return int(inside[0] if feedback.when == "before" else inside[-1])


def _bend(
    feedback: Feedback, middle: int, ways: Sequence[Span], stations: Sequence[Station]
) -> Bend:
    begin, end = min(ways, key=lambda way: max(way[0] - middle, middle - way[1], 0))
    full = int(np.clip(middle, begin + (end - begin) // 4, end - (end - begin) // 4))
    samples = np.arange(begin, end)
    rise = least_jerk((samples - begin) / max(full - begin, 1))
    fall = least_jerk((end - samples) / max(end - full, 1))
    named = [k for k, one in enumerate(stations) if feedback.frame and one.frame == feedback.frame]
    return Bend(
        begin,
        end,
        np.minimum(rise, fall),
        named[0] if named else -1,
        np.array(feedback.offset_m),
        np.array(feedback.turn_rad),
    )


def _scope(inside: np.ndarray[tuple[int], np.dtype[np.bool_]], feedback: Feedback) -> Array:
    if feedback.when == "during" or not np.any(inside):
        return np.asarray(inside)
    found = np.flatnonzero(inside)
    samples = np.arange(len(inside))
    return np.asarray(samples < found[0] if feedback.when == "before" else samples > found[-1])


def _blurred(factors: Array, half: int = 10) -> Array:
    if float(np.ptp(factors)) < 1e-12:
        return factors
    padded = np.pad(factors, half, mode="edge")
    return np.convolve(padded, np.full(2 * half + 1, 1.0 / (2 * half + 1)), mode="valid")
