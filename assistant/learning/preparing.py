"""What is done once for a lesson before it is carried to setups (paper III-D a)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from assistant.errors import WorkFailed
from assistant.geometry import Array, compose, inverse, quat_continuous
from assistant.learning.amendments import (
    Bend,
    bends,
    commanded,
    hand_moves,
    speed_factors,
    station_moves,
)
from assistant.learning.holding import held_stretches
from assistant.learning.rigid import Rows
from assistant.learning.timing import (
    Hurry,
    hand_speeds,
    resting_steps,
    rms_jerk,
    turn_speeds,
)
from assistant.learning.ways import Span, Ways, prepare
from assistant.learning.weights import FrameWeights, frame_weights
from assistant.model.demonstration import frozen_array
from assistant.model.lesson import LearnedPath, Lesson, Station
from assistant.model.motion import HandStop, Indices
from assistant.model.settings import BlendingSettings, GeneralizationSettings
from assistant.model.task import Task

LEAST_WAY_M = 0.002
"""A hand that goes no further than this goes nowhere."""


@dataclass(frozen=True, slots=True, eq=False)
class AdaptationPlan:
    """A lesson prepared for adaptation.

    Parameters
    ----------
    task : str
    settings : BlendingSettings
    steps_s : array, shape (n - 1,)
        Times between samples at the lesson's own speed.
    resting : array of bool, shape (n - 1,)
        Steps within which the gripper acts: they are never hurried.
    gripper_m : array, shape (n,)
    primitive_at : array of int, shape (n,)
    stations : tuple of Station
    station_moves : array, shape (stations, 7)
        How far each hand is moved within its frame by corrections there and of its grasp.
    back : seven floats a station
        From the world of the demonstration into each moved frame.
    start_back : seven floats
        The inverse of the learned path's first pose.
    hands : seven floats a station
        The hand at each, in its frame, moved.
    ways : Ways
    weights : FrameWeights
        For eq. (6).
    bends : tuple of Bend
    ends_with_start : bool
        Whether the hand came back to where it started.
    peak_m_s : float
        Greatest speed of the demonstration, with the corrections of speed.
    turn_rad_s : float
        The hand never turns faster.
    brake : int
        Number of samples over which slowing down is spread.
    hurry : Hurry
        Where and how far ways that grew may be hurried.
    stops : tuple of HandStop
        The stations as samples of the path, with the corrections told there.
    """

    task: str
    settings: BlendingSettings
    steps_s: Array
    resting: Array
    gripper_m: Array
    primitive_at: Indices
    stations: tuple[Station, ...]
    station_moves: Array
    back: Rows
    start_back: list[float]
    hands: Rows
    ways: Ways
    weights: FrameWeights
    bends: tuple[Bend, ...]
    ends_with_start: bool
    peak_m_s: float
    turn_rad_s: float
    brake: int
    hurry: Hurry
    stops: tuple[HandStop, ...]


def plan_adaptation(task: Task, settings: BlendingSettings | None = None) -> AdaptationPlan:
    """Return what is prepared once for a lesson.

    Raises
    ------
    WorkFailed
        If the task has not been learned, or its demonstration did not record the hand, or
        nowhere brought it anywhere.
    """
    lesson, learned = carried_out(task)
    settings, stations = settings or BlendingSettings(), lesson.stations
    path = np.hstack([learned.path[:, :3], quat_continuous(learned.path[:, 3:])])
    _check_moved(task, path, stations)
    held, ends_with_start = held_stretches(path[:, :3], stations, settings)
    told = station_moves(task, lesson, settings.tool_m)
    moves = hand_moves(stations, told)
    frames = np.array([one.frame_to_world for one in stations]).reshape(-1, 7)
    factors = speed_factors(task, lesson, learned)
    factors = (factors[1:] + factors[:-1]) / 2.0
    steps_s = np.diff(learned.t_s) / factors
    pushes = _pushes(stations)
    acts, dwell_s = [one.at for one in stations], GeneralizationSettings().dwell_s
    resting = resting_steps(learned.t_s, acts, dwell_s)
    told_slower = factors < np.max(factors) - 1e-9
    least = np.where(resting.astype(bool) | told_slower, 1.0, settings.hurry_share)
    return AdaptationPlan(
        task=task.name,
        settings=settings,
        steps_s=steps_s,
        resting=resting,
        gripper_m=frozen_array(commanded(task, lesson, learned)),
        primitive_at=learned.primitive_at,
        stations=stations,
        station_moves=moves,
        back=compose(moves, inverse(frames)).tolist(),
        start_back=inverse(path[0]).tolist(),
        hands=[
            compose(move, one.hand_in_frame).tolist()
            for move, one in zip(moves, stations, strict=True)
        ],
        ways=prepare(path, held, settings, _jerk(lesson, learned), pushes),
        weights=frame_weights(
            path[:, :3], tuple((one.docking_at, one.at) for one in stations), settings
        ),
        bends=bends(task, lesson, learned, held),
        ends_with_start=ends_with_start,
        peak_m_s=float(np.max(hand_speeds(learned.t_s, path) * factors)),
        turn_rad_s=_turn_bound(settings, float(np.max(turn_speeds(learned.t_s, path) * factors))),
        brake=round(settings.brake_s / float(np.median(steps_s))),
        hurry=_hurry(path, steps_s, held, pushes, least),
        stops=tuple(_stop(one, move) for one, move in zip(stations, told, strict=True)),
    )


def carried_out(task: Task) -> tuple[Lesson, LearnedPath]:
    """Return what a task has learned, with the path that carries it out.

    Raises
    ------
    WorkFailed
        If it has not been learned, or its demonstration did not record the hand.
    """
    lesson = task.learned
    if lesson is None:
        raise WorkFailed(f"{task.name!r} has not been learned yet; demonstrate it first")
    if lesson.path is None:
        raise WorkFailed(
            f"{task.name!r} was shown without the gripper's opening, so where to grasp is not "
            "known; demonstrate it with the column gripper_m"
        )
    return lesson, lesson.path


def _check_moved(task: Task, path: Array, stations: Sequence[Station]) -> None:
    away_m = float(np.max(np.linalg.norm(path[:, :3] - path[0, :3], axis=1)))
    if stations and away_m < LEAST_WAY_M:
        raise WorkFailed(
            f"{task.name!r} was shown by a hand that closes and opens but never leaves its place, "
            "so there is no way to carry over; demonstrate it with the motion between"
        )


def _turn_bound(settings: BlendingSettings, shown_rad_s: float) -> float:
    return max(settings.turn_rad_s, min(shown_rad_s, settings.most_turn_rad_s))


def _hurry(
    path: Array,
    steps_s: Array,
    held: Sequence[Span],
    pushes: frozenset[int],
    least: Array,
) -> Hurry:
    """Return where ways that grew may be hurried: what is pushed keeps its pace."""
    ways = [slice(one[1], there[0]) for one, there in pairwise(held)]
    ways = [way for k, way in enumerate(ways) if k + 1 not in pushes and way.stop - way.start > 2]
    bends = np.linalg.norm(np.diff(path[:, :3], n=2, axis=0), axis=1)
    most = float(np.max(bends / (steps_s[1:] * steps_s[:-1]), initial=0.0))
    return Hurry(tuple(ways), least, max(most, 1e-9))


def _jerk(lesson: Lesson, learned: LearnedPath) -> float:
    """Return the demonstration's jerk in m, a sample's step being 1."""
    step_s = float(learned.t_s[1] - learned.t_s[0])
    return step_s**3 * (lesson.jerk_m_s3 or rms_jerk(learned.path[:, :3], step_s))


def _pushes(stations: Sequence[Station]) -> frozenset[int]:
    """Return the stretches, the start being 0, to which the thing touched before is pushed."""
    return frozenset(
        k + 2
        for k, (touched, there) in enumerate(pairwise(stations))
        if (touched.kind, there.kind) == ("touch", "touch")
        and touched.object == there.object != there.frame
    )


def _stop(one: Station, told: Array) -> HandStop:
    shift = tuple(told.tolist())
    return HandStop(one.at, one.kind, one.object, one.frame, one.docking_at, one.left_at, shift)
