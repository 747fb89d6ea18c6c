from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from assistant.files.demonstrations import read_demonstration
from assistant.files.scenes import find_scene
from assistant.files.tasks import read_task
from assistant.geometry import (
    IDENTITY,
    Array,
    angle_between,
    compose,
    distance_between,
    pose_from_mm_deg,
)
from assistant.learning.adaptation import plan_adaptation
from assistant.learning.lesson import learn
from assistant.learning.timing import rms_jerk
from assistant.learning.ways import prepare, smooth_way
from assistant.model.settings import BlendingSettings
from tests.learning.lessons import learned

TASKS = Path(__file__).parents[2] / "tasks"


def about_base(degrees: float) -> list[float]:
    pose: list[float] = pose_from_mm_deg((0.0, 0.0, 0.0), (0.0, 0.0, degrees)).tolist()
    return pose


def turned(path: Array, move: list[float]) -> Array:
    return compose(np.array(move), path)


def test_nothing_moved_is_the_learned_path() -> None:
    ways = plan_adaptation(learned()).ways
    path = smooth_way(ways, [IDENTITY.tolist()] * len(ways.held))
    assert np.max(distance_between(path, ways.path)) < 1e-12


@pytest.mark.parametrize("degrees", [30.0, -75.0])
def test_all_turned_about_the_base_is_the_path_turned(degrees: float) -> None:
    ways = plan_adaptation(learned()).ways
    move = about_base(degrees)
    path = smooth_way(ways, [move] * len(ways.held))
    assert np.max(distance_between(path, turned(ways.path, move))) < 1e-12
    assert np.max(angle_between(path, turned(ways.path, move))) < 1e-6


@pytest.mark.parametrize("degrees", [150.0, 210.0, -190.0])
def test_ways_do_not_cut_across_the_base(degrees: float) -> None:
    ways = plan_adaptation(learned()).ways
    here, there = about_base(0.0), about_base(degrees / 3.0)
    path = smooth_way(ways, [here, here, there])
    again = smooth_way(ways, [here, about_base(-degrees / 3.0), there])
    least = np.min(np.hypot(ways.path[:, 0], ways.path[:, 1]))
    for one in (path, again):
        assert np.min(np.hypot(one[:, 0], one[:, 1])) > 0.85 * least


def test_what_is_pushed_does_not_swing_around_the_base_where_it_passes_its_back() -> None:
    plan = plan_adaptation(learned())
    middle = plan.ways.path[plan.ways.held[1][1]]
    away = float(np.rad2deg(np.arctan2(middle[1], middle[0])))
    moves = [about_base(0.0), about_base(179.0 - away)]
    following = plan.ways.path[plan.ways.held[2][1]]
    back = float(np.rad2deg(np.arctan2(following[1], following[0])))
    moves.append(about_base(-179.0 - back))
    settings = BlendingSettings()
    way = slice(plan.ways.held[1][1], plan.ways.held[2][0] + 1)
    around = smooth_way(prepare(plan.ways.path, plan.ways.held, settings), moves)[way]
    pushed = prepare(plan.ways.path, plan.ways.held, settings, onward=frozenset({2}))
    straight = smooth_way(pushed, moves)[way]
    assert np.max(around[:, 0]) > 0.2
    assert np.max(straight[:, 0]) < 0.0


def test_only_what_was_touched_and_is_then_brought_elsewhere_is_pushed() -> None:
    assert plan_adaptation(learned()).ways.onward == frozenset()
    task = read_task(TASKS / "pushing.yaml")
    path = TASKS / "demonstrations" / "pushing.yaml"
    shown = read_demonstration(path)
    scene = find_scene(shown.setup.scene, path)
    lesson = learn([shown], task, scene=scene)
    assert plan_adaptation(replace(task, learned=lesson)).ways.onward == frozenset({2})


def test_evening_leads_no_further_than_told_and_lowers_jerk() -> None:
    task = learned(noise_m=0.0005)
    plan, settings = plan_adaptation(task), BlendingSettings()
    moves = [about_base(0.0), about_base(-60.0), about_base(70.0)]
    rough = smooth_way(prepare(plan.ways.path, plan.ways.held, settings), moves)
    even = smooth_way(prepare(plan.ways.path, plan.ways.held, settings, 0.0), moves)
    assert 0.0 < np.max(distance_between(rough, even)) <= settings.even_m
    assert rms_jerk(even[:, :3], 0.02) < rms_jerk(rough[:, :3], 0.02)
    for first, last in plan.ways.held:
        assert np.array_equal(rough[first : last + 1], even[first : last + 1])


def test_ways_next_to_each_other_need_no_samples_between() -> None:
    path = plan_adaptation(learned()).ways.path
    held = ((0, 0), (1, 400), (402, len(path) - 1))
    ways = prepare(path, held, BlendingSettings(), 1e-6)
    moved = smooth_way(ways, [about_base(10.0)] * 3)
    assert np.max(distance_between(moved, turned(path, about_base(10.0)))) < 1e-12
