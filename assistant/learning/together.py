"""Several demonstrations of one task as one lesson: each makes docking and grasping surer.

The path is that of the demonstration whose cuts are surest; its grasps, releases and docking
poses are the average over all demonstrations that act alike, and the path is carried to them
with least jerk. Order and optional parts come from what differed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from assistant.geometry import (
    Array,
    compose,
    inverse,
    quat_normalize,
    relative,
    rotate_vector,
)
from assistant.learning.holding import held_stretches
from assistant.learning.rigid import Rows
from assistant.learning.segmentation import segment
from assistant.learning.structure import left_out_questions, order_questions
from assistant.learning.ways import prepare, smooth_way
from assistant.learning.weights import least_jerk
from assistant.model.demonstration import Demonstration
from assistant.model.lesson import LearnedPath, Lesson, Segmentation, Station
from assistant.model.settings import BlendingSettings, SegmentationSettings
from assistant.model.task import Task

_FEWEST_LAGS = 2
_SETTLING = 100
"""Samples over which the path is led to another docking place, at most."""

Act = tuple[str, str, str, int]


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
    lesson = _averaged(best, [one for one in whole if _acts(one).keys() == _acts(best).keys()])
    asked = {(one.asked, one.about): one for one in best.segmentation.questions}
    for question in (*order_questions(task, shown), *left_out_questions(task, shown)):
        asked[question.asked, question.about] = question
    return replace(
        lesson,
        segmentation=replace(best.segmentation, questions=tuple(asked.values())),
        sources=tuple(source for one in lessons for source in one.sources),
    )


def one_teacher(
    demonstrations: Sequence[Demonstration], task: Task, settings: SegmentationSettings
) -> SegmentationSettings:
    """Return the settings with the lag of the one teacher who gave several demonstrations.

    The lag of one demonstration may be ambiguous; the middle of several seldom is.
    """
    lags = [segment(one, task, settings).cue_lag_s for one in demonstrations if one.cues]
    told = [lag for lag in lags if lag is not None]
    if len(told) < _FEWEST_LAGS:
        return settings
    spread = settings.cues.usual_lag_spread_s
    middle = float(np.median(told))
    # Of few demonstrations some may be read with a wrong lag.
    surely = max(float(np.median(np.abs(np.array(told) - middle))), spread / len(told))
    near = replace(settings.cues, usual_lag_s=middle, usual_lag_spread_s=min(surely, spread))
    return replace(settings, cues=near)


def mean_pose(poses: Array) -> Array:
    """Return the mean of poses that lie close together, shape (7,), of shape (n, 7)."""
    quats = poses[:, 3:] * np.sign(poses[:, 3:] @ poses[0, 3:])[:, None]
    return np.concatenate([poses[:, :3].mean(axis=0), quat_normalize(quats.mean(axis=0))])


def _acts(lesson: Lesson) -> dict[Act, Station]:
    """Return the stations by what is done there, and for which time."""
    found: dict[Act, Station] = {}
    for one in lesson.stations:
        times = sum(key[:3] == (one.kind, one.object, one.frame) for key in found)
        found[one.kind, one.object, one.frame, times] = one
    return found


def _sureness(found: Segmentation) -> float:
    sure = [part.probability for part in found.episodes if part.primitive]
    sure += [point.confidence for point in found.points if point.kept and not point.internal]
    return float(np.mean(sure)) if sure else 0.0


def _averaged(best: Lesson, alike: Sequence[Lesson]) -> Lesson:
    if best.path is None or not best.stations or len(alike) < 2:
        return best
    # The parts may have been shown in another order: what is alike is what is done.
    each = [_acts(one) for one in alike]
    same = [[acts[key] for acts in each] for key in _acts(best)]
    hands = [mean_pose(np.array([one.hand_in_frame for one in ones])) for ones in same]
    path = _carried(best.path.path, best.stations, hands)
    earliest = 0
    for station, ones in zip(best.stations, same, strict=True):
        path = _redocked(path, station, _way_in(ones), earliest)
        earliest = station.left_at
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


def _way_in(ones: Sequence[Station]) -> Array:
    """Return the usual place of docking, shape (3,), seen from the hand where it acts.

    One demonstration whose cut is wrong docks anywhere: the middle one counts.
    """
    seen = [relative(one.hand_in_frame, one.docking_in_frame)[:3] for one in ones]
    return np.asarray(np.median(np.array(seen), axis=0))


def _redocked(path: Array, station: Station, docking: Array, earliest: int) -> Array:
    """Return the path led through another docking place, with least jerk on both sides.

    Docking lies where straight ways allow it in every demonstration, and so does their middle.
    """
    at, docked = station.at, station.docking_at
    begin = max(earliest, docked - (at - docked), docked - _SETTLING)
    if docked >= at or begin >= docked:
        return path
    away = docking - relative(path[at], path[docked])[:3]
    share = np.zeros(len(path))
    share[begin : docked + 1] = least_jerk(np.linspace(0.0, 1.0, docked + 1 - begin))
    share[docked : at + 1] = 1.0 - least_jerk(np.linspace(0.0, 1.0, at + 1 - docked))
    out = path.copy()
    out[:, :3] += share[:, None] * rotate_vector(path[at, 3:], away)
    return out


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
    return smooth_way(prepare(path, held, settings), moves)
