"""The same lesson in another order, where the order is free (paper III-C c, "structure").

Parts that may come in any order are stretches of the learned path between which the hand is
empty. They are put one behind the other in another order; each is then approached from where
the hand is, in a motion that sets off as the part before it ended and becomes the approach that
was shown before the hand docks. Grasps, releases and all that is near them stay as they were.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice, pairwise, permutations

import numpy as np

from assistant.geometry import Array, interpolate, quat_continuous, quat_normalize
from assistant.learning.rests import braked
from assistant.learning.weights import least_jerk
from assistant.model.lesson import LearnedPath, Lesson, Station
from assistant.model.motion import Indices
from assistant.model.task import Subtask, Task, primitives, walk

Order = tuple[str, ...]
"""Names of the parts, in the order they are done."""

MOST_ORDERS = 23
"""No more are tried: all the others of four parts."""
FEWEST_SAMPLES = 10
"""A part is approached anew over at least so many samples."""
BRAKE_S = 0.5
"""What the hand was about to do is given up within this time."""


@dataclass(frozen=True, slots=True)
class Part:
    """A stretch of the learned path, samples `begin` up to but without `end`.

    Parameters
    ----------
    name : str
    begin, end : int
    docking_at : int
        Up to here it may be approached otherwise.
    """

    name: str
    begin: int
    end: int
    docking_at: int


def other_orders(task: Task) -> Iterator[tuple[Order, Task]]:
    """Yield the task in every other order its tree allows, with the names of the parts.

    Parameters
    ----------
    task : Task
        With a lesson; without a path, or where nothing is free, nothing is yielded.
    """
    lesson = task.learned
    if lesson is None or lesson.path is None:
        return
    for _, node in walk(task.tree):
        parts = _free_parts(node, task, lesson, lesson.path) if isinstance(node, Subtask) else ()
        for order in islice(permutations(parts), 1, 1 + MOST_ORDERS):
            learned = _reordered(lesson, lesson.path, parts, order)
            yield tuple(part.name for part in order), replace(task, learned=learned)


def in_order(task: Task, order: Order) -> Task:
    """Return the task in one of its other orders; as it is if that is none of them."""
    return next((other for names, other in other_orders(task) if names == order), task)


def _free_parts(node: Subtask, task: Task, lesson: Lesson, path: LearnedPath) -> tuple[Part, ...]:
    """Return the parts of a node as they were shown; none where their order is not free."""
    if node.order != "any":
        return ()
    names = [leaf.name for leaf in primitives(task.tree)]
    owner = np.full(len(path.primitive_at), -1, dtype=np.int64)
    for k, child in enumerate(node.parts):
        inside = [names.index(leaf.name) for leaf in primitives(child)]
        owner[np.isin(path.primitive_at, inside)] = k
    shown = np.flatnonzero(owner >= 0)
    if len(shown) == 0:
        return ()
    others = path.primitive_at[shown[0] : shown[-1] + 1][owner[shown[0] : shown[-1] + 1] < 0]
    changes = shown[np.flatnonzero(np.diff(owner[shown], prepend=-1))]
    told = [node.parts[owner[at]].name for at in changes]
    if len(told) < 2 or len(set(told)) < len(told) or np.any(others >= 0):
        return ()
    begins = [max(int(changes[0]), 1), *(_left(int(at), lesson) for at in changes[1:])]
    parts = []
    for name, (begin, end) in zip(told, pairwise([*begins, int(shown[-1]) + 1]), strict=True):
        inside_it = _stations(lesson, begin, end)
        if not inside_it or inside_it[0].docking_at - begin < FEWEST_SAMPLES:
            return ()
        parts.append(Part(name, begin, end, inside_it[0].docking_at))
    return tuple(parts) if _independent(node, lesson, parts) else ()


def _left(begin: int, lesson: Lesson) -> int:
    """Return where a part begins: not before the hand has left what it let go last."""
    return max([begin, *(one.left_at + 1 for one in lesson.stations if one.at < begin)])


def _stations(lesson: Lesson, begin: int, end: int) -> list[Station]:
    return [one for one in lesson.stations if begin <= one.at < end]


def _independent(node: Subtask, lesson: Lesson, parts: Sequence[Part]) -> bool:
    """Whether no part holds on to something, or builds on what another has moved."""
    inside = [_stations(lesson, part.begin, part.end) for part in parts]
    for stations in inside:
        acts = [one for one in stations if one.kind != "touch"]
        kinds = [one.kind for one in acts]
        if kinds != ["grasp", "release"] * (len(acts) // 2):
            return False
    before = [one.kind for one in lesson.stations if one.at < parts[0].begin]
    if before.count("grasp") != before.count("release"):
        return False
    children = {child.name: child for child in node.parts}
    for k, part in enumerate(parts):
        moved = {one.object for one in inside[k]}
        for other, stations in zip(parts, inside, strict=True):
            leaves = primitives(children[other.name])
            needed = {one.frame for one in stations} | {one.object for one in stations}
            needed |= {told.object or "" for leaf in leaves for told in leaf.before}
            if other is not part and moved & needed:
                return False
    return True


def _reordered(
    lesson: Lesson, path: LearnedPath, parts: Sequence[Part], order: Sequence[Part]
) -> Lesson:
    """Return the lesson with its parts in another order."""
    count = len(path.t_s)
    begin, end = parts[0].begin, parts[-1].end
    tail = Part("", end, count, count)
    pieces = [Part("", 0, begin, 0), *order, *((tail,) if end < count else ())]
    brake = max(round(BRAKE_S / float(path.t_s[1] - path.t_s[0])), 2)
    poses, source = [path.path[:begin]], [np.arange(begin)]
    for before, part in pairwise(pieces):
        stretch = path.path[part.begin : part.end]
        if before.end != part.begin:
            stretch = _approached(path.path, before.end - 1, part, brake)
        poses.append(stretch)
        source.append(np.arange(part.begin, part.end))
    if pieces[-1].end < count:
        # It was on its way to another part: it comes to rest instead.
        last = pieces[-1].end - 1
        poses.append(_giving_up(path.path, last, brake, brake))
        source.append(np.full(brake, last))
    primitive_at = _relabeled(path.primitive_at, parts)
    # The very start belongs to what comes first.
    owned = primitive_at[:begin] == primitive_at[begin]
    primitive_at[:begin][owned] = primitive_at[order[0].begin]
    renamed = replace(path, primitive_at=primitive_at)
    return _put_together(lesson, renamed, np.vstack(poses), np.concatenate(source))


def _put_together(lesson: Lesson, path: LearnedPath, poses: Array, source: Indices) -> Lesson:
    step_s = float(path.t_s[1] - path.t_s[0])
    # Where each sample went; what rests at the end repeats one, and the first of them counts.
    where = np.zeros(len(path.t_s), dtype=np.int64)
    where[source[::-1]] = np.arange(len(source))[::-1]
    learned = LearnedPath(
        step_s * np.arange(len(source), dtype=float),
        np.hstack([poses[:, :3], quat_continuous(quat_normalize(poses[:, 3:]))]),
        None if path.gripper_m is None else path.gripper_m[source],
        path.primitive_at[source],
    )
    stations = [
        replace(
            one,
            at=int(where[one.at]),
            docking_at=int(where[one.docking_at]),
            left_at=int(where[one.left_at]),
        )
        for one in lesson.stations
    ]
    return replace(lesson, path=learned, stations=tuple(sorted(stations, key=lambda one: one.at)))


def _relabeled(primitive_at: Indices, parts: Sequence[Part]) -> Indices:
    """Return whose samples are whose, leaving a place being the part's that was done there."""
    found = np.array(primitive_at)
    for before, part in pairwise(parts):
        own = found[before.begin : before.end]
        foreign = own == found[part.begin]
        if np.any(foreign):
            own[foreign] = own[np.flatnonzero(~foreign)[-1]]
    return found


def _approached(path: Array, left_at: int, part: Part, brake: int) -> Array:
    """Return a part that begins as the hand moves at another sample of the path."""
    stretch = np.array(path[part.begin : part.end])
    count = min(part.docking_at, part.end) - part.begin
    share = least_jerk(np.arange(1, count + 1) / (count + 1.0))
    onward = _giving_up(path, left_at, brake, count)
    stretch[:count] = interpolate(onward, stretch[:count], share)
    return stretch


def _giving_up(path: Array, at: int, brake: int, count: int) -> Array:
    """Return the samples after one, as they come when the hand brakes from there, (count, 7)."""
    from scipy.interpolate import CubicSpline

    share = np.minimum(np.arange(1, count + 1) / brake, 1.0)
    far = at + brake / 2.0 * braked(share)
    poses = np.hstack([path[:, :3], quat_continuous(path[:, 3:])])
    found = np.asarray(CubicSpline(np.arange(len(path)), poses)(np.minimum(far, len(path) - 1)))
    found[:, 3:] = quat_normalize(found[:, 3:])
    return found
