from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import Literal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.errors import BadInput, WorkFailed
from assistant.geometry import (
    IDENTITY,
    compose,
    distance_between,
    pose_from_mm_deg,
    relative,
)
from assistant.learning.adaptation import (
    AdaptationPlan,
    adapt,
    frames_in,
    plan_adaptation,
)
from assistant.learning.lesson import learn
from assistant.learning.timing import hand_speeds, turn_speeds
from assistant.model.feedback import Feedback
from assistant.model.motion import HandPath
from assistant.model.scene import Scene
from assistant.model.settings import BlendingSettings
from assistant.model.setup import Place, Setup
from assistant.model.task import primitives
from tests.learning.lessons import (
    BLOCK,
    SCENE,
    SHOWN,
    around,
    demonstration,
    errors,
    learned,
    lesson,
    moved,
    task,
)

Scheme = Literal["smooth", "paper", "two_frame", "azimuth"]
SCHEMES: tuple[Scheme, ...] = ("smooth", "paper", "two_frame", "azimuth")


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("seed", range(4))
def test_grasp_and_release_are_exact_in_any_setup(scheme: Scheme, seed: int) -> None:
    plan = plan_adaptation(learned(), BlendingSettings(scheme=scheme))
    setup = moved(np.random.default_rng(seed))
    path = adapt(plan, SCENE, setup)
    assert max(errors(plan, path, setup)) < 1e-9
    assert np.allclose(path.path[0], setup.robot_start.pose, atol=1e-12)
    assert np.allclose(np.linalg.norm(path.path[:, 3:], axis=1), 1.0)


@pytest.mark.parametrize("scheme", ["smooth", "two_frame"])
def test_the_shown_setup_gives_the_learned_path(scheme: Scheme) -> None:
    plan = plan_adaptation(learned(), BlendingSettings(scheme=scheme))
    path = adapt(plan, SCENE, SHOWN, start=plan.ways.path[0])
    assert np.max(distance_between(path.path, plan.ways.path)) < 1e-12


def test_the_printed_scheme_stays_at_the_start_while_lambda2_is_1() -> None:
    plan = plan_adaptation(learned(), BlendingSettings(scheme="paper"))
    path = adapt(plan, SCENE, SHOWN, start=plan.ways.path[0]).path
    docked = slice(plan.stations[0].docking_at, None)
    assert np.max(distance_between(path[docked], plan.ways.path[docked])) < 1e-9


def test_the_scene_bounds_the_hand() -> None:
    slow = Scene(hand_speed_m_s=0.05)
    path = adapt(plan_adaptation(learned()), slow, SHOWN, speed=2.0)
    assert np.max(hand_speeds(path.t_s, path.path)) <= 0.05 + 1e-12


@lru_cache
def prepared() -> AdaptationPlan:
    return plan_adaptation(learned())


@given(
    seed=st.integers(0, 10_000),
    speed=st.floats(0.2, 4.0),
    most_m_s=st.floats(0.02, 1.0),
)
@settings(max_examples=15, deadline=None)
def test_bounds_on_speed_hold_in_any_setup_at_any_speed(
    seed: int, speed: float, most_m_s: float
) -> None:
    plan = prepared()
    setup = around(np.random.default_rng(seed))
    path = adapt(plan, Scene(hand_speed_m_s=most_m_s), setup, speed=speed)
    fastest = float(np.max(hand_speeds(path.t_s, path.path)))
    assert fastest <= min(most_m_s, plan.peak_m_s * speed) * (1.0 + 1e-9)
    assert np.max(turn_speeds(path.t_s, path.path)) <= plan.turn_rad_s * (1.0 + 1e-9)
    own_s = plan.steps_s / np.where(plan.resting, min(speed, 1.0), speed)
    lasting_s = np.diff(path.t_s)
    assert np.all(lasting_s >= own_s * plan.hurry.least - 1e-9)
    for way in plan.hurry.ways:
        assert np.sum(lasting_s[way]) >= np.sum(own_s[way]) - 1e-9
    for first, last in plan.ways.held:
        assert np.all(lasting_s[first:last] >= own_s[first:last] - 1e-9)


@pytest.mark.parametrize("seed", range(6))
def test_a_way_that_grew_is_won_back_without_gaining_speed_quicker_than_shown(seed: int) -> None:
    plan, setup = prepared(), around(np.random.default_rng(seed))
    unhurried = replace(plan, hurry=replace(plan.hurry, ways=()))
    path, slow = adapt(plan, SCENE, setup), adapt(unhurried, SCENE, setup)
    assert path.t_s[-1] <= slow.t_s[-1] + 1e-9
    allowed = max(plan.hurry.greatest_m_s2, greatest_acceleration(slow))
    assert greatest_acceleration(path) < 1.1 * allowed


def greatest_acceleration(path: HandPath) -> float:
    even_s = np.arange(0.0, path.t_s[-1], 0.02)
    places = np.array([np.interp(even_s, path.t_s, column) for column in path.path[:, :3].T])
    return float(np.max(np.linalg.norm(np.diff(places, n=2, axis=1), axis=0))) / 0.02**2


