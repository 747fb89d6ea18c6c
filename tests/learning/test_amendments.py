from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import (
    IDENTITY,
    Array,
    angle_between,
    compose,
    distance_between,
    relative,
    transform_points,
)
from assistant.learning.adaptation import AdaptationPlan, adapt, frames_in, plan_adaptation
from assistant.learning.amendments import hand_moves
from assistant.learning.measures import measured
from assistant.model.feedback import Feedback
from assistant.model.motion import HandPath
from assistant.model.setup import Setup
from tests.learning.lessons import SCENE, SHOWN, errors, learned, lesson, moved


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
        adapt(plan_adaptation(learned(spoken)), SCENE, SHOWN).path for spoken in ((), (turn,))
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


def body_after(plan: AdaptationPlan, path: HandPath, setup: Setup) -> Array:
    """Return the pose of the block's frame once it is let go, seen from the target's."""
    frames = frames_in(plan, SCENE, setup)
    grasp, release = plan.stations[0], plan.stations[1]
    held = relative(path.path[grasp.at], frames[0])
    return relative(frames[1], compose(path.path[release.at], held))


offsets = st.tuples(*(st.floats(-0.02, 0.02) for _ in range(3)))
turnings = st.tuples(*(st.floats(-0.2, 0.2) for _ in range(3)))


@given(offset=offsets, turn=turnings, seed=st.integers(0, 10_000))
@settings(max_examples=15, deadline=None)
def test_a_correction_of_the_grasp_does_not_move_where_the_body_is_put(
    offset: tuple[float, float, float], turn: tuple[float, float, float], seed: int
) -> None:
    spoken = [
        nudge("grasp object", offset, "block"),
        Feedback("rotate", "turn more", "grasp object", frame="block", turn_rad=turn),
    ]
    setup = moved(np.random.default_rng(seed))
    plain, corrected = plan_adaptation(learned()), plan_adaptation(learned(spoken))
    here, there = adapt(plain, SCENE, setup), adapt(corrected, SCENE, setup)
    assert np.allclose(body_after(plain, here, setup), body_after(corrected, there, setup))
    # The hand does grasp elsewhere, by what was told, and lets go as much elsewhere.
    told = relative(plain.stations[0].hand_in_frame, np.array(corrected.hands[0]))
    for station in plain.stations:
        apart = relative(here.path[station.at], there.path[station.at])
        assert np.allclose(apart, told, atol=1e-12)
    assert measured(learned(spoken), corrected, there, SCENE, setup)["release_error_m"] < 1e-9


@given(offset=offsets, grasp=offsets, seed=st.integers(0, 10_000))
@settings(max_examples=15, deadline=None)
def test_a_correction_of_the_release_moves_the_body_by_just_that(
    offset: tuple[float, float, float], grasp: tuple[float, float, float], seed: int
) -> None:
    spoken = [nudge("grasp object", grasp, "block"), nudge("place object", offset, "target")]
    setup = moved(np.random.default_rng(seed))
    plain, corrected = plan_adaptation(learned()), plan_adaptation(learned(spoken))
    before = body_after(plain, adapt(plain, SCENE, setup), setup)
    path = adapt(corrected, SCENE, setup)
    after = body_after(corrected, path, setup)
    assert np.allclose(after[:3] - before[:3], offset, atol=1e-12)
    assert angle_between(before, after) < 1e-7
    # What the arm is told of its stop is what the teacher said there, nothing of the grasp.
    assert np.allclose(path.stops[1].shift[:3], offset, atol=1e-15)


def test_a_body_let_go_is_no_longer_held() -> None:
    made = lesson()
    first, second = made.stations
    later = replace(second, kind="touch", object="block", at=790, docking_at=790, left_at=790)
    stations = (first, second, later)
    told = np.tile(IDENTITY, (3, 1))
    told[0, :3] = 0.0, 0.01, 0.0
    moves = hand_moves(stations, told)
    assert np.linalg.norm(moves[1, :3]) == pytest.approx(0.01)
    assert np.array_equal(moves[2], IDENTITY)


def test_a_held_body_is_led_where_it_was_shown() -> None:
    made = lesson()
    grasp, over = made.stations[0], replace(made.stations[1], kind="touch")
    told = np.tile(IDENTITY, (2, 1))
    told[0, :3] = 0.0, 0.01, 0.0
    moves = hand_moves((grasp, over), told)
    held = [relative(compose(move, grasp.hand_in_frame), IDENTITY) for move in (IDENTITY, told[0])]
    hands = [compose(move, over.hand_in_frame) for move in (IDENTITY, moves[1])]
    assert np.allclose(compose(hands[0], held[0]), compose(hands[1], held[1]), atol=1e-15)
