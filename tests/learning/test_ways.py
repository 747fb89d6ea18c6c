from __future__ import annotations

import itertools
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.files.demonstrations import read_demonstration
from assistant.files.scenes import find_scene
from assistant.files.tasks import read_task
from assistant.geometry import (
    IDENTITY,
    Array,
    angle_between,
    compose,
    distance_between,
    interpolate,
    pose_from_mm_deg,
    quat_from_rotvec,
    quat_multiply,
    quat_normalize,
    rotate_vector,
)
from assistant.learning.adaptation import plan_adaptation
from assistant.learning.lesson import learn
from assistant.learning.timing import rms_jerk
from assistant.learning.ways import Ways, prepare, smooth_way
from assistant.learning.weights import least_jerk, quintic
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
    given_settings = BlendingSettings()
    way = slice(plan.ways.held[1][1], plan.ways.held[2][0] + 1)
    around = smooth_way(prepare(plan.ways.path, plan.ways.held, given_settings), moves)[way]
    pushed = prepare(plan.ways.path, plan.ways.held, given_settings, onward=frozenset({2}))
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
    plan, told = plan_adaptation(task), BlendingSettings()
    moves = [about_base(0.0), about_base(-60.0), about_base(70.0)]
    rough = smooth_way(prepare(plan.ways.path, plan.ways.held, told), moves)
    even = smooth_way(prepare(plan.ways.path, plan.ways.held, told, 0.0), moves)
    assert 0.0 < np.max(distance_between(rough, even)) <= told.even_m
    assert rms_jerk(even[:, :3], 0.02) < rms_jerk(rough[:, :3], 0.02)
    for first, last in plan.ways.held:
        assert np.array_equal(rough[first : last + 1], even[first : last + 1])


def test_no_more_is_evened_than_jerk_asks_for() -> None:
    """What jerk is left, computed from the path itself, is what was allowed."""
    ways = plan_adaptation(learned(noise_m=0.0005)).ways
    moves = [about_base(0.0), about_base(-20.0), about_base(25.0)]
    rough = smooth_way(replace(ways, most=np.inf), moves)
    allowed = 0.9 * jerk_between(ways, rough)
    even = smooth_way(replace(ways, most=allowed), moves)
    assert jerk_between(ways, even) == pytest.approx(allowed, rel=1e-9)


def test_a_way_that_is_the_only_one_is_evened_too() -> None:
    shown = plan_adaptation(learned(noise_m=0.0005)).ways
    end = shown.held[1][1] + 1
    ways = prepare(shown.path[:end], shown.held[:2], BlendingSettings())
    moves = [about_base(-20.0), about_base(25.0)]
    allowed = 0.9 * jerk_between(ways, smooth_way(ways, moves))
    even = smooth_way(replace(ways, most=allowed), moves)
    assert jerk_between(ways, even) == pytest.approx(allowed, rel=1e-9)


def jerk_between(ways: Ways, path: Array) -> float:
    """Return the sum of squared third differences within the ways."""
    found = 0.0
    for (_, first), (last, _) in itertools.pairwise(ways.held):
        found += float(np.sum(np.diff(path[first + 1 : last, :3], n=3, axis=0) ** 2))
    return found


@given(seed=st.integers(0, 10_000), polar=st.booleans())
@settings(max_examples=20, deadline=None)
def test_a_way_is_what_its_description_says(seed: int, polar: bool) -> None:
    """The plain computation, way by way and sample by sample, gives the same path."""
    rng = np.random.default_rng(seed)
    ways = plan_adaptation(learned()).ways
    # Neither pressed outward nor evened out.
    ways = replace(ways, keep=-np.inf, most=np.inf, polar=polar)
    away = rng.uniform((-100, -100, -80, -20, -20, -90), (60, 100, 50, 20, 20, 90), (3, 6))
    turns = [about_base(float(one)) for one in rng.uniform(-60.0, 60.0, 3)]
    moves = compose(np.array(turns), pose_from_mm_deg(away[:, :3], away[:, 3:]))
    path = smooth_way(ways, moves.tolist())
    for k, (first, last) in enumerate(ways.held):
        rigid = compose(moves[k], ways.path[first : last + 1])
        assert np.max(distance_between(path[first : last + 1], rigid)) < 1e-12
        assert np.max(angle_between(path[first : last + 1], rigid)) < 1e-7
    for k, ((_, first), (last, _)) in enumerate(itertools.pairwise(ways.held)):
        plain = plain_way(ways, (first, last), moves[k], moves[k + 1], k)
        assert np.max(distance_between(path[first + 1 : last], plain)) < 1e-12
        assert np.max(angle_between(path[first + 1 : last], plain)) < 1e-7


def plain_way(ways: Ways, span: tuple[int, int], here: Array, there: Array, k: int) -> Array:
    first, last = span
    share = np.arange(1, last - first) / (last - first)
    made, joining = least_jerk(share)[:, None], quintic(share, last - first)
    shown = ends_of(ways.path, first, last)
    added = ways.path[first + 1 : last, :3] - joining @ shown
    ends = [ends_of(compose(move, ways.path), first, last) for move in (here, there)]
    upright = [rotate_vector(vertical_part(move), added) for move in (here, there)]
    xyz = joining @ np.vstack([ends[0][:3], ends[1][3:]])
    xyz += (1.0 - made) * upright[0] + made * upright[1]
    azimuths = [azimuth(move, ways.middles[k + j]) for j, move in enumerate((here, there))]
    azimuths = azimuths if ways.polar else [0.0, 0.0]
    backs = np.array([about_base(-float(np.rad2deg(one))) for one in azimuths])
    rests = compose(backs, np.stack([here, there]))
    arcs = interpolate(rests[0], rests[1], made[:, 0])
    swung = azimuths[0] + (azimuths[1] - azimuths[0]) * made[:, 0]
    quats = quat_multiply(quat_from_rotvec(swung[:, None] * np.array([0.0, 0.0, 1.0])), arcs[:, 3:])
    return np.hstack([xyz, quat_multiply(quats, ways.path[first + 1 : last, 3:])])


def ends_of(path: Array, first: int, last: int) -> Array:
    """Return value, slope and curvature at both ends."""
    rows: list[Array] = []
    for at in (first, last):
        before, here, after = path[np.clip([at - 1, at, at + 1], 0, len(path) - 1), :3]
        rows += [here, (after - before) / 2.0, before - 2.0 * here + after]
    return np.array(rows)


def vertical_part(move: Array) -> Array:
    return quat_normalize(np.array([0.0, 0.0, move[5], move[6]]))


def azimuth(move: Array, middle: list[float]) -> float:
    x, y, _ = compose(move, np.array([*middle, 0.0, 0.0, 0.0, 1.0]))[:3]
    return float(np.arctan2(y, x) - np.arctan2(middle[1], middle[0]))


def test_ways_next_to_each_other_need_no_samples_between() -> None:
    path = plan_adaptation(learned()).ways.path
    held = ((0, 0), (1, 400), (402, len(path) - 1))
    ways = prepare(path, held, BlendingSettings(), 1e-6)
    moved = smooth_way(ways, [about_base(10.0)] * 3)
    assert np.max(distance_between(moved, turned(path, about_base(10.0)))) < 1e-12
