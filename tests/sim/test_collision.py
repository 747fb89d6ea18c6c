"""Arm, hand and carried body are kept clear of what stands around."""

from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import Array, inverse, pose_from_mm_deg
from assistant.model.scene import Body, Obstacle, Scene
from sim import a465
from sim.a465 import GRIPPER
from sim.collision import FINGER_TALL_M, Touch, fixed_things, too_near, touches
from sim.kinematics import forward, inverse_all, within_limits
from sim.resting import CLEARANCE_M, carried_body
from sim.urdf import PAD_ROLL_RAD
from tests.sim.hand_paths import scene

OPEN = np.array([0.08])


def joints(x: float, y: float, z: float, yaw: float = 0.0) -> Array:
    answers = inverse_all(pose_from_mm_deg((x, y, z), (0.0, 0.0, yaw))[None])[0]
    return np.asarray(answers[within_limits(answers)][:1])


def test_ready_touches_nothing() -> None:
    assert touches(a465.READY[None], OPEN, fixed_things(scene())).free


def test_a_hand_that_sinks_into_the_table_names_it() -> None:
    touch = touches(joints(533.0, 270.0, 262.0), OPEN, fixed_things(scene()))
    assert not touch.free
    assert touch.thing == "table"


def test_a_post_in_the_forearm_is_named() -> None:
    post = Obstacle("post", (40.0, 40.0, 800.0), (250.0, 0.0, 0.0))
    touch = touches(a465.READY[None], OPEN, fixed_things(scene(post)))
    assert (touch.part, touch.thing) == ("arm", "post")


def test_a_carried_block_may_rest_on_the_table_but_not_sink_in() -> None:
    block = Body("block")
    carried = carried_body(scene(), "block", inverse(block.hand_in_body))
    things = fixed_things(scene())

    def at(z: float, *, resting: bool) -> Touch:
        q, rests = joints(533.0, 270.0, z), np.array([resting])
        return touches(q, np.array([0.04]), things, carried, resting=rests)

    assert at(300.0, resting=True).free
    assert not at(300.0, resting=False).free
    assert at(300.0 + 1000.0 * CLEARANCE_M + 1e-6, resting=False).free
    sunk = at(296.0, resting=True)
    assert (sunk.part, sunk.thing) == ("carried", "table")


def test_a_carried_block_keeps_clear_of_an_obstacle_it_could_rest_on() -> None:
    block = Body("block")
    carried = carried_body(scene(), "block", inverse(block.hand_in_body))
    ahead = float(forward(joints(533.0, 0.0, 500.0))[0, 0]) * 1000.0 + 134.1
    box = Obstacle("box", (60.0, 40.0, 60.0), (ahead, 0.0, 500.0 - 60.0 - 61.0))
    touch = touches(joints(533.0, 0.0, 500.0), np.array([0.04]), fixed_things(scene(box)), carried)
    assert (touch.part, touch.thing) == ("carried", "box")
    assert float(touch.gap[0]) == pytest.approx(0.001 - CLEARANCE_M)


def test_the_box_around_a_finger_holds_its_rolled_pad() -> None:
    long, _, tall = GRIPPER.finger_m
    assert long * np.sin(PAD_ROLL_RAD) + tall * np.cos(PAD_ROLL_RAD) <= FINGER_TALL_M


def test_what_has_no_shape_cannot_be_in_the_way() -> None:
    assert carried_body(Scene(), "ghost", np.zeros(7)) is None


def test_what_is_touched_at_the_start_is_excused_so_far() -> None:
    things = fixed_things(scene())
    low = joints(533.0, 270.0, 262.0)
    excused = too_near(low[0], 0.08, things, None)
    assert {thing for _, thing in excused} == {"table"}
    assert touches(low, OPEN, things, excused=excused).free
    lower = joints(533.0, 270.0, 258.0)
    assert not touches(lower, OPEN, things, excused=excused).free


def test_permitted_touches_do_not_count() -> None:
    things = fixed_things(scene())
    low = joints(533.0, 270.0, 262.0)
    allowed = {(part, "table"): np.array([True]) for part in ("arm", "palm", "fingers")}
    assert touches(low, OPEN, things, allowed=allowed).free
