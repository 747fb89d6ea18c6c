"""Several demonstrations of one task as one lesson: each makes docking and grasping surer.

The path is that of the demonstration whose cuts are surest; its grasps, releases and docking
poses are the average over all demonstrations that act alike, and the path is carried to them
with least jerk. Order and optional parts come from what differed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from assistant.geometry import Array, compose, inverse, quat_normalize, relative
from assistant.learning.holding import held_stretches
from assistant.learning.rigid import Rows
from assistant.learning.structure import left_out_questions, order_questions
from assistant.learning.ways import prepare, smooth_way
from assistant.model.lesson import LearnedPath, Lesson, Segmentation, Station
from assistant.model.settings import BlendingSettings
from assistant.model.task import Task


def together(lessons: Sequence[Lesson], task: Task) -> Lesson:
    """Return one lesson from the lessons of several demonstrations, in the order shown.

    Parameters
    ----------
    lessons : sequence of Lesson
        At least one.
    task : Task
    """
    whole = [one for one in lessons if one.path is not None] or list(lessons)
    best = max(whole, key=lambda one: (len(one.stations), _sureness(one.segmentation)))
    shown = [one.segmentation for one in lessons]
    lesson = _averaged(best, [one for one in whole if _acts(one) == _acts(best)])
    asked = {(one.asked, one.about): one for one in best.segmentation.questions}
    for question in (*order_questions(task, shown), *left_out_questions(task, shown)):
        asked[question.asked, question.about] = question
    return replace(
        lesson,
        segmentation=replace(best.segmentation, questions=tuple(asked.values())),
        sources=tuple(source for one in lessons for source in one.sources),
    )


def mean_pose(poses: Array) -> Array:
    """Return the mean of poses that lie close together, shape (7,), of shape (n, 7)."""
    quats = poses[:, 3:] * np.sign(poses[:, 3:] @ poses[0, 3:])[:, None]
    return np.concatenate([poses[:, :3].mean(axis=0), quat_normalize(quats.mean(axis=0))])


def _acts(lesson: Lesson) -> tuple[tuple[str, str, str], ...]:
    return tuple((one.kind, one.object, one.frame) for one in lesson.stations)


def _sureness(found: Segmentation) -> float:
    sure = [part.probability for part in found.episodes if part.primitive]
    sure += [point.confidence for point in found.points if point.kept and not point.internal]
    return float(np.mean(sure)) if sure else 0.0


def _averaged(best: Lesson, alike: Sequence[Lesson]) -> Lesson:
    if best.path is None or not best.stations or len(alike) < 2:
        return best
    hands = [
        mean_pose(np.array([one.stations[k].hand_in_frame for one in alike]))
        for k in range(len(best.stations))
    ]
    path = _carried(best.path.path, best.stations, hands)
    stations = tuple(
        replace(
            station,
            hand_in_frame=hand,
            docking_in_frame=relative(station.frame_to_world, path[station.docking_at]),
        )
        for station, hand in zip(best.stations, hands, strict=True)
    )
    learned = LearnedPath(best.path.t_s, path, best.path.gripper_m, best.path.primitive_at)
    return replace(best, path=learned, stations=stations)


def _carried(path: Array, stations: Sequence[Station], hands: Sequence[Array]) -> Array:
    """Return the path with each station's hand where it is on average."""
    settings = BlendingSettings()
    held, home = held_stretches(path[:, :3], stations, settings)
    moves: Rows = [[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]]
    for station, hand in zip(stations, hands, strict=True):
        here = compose(station.frame_to_world, station.hand_in_frame)
        there = compose(station.frame_to_world, hand)
        moves.append(compose(there, inverse(here)).tolist())
    if home:
        moves.append(moves[0])
    return smooth_way(prepare(path, held, settings.least_radius_m), moves)
