"""Learn a task from demonstrations: cut, assign, generalize path and structure (paper III)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import PurePath

import numpy as np

from assistant.errors import BadInput
from assistant.geometry import Array, compose, inverse, relative, rotate_vector
from assistant.learning.arriving import arrival, site_of
from assistant.learning.conditions import Inferred, inferred
from assistant.learning.docking import (
    docking_sample,
    grasp_ways,
    level,
    release_ways,
    straightened,
)
from assistant.learning.generalization import Sampled, primitive_at, sampled, shown_jerk
from assistant.learning.segmentation import segment
from assistant.learning.signals import gripper_events
from assistant.learning.smoothing import smooth
from assistant.learning.stations import Visit, frames, told_for_hand, touches, visits
from assistant.learning.structure import optional_questions, order_questions
from assistant.learning.waiting import without_waits
from assistant.model.demonstration import Demonstration
from assistant.model.lesson import LearnedPath, Lesson, Segmentation, Station
from assistant.model.motion import Indices
from assistant.model.scene import Scene
from assistant.model.settings import GeneralizationSettings, SegmentationSettings, SignalSettings
from assistant.model.task import Task, primitives

_LEAD_S = 0.06


@dataclass(frozen=True, slots=True)
class Context:
    """What stays the same while one demonstration is generalized."""

    demonstration: Demonstration
    task: Task
    scene: Scene | None
    given: GeneralizationSettings


def learn(
    demonstrations: Sequence[Demonstration],
    task: Task,
    *,
    cuts_s: Sequence[float] | None = None,
    assigned: Sequence[tuple[int, str]] = (),
    scene: Scene | None = None,
    settings: SegmentationSettings | None = None,
) -> Lesson:
    """Return what the demonstrations of one task teach.

    Parameters
    ----------
    demonstrations : sequence of Demonstration
        Several are learned from together.
    task : Task
        As introduced; corrections it was given before are kept.
    cuts_s, assigned : optional
        What the teacher fixed, of the last demonstration; as in `segment`.
    scene : Scene, optional
        Tells surface normals, and relates bodies to hands.
    settings : SegmentationSettings, optional

    Raises
    ------
    NothingLearned
        If nothing that could be carried out was shown.
    BadInput
        If there is no demonstration.
    """
    if not demonstrations:
        raise BadInput.one("demonstrations", "none given", "at least one is needed")
    last = len(demonstrations) - 1
    prepared = [told_for_hand(one, scene) for one in demonstrations]
    given = settings
    if last:
        from assistant.learning.together import one_teacher

        given = one_teacher(prepared, task, settings or SegmentationSettings())
    lessons = [
        _learn_one(
            demonstration,
            task,
            scene,
            segment(
                told,
                task,
                given,
                cuts_s=cuts_s if k == last else None,
                assigned=assigned if k == last else (),
            ),
        )
        for k, (demonstration, told) in enumerate(zip(demonstrations, prepared, strict=True))
    ]
    lesson = _in_order(lessons[0], task)
    if last:
        from assistant.learning.together import together

        lesson = together(lessons, task)
    if task.learned is None:
        return lesson
    return replace(lesson, feedback=task.learned.feedback, speed=task.learned.speed)


def _in_order(lesson: Lesson, task: Task) -> Lesson:
    """Return the lesson with the question whether an order that was not told may vary."""
    found = lesson.segmentation
    asked = (*found.questions, *order_questions(task, [found]))
    return replace(lesson, segmentation=replace(found, questions=asked))


def load_libraries() -> None:
    """Import what learning uses later, so that its time can be told without imports."""
    import_module("scipy.interpolate")


def _learn_one(
    demonstration: Demonstration, task: Task, scene: Scene | None, found: Segmentation
) -> Lesson:
    lesson = Lesson(
        segmentation=found,
        path=None,
        sources=(PurePath(demonstration.source).name,),
        approach_axis=demonstration.approach_axis,
    )
    if demonstration.recording.gripper_m is None:
        return lesson
    context = Context(demonstration, task, scene, GeneralizationSettings())
    smoothed = smooth(demonstration.recording, SegmentationSettings().smoothing)
    events = gripper_events(demonstration.recording, SignalSettings())
    acted = visits(task, events, found.episodes)
    seen = (*acted, *touches(task, found.episodes, acted))
    seen = tuple(sorted(seen, key=lambda visit: visit.at_s))
    acts_s = np.array([visit.at_s for visit in seen])
    moving, clock = without_waits(smoothed, acts_s.tolist(), context.given)
    even = sampled(moving, clock.shortened(acts_s).tolist(), context.given)
    even = replace(even, shown_s=clock.shown(even.shown_s))
    step_s = float(even.t_s[1] - even.t_s[0])
    lesson = replace(lesson, jerk_m_s3=shown_jerk(moving, step_s))
    return _generalized(context, lesson, even, seen)


def _generalized(
    context: Context, lesson: Lesson, even: Sampled, seen: tuple[Visit, ...]
) -> Lesson:
    leaves = primitives(context.task.tree)
    names = [leaf.name for leaf in leaves]
    position = primitive_at(even.shown_s, lesson.segmentation.episodes, names)
    path, stations = _docked(context, lesson.segmentation, even, seen)
    _while_acting(position, stations, names, even.t_s, context.given.dwell_s)
    states = inferred(leaves, path, position, stations, context.scene)
    return replace(
        lesson,
        segmentation=_with_questions(context.task, lesson.segmentation, states, names, position),
        path=LearnedPath(even.t_s, path, even.gripper_m, position),
        stations=stations,
        before={name: those for name, those in states.before.items() if those},
        until={name: those for name, those in states.until.items() if those},
    )


def _while_acting(
    position: Indices,
    stations: tuple[Station, ...],
    names: Sequence[str],
    t_s: Array,
    dwell_s: float,
) -> None:
    """Let the primitive that grasps or releases begin before the gripper acts, and outlast it.

    What has to hold before it is looked at when it begins: a hand that opens holds no longer.
    """
    for station in stations:
        if station.kind != "touch" and station.primitive in names:
            after_s = t_s - t_s[station.at]
            begun = after_s >= -dwell_s / 2.0 - _LEAD_S - 1e-9
            position[begun & (after_s <= dwell_s / 2.0 + 1e-9)] = names.index(station.primitive)


def _with_questions(
    task: Task,
    found: Segmentation,
    states: Inferred,
    names: Sequence[str],
    position: Indices,
) -> Segmentation:
    shown = [names[at] for at in np.unique(position) if at >= 0]
    return replace(found, questions=(*found.questions, *optional_questions(task, states, shown)))


def _docked(
    context: Context, found: Segmentation, even: Sampled, seen: tuple[Visit, ...]
) -> tuple[Array, tuple[Station, ...]]:
    """Return the path with straight docking, and its stations."""
    path, given = even.path, context.given
    placed = frames(seen, even.path[list(even.acts)], context.demonstration, context.scene)
    stations: list[Station] = []
    earliest = 0
    for k, (visit, at) in enumerate(zip(seen, even.acts, strict=True)):
        suggested = _suggested(found, visit, even.shown_s)
        if visit.kind == "touch":
            # A place to push from or to is a docking pose itself, with all of the way between;
            # what is done there with a thing in the hand keeps its shape from its beginning.
            docking_at = at
            if _holds(seen[:k]):
                site = site_of(visit.object, visit.frame, placed[k], context.scene)
                begin = min(max(suggested, earliest), at)
                docking_at = arrival(path, earliest, begin, at, site, given)
        else:
            docking_at = docking_sample(path[:, :3], at, suggested, earliest, given)
            ways = _ways(context, visit, path[at], placed[k])
            path = straightened(
                path, at, docking_at, ways, earliest, given.settle_m, given.docking_near_m
            )
        latest = even.acts[k + 1] if k + 1 < len(seen) else len(path) - 1
        pushes = [one.kind for one in seen[k : k + 2]] == ["touch", "touch"]
        left_at = at if pushes else _left(path[:, :3], at, latest, given.leave_m)
        stations.append(
            Station(
                kind=visit.kind,
                object=visit.object,
                frame=visit.frame,
                primitive=visit.primitive,
                at=at,
                docking_at=docking_at,
                left_at=left_at,
                frame_to_world=placed[k],
                hand_in_frame=relative(placed[k], path[at]),
                docking_in_frame=relative(placed[k], path[docking_at]),
            )
        )
        earliest = left_at
    return path, tuple(stations)


def _suggested(found: Segmentation, visit: Visit, shown_s: Array) -> int:
    """Return the sample at which the primitive of a visit begins, which is where docking ends."""
    own = [part.from_s for part in found.episodes if part.primitive == visit.primitive]
    begin_s = min(own) if own else visit.at_s
    return int(np.searchsorted(shown_s, min(begin_s, visit.at_s)))


def _holds(before: Sequence[Visit]) -> bool:
    acted = [visit for visit in before if visit.kind != "touch"]
    return bool(acted) and acted[-1].kind == "grasp"


def _ways(context: Context, visit: Visit, hand: Array, frame: Array) -> Array:
    if visit.kind != "release":
        return grasp_ways(context.demonstration.approach_axis)
    normal = np.array([0.0, 0.0, 1.0])
    body = context.scene.bodies.get(visit.frame) if context.scene else None
    if body is not None:
        turn = compose(frame, inverse(body.hand_in_body))[3:]
        if visit.frame not in context.demonstration.setup.places:
            # How it is held is not known either: it lies level, however the hand leans.
            turn = level(hand)
        normal = rotate_vector(turn, np.array(body.normal) / np.linalg.norm(body.normal))
    return release_ways(normal, hand)


def _left(xyz: Array, at: int, latest: int, leave_m: float) -> int:
    """Return where the hand has left a station, at the latest half way to the next."""
    steps = np.linalg.norm(np.diff(xyz[at : latest + 1], axis=0), axis=1)
    travel = np.concatenate([[0.0], np.cumsum(steps)])
    enough = min(leave_m, 0.3 * float(travel[-1]))
    return at + int(np.searchsorted(travel, enough))
