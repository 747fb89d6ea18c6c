from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.errors import BadInput, WorkFailed
from assistant.geometry import (
    IDENTITY,
    angle_between,
    compose,
    distance_between,
    pose_from_mm_deg,
    relative,
    transform_points,
)
from assistant.learning.adaptation import AdaptationPlan, adapt, frames_in, plan_adaptation
from assistant.learning.lesson import learn
from assistant.learning.measures import measured
from assistant.learning.timing import hand_speeds, turn_speeds
from assistant.model.feedback import Feedback
from assistant.model.motion import HandPath
from assistant.model.scene import Scene
from assistant.model.settings import BlendingSettings
from assistant.model.setup import Place, Setup
from tests.learning.lessons import BLOCK, TARGET, demonstration, learned, lesson, moved, task

SCENE = Scene(hand_speed_m_s=1.0)
SHOWN = Setup("shown", places={"block": BLOCK, "target": TARGET})
Scheme = Literal["smooth", "paper", "two_frame", "azimuth"]
SCHEMES: tuple[Scheme, ...] = ("smooth", "paper", "two_frame", "azimuth")


def errors(plan: AdaptationPlan, path: HandPath, setup: Setup) -> list[float]:
    found = []
    for frame, one in zip(frames_in(plan, SCENE, setup), plan.stations, strict=True):
        seen = relative(frame, path.path[one.at])
        found.append(float(distance_between(seen, one.hand_in_frame)))
        found.append(float(angle_between(seen, one.hand_in_frame)))
    return found


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


@given(seed=st.integers(0, 10_000))
@settings(max_examples=15, deadline=None)
def test_speed_is_bounded_and_duration_stays_near(seed: int) -> None:
    made = learned()
    plan, setup = plan_adaptation(made), moved(np.random.default_rng(seed))
    path = adapt(plan, SCENE, setup)
    told = measured(made, plan, path, SCENE, setup)
    assert told["peak_speed_ratio"] <= 1.0
    assert told["jerk_ratio"] <= 1.3
    assert told["duration_ratio"] <= 1.5
    assert np.all(np.diff(path.t_s) > 0)
    assert np.max(turn_speeds(path.t_s, path.path)) <= plan.settings.turn_rad_s + 1e-9


def test_the_scene_bounds_the_hand() -> None:
    slow = Scene(hand_speed_m_s=0.05)
    path = adapt(plan_adaptation(learned()), slow, SHOWN, speed=2.0)
    assert np.max(hand_speeds(path.t_s, path.path)) <= 0.05 + 1e-12


@given(seed=st.integers(0, 10_000))
@settings(max_examples=10, deadline=None)
def test_shape_is_kept_over_the_last_ten_centimetres(seed: int) -> None:
    plan, setup = plan_adaptation(learned()), moved(np.random.default_rng(seed))
    path = adapt(plan, SCENE, setup).path
    frames = frames_in(plan, SCENE, setup)
    shown = plan.ways.path
    steps = np.linalg.norm(np.diff(shown[:, :3], axis=0), axis=1)
    travel = np.concatenate([[0.0], np.cumsum(steps)])
    for frame, one in zip(frames, plan.stations, strict=True):
        last = (travel <= travel[one.at]) & (travel >= travel[one.at] - 0.10)
        here = relative(frame, path[last])
        there = relative(one.frame_to_world, shown[last])
        assert np.max(distance_between(here, there)) < 5e-4
        assert np.max(angle_between(here, there)) < 1e-6


@given(seed=st.integers(0, 10_000))
@settings(max_examples=15, deadline=None)
def test_noise_of_told_poses_is_not_amplified(seed: int) -> None:
    rng = np.random.default_rng(seed)
    plan, setup = plan_adaptation(learned()), moved(rng)
    noisy = {
        name: replace(place, xyz_mm=tuple(np.array(place.xyz_mm) + rng.uniform(-0.5, 0.5, 3)))
        for name, place in setup.places.items()
    }
    away = max(
        float(np.linalg.norm(np.array(noisy[name].xyz_mm) - np.array(place.xyz_mm)))
        for name, place in setup.places.items()
    )
    here = adapt(plan, SCENE, setup).path
    there = adapt(plan, SCENE, replace(setup, places=noisy)).path
    assert np.max(distance_between(here, there)) * 1000.0 < 1.3 * away


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


