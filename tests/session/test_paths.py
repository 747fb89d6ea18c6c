from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import IDENTITY, Array, angle_between, compose, distance_between
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.motion import HandPath, HandStop
from assistant.model.scene import Body, Scene
from assistant.model.task import Subtask, Task
from assistant.ports import ArmLook
from assistant.session import paths

SCENE = Scene(bodies={"block": Body("block")})
READY = np.array([0.4064, 0.0, 0.635, 0.0, 0.0, 0.0, 1.0])


def look(hand: Array, held: str = "", bodies: dict[str, Array] | None = None) -> ArmLook:
    return ArmLook(np.zeros(6), hand, 0.08, held, bodies or {}, False, 0.0)


def line_path(count: int = 201) -> HandPath:
    """A straight way of 0.4 m with the grasp of a block in its middle."""
    path = np.tile(READY, (count, 1))
    path[:, 1] = np.linspace(0.0, 0.4, count)
    middle = count // 2
    gripper = np.where(np.arange(count) < middle, 0.08, 0.0)
    primitive_at = np.where(np.arange(count) < middle, 0, 1).astype(np.int64)
    stop = HandStop(middle, "grasp", "block", "block", middle - 10, middle + 10)
    return HandPath(0.05 * np.arange(count, dtype=float), path, gripper, primitive_at, (stop,))


@settings(max_examples=25)
@given(st.floats(0.0, 0.4), st.floats(-0.02, 0.02))
def test_the_rest_begins_where_the_arm_is_and_ends_as_planned(along: float, aside: float) -> None:
    whole = line_path()
    hand = READY + np.array([aside, along, 0, 0, 0, 0, 0])
    rest = paths.rest_of(whole, look(hand), -1, SCENE)
    np.testing.assert_allclose(rest.path[0], hand)
    np.testing.assert_allclose(rest.path[-1], whole.path[-1])
    assert rest.t_s[0] == 0.0
    assert np.all(np.diff(rest.t_s) > 0)
    assert len(rest.t_s) == len(rest.path) == len(rest.gripper_m) == len(rest.primitive_at)
    assert np.max(distance_between(rest.path[1:], rest.path[:-1])) < 0.01


def test_what_was_passed_is_not_done_again() -> None:
    whole = line_path()
    before = paths.rest_of(whole, look(whole.path[60]), 0, SCENE)
    assert [stop.object for stop in before.stops] == ["block"]
    np.testing.assert_allclose(before.path[before.stops[0].at], whole.path[100])
    assert paths.rest_of(whole, look(whole.path[140], held="block"), 1, SCENE).stops == ()


def test_a_body_in_the_hand_is_not_grasped_twice() -> None:
    whole = line_path()
    rest = paths.rest_of(whole, look(whole.path[99], held="block"), -1, SCENE)
    assert rest.stops == ()


@pytest.mark.parametrize("offset", [(0.005, 0.0, 0.0), (0.0, -0.015, 0.002)])
def test_a_small_step_goes_where_it_should(offset: tuple[float, float, float]) -> None:
    step = paths.step_by(look(READY), offset, (0.0, 0.0, 0.05))
    np.testing.assert_allclose(step.path[-1][:3] - READY[:3], offset, atol=1e-12)
    assert float(angle_between(step.path[-1], READY)) == pytest.approx(0.05)
    speed = distance_between(step.path[1:], step.path[:-1]) / np.diff(step.t_s)
    assert np.max(speed) <= paths.JOG_M_S * 1.05


def test_the_hand_closes_on_what_it_stands_at() -> None:
    body = Body("block")
    scene = Scene(bodies={"block": body, "plate": Body("plate", mass_kg=0.0)})
    base = np.array([0.5, 0.1, 0.24, 0.0, 0.0, 0.0, 1.0])
    hand = compose(base, body.hand_in_body)
    at_block = look(hand, bodies={"block": base, "plate": base})
    closing = paths.hand_only(at_block, scene, "close", 0.08)
    assert (closing.stops[0].kind, closing.stops[0].object) == ("grasp", "block")
    assert closing.gripper_m[-1] == 0.0
    far = look(compose(hand, np.array([-0.2, 0, 0, *IDENTITY[3:]])), bodies={"block": base})
    assert paths.hand_only(far, scene, "close", 0.08).stops[0].object == ""


def test_opening_lets_go_of_what_is_held() -> None:
    opening = paths.hand_only(look(READY, held="block"), Scene(), "open", 0.08)
    assert (opening.stops[0].kind, opening.stops[0].object) == ("release", "block")
    assert opening.gripper_m[-1] == 0.08


def test_a_demonstration_is_carried_out_as_shown() -> None:
    whole = line_path()
    shown = Demonstration(Recording(whole.t_s + 5.0, whole.path, whole.gripper_m))
    path = paths.as_shown(Task("t", Subtask("t")), shown, 0.5)
    np.testing.assert_allclose(path.t_s, 2.0 * whole.t_s)
    np.testing.assert_allclose(path.path, whole.path)
    assert set(path.primitive_at) == {-1}