def test_what_is_to_go_slower_than_the_rest_is_not_hurried() -> None:
    slower = Feedback("speed", "slower", "move up object", factor=0.5)
    made = learned()
    assert made.learned is not None
    assert made.learned.path is not None
    told = replace(made, learned=replace(made.learned, feedback=(slower,)))
    plan = plan_adaptation(told)
    names = [leaf.name for leaf in primitives(told.tree)]
    inside = made.learned.path.primitive_at[1:] == names.index("move up object")
    assert np.min(prepared().hurry.least[inside]) < 1.0
    assert np.all(plan.hurry.least[inside] == 1.0)


def test_the_path_is_smooth_where_stretches_join() -> None:
    plan = plan_adaptation(learned())
    path = adapt(plan, SCENE, moved(np.random.default_rng(3))).path
    third = np.linalg.norm(np.diff(path[:, :3], n=3, axis=0), axis=1)
    shown = np.linalg.norm(np.diff(plan.ways.path[:, :3], n=3, axis=0), axis=1)
    for first, last in plan.ways.held:
        for edge in (first, last):
            assert np.max(third[max(edge - 4, 0) : edge + 3], initial=0.0) < 1.2 * np.max(shown)


def test_a_block_turned_by_half_is_reached_and_always_the_same_way() -> None:
    setup = replace(SHOWN, places={**SHOWN.places, "block": replace(BLOCK, rpy_deg=(0, 0, 180.0))})
    plan = plan_adaptation(learned())
    path = adapt(plan, SCENE, setup)
    assert max(errors(plan, path, setup)) < 1e-9
    # To the left: half way, the hand points along +y.
    way = slice(0, plan.ways.held[1][0])
    forward = path.path[way, 3:]
    y = 2.0 * (forward[:, 0] * forward[:, 1] + forward[:, 3] * forward[:, 2])
    assert np.max(y) > 0.95


def test_the_hand_rests_while_the_gripper_acts_at_any_speed() -> None:
    plan = plan_adaptation(learned())
    for speed in (0.5, 1.0, 2.0):
        path = adapt(plan, SCENE, SHOWN, speed=speed)
        for stop in path.stops:
            still = distance_between(path.path, path.path[stop.at]) < 1e-6
            assert path.t_s[still].max() - path.t_s[still].min() >= 0.4 - 1e-9


def test_half_speed_takes_twice_the_time() -> None:
    plan = plan_adaptation(learned())
    whole, half = adapt(plan, SCENE, SHOWN), adapt(plan, SCENE, SHOWN, speed=0.5)
    assert half.t_s[-1] == pytest.approx(2.0 * whole.t_s[-1], rel=1e-3)


def test_a_start_that_is_measured_stands_instead_of_the_setups() -> None:
    start = pose_from_mm_deg((450.0, 50.0, 600.0), (0.0, 0.0, 10.0))
    path = adapt(plan_adaptation(learned()), SCENE, SHOWN, start=start)
    assert np.allclose(path.path[0], start)


def test_a_place_that_is_missing_is_named() -> None:
    setup = Setup("bare", places={"block": BLOCK})
    with pytest.raises(BadInput, match="target"):
        adapt(plan_adaptation(learned()), SCENE, setup)


def test_what_is_put_down_without_having_been_grasped_needs_a_place_too() -> None:
    plan = plan_adaptation(learned())
    grasp, release = plan.stations
    plan = replace(plan, stations=(replace(release, frame="target"), grasp))
    with pytest.raises(BadInput, match="no place for 'block'"):
        adapt(plan, SCENE, replace(SHOWN, places={"target": SHOWN.places["target"]}))


def test_a_path_given_to_the_arm_cannot_be_written_to() -> None:
    plan = plan_adaptation(learned())
    path = adapt(plan, SCENE, SHOWN)
    for values in (path.t_s, path.path, path.gripper_m):
        with pytest.raises(ValueError, match="read-only"):
            values[0] = 1.0


def test_speed_must_be_above_zero() -> None:
    with pytest.raises(BadInput, match="above 0"):
        adapt(plan_adaptation(learned()), SCENE, SHOWN, speed=0.0)


def test_what_was_not_learned_is_told() -> None:
    with pytest.raises(WorkFailed, match="not been learned"):
        plan_adaptation(task())
    handless = learn([demonstration(gripper=False)], task())
    with pytest.raises(WorkFailed, match="gripper"):
        plan_adaptation(replace(task(), learned=handless))


def test_a_released_object_is_a_target_afterwards() -> None:
    made = lesson()
    first = made.stations[0]
    again = replace(first, kind="release", object="other", docking_at=770, at=780, left_at=790)
    plan = plan_adaptation(replace(task(), learned=replace(made, stations=(*made.stations, again))))
    setup = moved(np.random.default_rng(1))
    frames = frames_in(plan, SCENE, setup)
    put = relative(plan.stations[0].hand_in_frame, IDENTITY)
    hand = compose(frames[1], plan.stations[1].hand_in_frame)
    assert np.allclose(frames[2], compose(hand, put), atol=1e-12)


def test_a_path_near_the_base_is_carried_straight() -> None:
    plan = plan_adaptation(learned(), BlendingSettings(least_radius_m=2.0))
    assert not plan.ways.polar
    setup = moved(np.random.default_rng(2))
    assert max(errors(plan, adapt(plan, SCENE, setup), setup)) < 1e-9


def test_body_places_need_no_body_in_the_scene() -> None:
    setup = replace(SHOWN, places={**SHOWN.places, "block": Place("body", (560.0, 190.0, 300.0))})
    plan = plan_adaptation(learned())
    assert max(errors(plan, adapt(plan, SCENE, setup), setup)) < 1e-9