def test_speed_must_be_above_zero() -> None:
    with pytest.raises(BadInput, match="above 0"):
        adapt(plan_adaptation(learned()), SCENE, SHOWN, speed=0.0)


def test_what_was_not_learned_is_told() -> None:
    with pytest.raises(WorkFailed, match="not been learned"):
        plan_adaptation(task())
    handless = learn([demonstration(gripper=False)], task())
    with pytest.raises(WorkFailed, match="gripper"):
        plan_adaptation(replace(task(), learned=handless))


def nudge(primitive: str, offset_m: tuple[float, float, float], frame: str = "") -> Feedback:
    return Feedback("translate", "a bit more", primitive, frame=frame, offset_m=offset_m)


def test_a_correction_at_the_target_moves_with_it() -> None:
    corrected = plan_adaptation(learned([nudge("place object", (0.0, 0.005, 0.0), "target")]))
    plain = plan_adaptation(learned())
    for seed in range(3):
        setup = moved(np.random.default_rng(seed))
        here, there = (adapt(plan, SCENE, setup).path for plan in (plain, corrected))
        frame = frames_in(plain, SCENE, setup)[1]
        one = plain.stations[1]
        shift = relative(frame, there[one.at]) - relative(frame, here[one.at])
        assert np.allclose(shift[:3], (0.0, 0.005, 0.0), atol=1e-12)
        # The whole stretch goes along, so its shape is kept; the grasp stays.
        held = slice(plain.ways.held[2][0], one.at)
        moved_by = relative(frame, there[held]) - relative(frame, here[held])
        assert np.allclose(moved_by[:, :3], (0.0, 0.005, 0.0), atol=1e-12)
        grasp = plain.stations[0].at
        assert distance_between(here[grasp], there[grasp]) < 1e-12


def test_turning_keeps_the_tool_where_it_is() -> None:
    turn = Feedback("rotate", "turn left", "grasp object", frame="block", turn_rad=(0, 0, 0.1))
    here, there = (
        adapt(plan_adaptation(learned(given)), SCENE, SHOWN).path for given in ((), (turn,))
    )
    at = lesson().stations[0].at
    assert angle_between(here[at], there[at]) == pytest.approx(0.1)
    tip = np.array([0.1341, 0.0, 0.0])
    assert np.allclose(transform_points(here[at], tip), transform_points(there[at], tip))


def test_a_correction_of_a_free_way_leaves_grasp_and_release_exact() -> None:
    plan = plan_adaptation(learned([nudge("move up object", (0.0, 0.0, 0.02))]))
    path = adapt(plan, SCENE, SHOWN)
    plain = adapt(plan_adaptation(learned()), SCENE, SHOWN)
    lift = path.path[:, 2] - plain.path[:, 2]
    assert np.max(lift) == pytest.approx(0.02, rel=1e-3)
    assert max(errors(plan, path, SHOWN)) < 1e-9


def test_speed_of_one_primitive_and_of_all() -> None:
    plain = adapt(plan_adaptation(learned()), SCENE, SHOWN)
    one = Feedback("speed", "slower", "move down", factor=0.5)
    slow = adapt(plan_adaptation(learned([one])), SCENE, SHOWN)
    inside = np.flatnonzero(plain.primitive_at == 3)[20:-20]
    before, after = (np.diff(path.t_s)[inside] for path in (plain, slow))
    assert np.allclose(after, 2.0 * before, rtol=0.01)
    assert np.allclose(np.diff(slow.t_s)[:100], np.diff(plain.t_s)[:100], rtol=0.01)
    whole = adapt(plan_adaptation(learned([replace(one, primitive="")])), SCENE, SHOWN)
    assert whole.t_s[-1] == pytest.approx(2.0 * plain.t_s[-1], rel=1e-3)


def test_a_spoken_command_to_the_hand_is_carried_out() -> None:
    opened = Feedback("hand", "open the hand", "approach object", "before", hand="open")
    closed = replace(opened, hand="close", primitive="place object", when="after")
    path = adapt(plan_adaptation(learned([opened, closed])), SCENE, SHOWN)
    assert path.gripper_m[0] == np.max(path.gripper_m)
    assert path.gripper_m[-1] == np.min(path.gripper_m)


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
