from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import (
    IDENTITY,
    Array,
    angle_between,
    compose,
    distance_between,
    pose_from_mm_deg,
)
from assistant.learning.adaptation import plan_adaptation
from assistant.learning.timing import rms_jerk
from assistant.learning.ways import prepare, smooth_way
from assistant.model.settings import BlendingSettings
from tests.learning.lessons import learned


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
