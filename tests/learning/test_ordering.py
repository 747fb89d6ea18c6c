"""A lesson in another order: the same grasps and releases, joined without a jump."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import pairwise, permutations
from math import factorial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import (
    IDENTITY,
    Array,
    distance_between,
    pose_from_mm_deg,
    quat_blend,
    relative,
)
from assistant.learning.adaptation import adapt, frames_in, plan_adaptation
from assistant.learning.ordering import in_order, other_orders
from assistant.learning.timing import rms_jerk
from assistant.learning.weights import least_jerk
from assistant.model.conditions import Condition
from assistant.model.lesson import LearnedPath, Lesson, Segmentation, Station
from assistant.model.scene import Scene
from assistant.model.setup import Place, Setup
from assistant.model.task import Action, Order, Primitive, Subtask, Task

SCENE = Scene(hand_speed_m_s=1.0)
START = pose_from_mm_deg((406.4, 0.0, 635.0), (0.0, 0.0, 0.0))
STEP_S = 0.02
MOVE, REST = 100, 30


def hand_at(x_mm: float, y_mm: float, z_mm: float, yaw_deg: float = 0.0) -> Array:
    return np.asarray(pose_from_mm_deg((x_mm, y_mm, z_mm), (0.0, 0.0, yaw_deg)))


def spot(number: int, *, target: bool) -> tuple[float, float, float]:
    return 480.0 + 40.0 * number, (-1.0 if target else 1.0) * (120.0 + 60.0 * number), 400.0


def sorting(parts: int, order: Order = "any") -> Task:
    """Return a learned task in which so many things are put away."""
    leaves: list[tuple[Primitive, ...]] = []
    for k in range(parts):
        own = (
            Primitive(f"approach {k}", Action("move", "approach", f"thing {k}")),
            Primitive(f"grasp {k}", Action("hand", "close", f"thing {k}")),
            Primitive(f"place {k}", Action("hand", "open", f"place {k}")),
        )
        leaves.append(own)
    children = tuple(Subtask(f"part {k}", own) for k, own in enumerate(leaves))
    lesson = shown(parts)
    return Task("sorting", Subtask("sorting", children, order=order), learned=lesson)


@cache
def shown(parts: int) -> Lesson:
    poses, opening, labels = [START], [0.08], [0]
    stations = []

    def go(goal: Array, gap_m: float, label: int) -> None:
        share = least_jerk(np.arange(1, MOVE + 1) / MOVE)
        begin = poses[-1]
        for one in share:
            xyz = begin[:3] + one * (goal[:3] - begin[:3])
            poses.append(np.concatenate([xyz, quat_blend(begin[3:], goal[3:], np.array(one))]))
        opening.extend([gap_m] * MOVE)
        labels.extend([label] * MOVE)

    def act(gap_m: float, label: int) -> int:
        poses.extend([poses[-1]] * REST)
        opening.extend(np.linspace(opening[-1], gap_m, REST).tolist())
        labels.extend([label] * REST)
        return len(poses) - REST // 2

    for k in range(parts):
        for target in (False, True):
            x, y, z = spot(k, target=target)
            there = hand_at(x, y, z, 10.0 * k)
            first = 3 * k + 2 * target
            go(hand_at(x, y, z + 80.0, 10.0 * k), 0.04 if target else 0.08, first)
            docking_at = len(poses) - 1
            go(there, 0.04 if target else 0.08, first)
            at = act(0.08 if target else 0.04, 3 * k + 1 + target)
            go(hand_at(x, y, z + 60.0, 10.0 * k), opening[-1], 3 * k + 1 + target)
            frame = f"place {k}" if target else f"thing {k}"
            name = f"place {k}" if target else f"grasp {k}"
            docked = relative(there, poses[docking_at])
            stations.append(
                Station(
                    "release" if target else "grasp",
                    f"thing {k}",
                    frame,
                    name,
                    at,
                    docking_at,
                    len(poses) - 1 - MOVE // 2,
                    there,
                    IDENTITY,
                    docked,
                )
            )
    path = LearnedPath(
        STEP_S * np.arange(len(poses), dtype=float),
        np.array(poses),
        np.array(opening),
        np.array(labels, dtype=np.int64),
    )
    return Lesson(Segmentation((), (), None), path, tuple(stations))


@cache
def others(parts: int) -> list[tuple[tuple[str, ...], Task]]:
    return list(other_orders(sorting(parts)))


def placed(parts: int, seed: int) -> Setup:
    rng = np.random.default_rng(seed)
    places = {}
    for k in range(parts):
        for name, target in ((f"thing {k}", False), (f"place {k}", True)):
            x, y, z = np.array(spot(k, target=target)) + rng.uniform(-60.0, 60.0, 3)
            places[name] = Place("hand", (x, y, z), (0.0, 0.0, float(rng.uniform(-30.0, 30.0))))
    return Setup("moved", places=places)


def lesson_of(task: Task) -> tuple[Lesson, LearnedPath]:
    assert task.learned is not None
    assert task.learned.path is not None
    return task.learned, task.learned.path


@pytest.mark.parametrize("parts", [2, 3, 4])
def test_all_other_orders_are_there_once(parts: int) -> None:
    names = [f"part {k}" for k in range(parts)]
    found = [order for order, _ in others(parts)]
    assert len(found) == factorial(parts) - 1
    assert set(found) | {tuple(names)} == set(permutations(names))


@given(parts=st.integers(2, 4), pick=st.integers(0, 1000), seed=st.integers(0, 1000))
@settings(max_examples=10, deadline=None)
def test_every_grasp_and_release_is_as_exact_as_before(parts: int, pick: int, seed: int) -> None:
    orders = others(parts)
    names, task = orders[pick % len(orders)]
    setup = placed(parts, seed)
    plan = plan_adaptation(task)
    path = adapt(plan, SCENE, setup)
    stations = lesson_of(task)[0].stations
    assert [f"part {one.object[-1]}" for one in stations[::2]] == list(names)
    for frame, one in zip(frames_in(plan, SCENE, setup), stations, strict=True):
        assert float(distance_between(relative(frame, path.path[one.at]), IDENTITY)) < 1e-9
    np.testing.assert_allclose(path.path[0, :3], START[:3], atol=1e-9)


@given(parts=st.integers(2, 4), pick=st.integers(0, 1000))
@settings(max_examples=10, deadline=None)
def test_parts_keep_their_shape_and_are_joined_smoothly(parts: int, pick: int) -> None:
    task = sorting(parts)
    lesson, path = lesson_of(task)
    orders = others(parts)
    other, moved = lesson_of(orders[pick % len(orders)][1])
    for one in other.stations:
        was = next(old for old in lesson.stations if old.primitive == one.primitive)
        kept = slice(one.docking_at, one.left_at + 1)
        before = slice(was.docking_at, was.left_at + 1)
        np.testing.assert_allclose(moved.path[kept], path.path[before], atol=1e-12)
        assert moved.gripper_m is not None
        assert path.gripper_m is not None
        np.testing.assert_array_equal(moved.gripper_m[kept], path.gripper_m[before])
    np.testing.assert_array_equal(moved.path[0], path.path[0])
    steps = np.linalg.norm(np.diff(moved.path[:, :3], axis=0), axis=1)
    # No jump: an approach anew may be longer than the one shown, in the same time.
    assert steps.max() < 0.03
    assert steps[-1] < 1e-4
    assert rms_jerk(moved.path[:, :3], STEP_S) < 1.5 * rms_jerk(path.path[:, :3], STEP_S)
    assert np.all(np.diff(moved.t_s) > 0.0)


@pytest.mark.parametrize("parts", [2, 3])
def test_each_part_is_told_as_its_own_steps_in_turn(parts: int) -> None:
    for names, task in others(parts):
        labels = lesson_of(task)[1].primitive_at
        seen = [labels[0], *(b for a, b in pairwise(labels) if a != b)]
        assert seen == [3 * int(name[-1]) + k for name in names for k in range(3)]


def test_what_is_sequential_has_one_order() -> None:
    assert list(other_orders(sorting(3, "sequential"))) == []
    assert list(other_orders(replace(sorting(2), learned=None))) == []


def test_what_builds_on_another_part_is_not_moved_before_it() -> None:
    task = sorting(2)
    lesson, _ = lesson_of(task)
    *first, last = lesson.stations
    stacked = replace(lesson, stations=(*first, replace(last, frame="thing 0")))
    assert list(other_orders(replace(task, learned=stacked))) == []


def test_what_the_teacher_wants_before_a_step_binds_the_order() -> None:
    task = sorting(2)
    first, second = task.tree.parts
    assert isinstance(second, Subtask)
    approach, *rest = second.parts
    assert isinstance(approach, Primitive)
    told = replace(approach, before=(Condition("on", "thing 0", "place 0"),))
    bound = replace(task.tree, parts=(first, replace(second, parts=(told, *rest))))
    assert list(other_orders(replace(task, tree=bound))) == []


def test_parts_between_which_something_is_held_keep_their_order() -> None:
    task = sorting(2)
    lesson, _ = lesson_of(task)
    held = tuple(one for one in lesson.stations if one.primitive != "place 0")
    assert list(other_orders(replace(task, learned=replace(lesson, stations=held)))) == []


def test_an_order_is_found_again_by_its_names() -> None:
    task = sorting(3)
    names, other = next(other_orders(task))
    again = in_order(task, names)
    np.testing.assert_array_equal(lesson_of(again)[1].path, lesson_of(other)[1].path)
    assert in_order(task, ()) is task
    assert in_order(task, ("part 0", "part 1", "part 2")) is task
