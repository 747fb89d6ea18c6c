"""What the hand pushes stays in touch with it, and goes where the fingertips go."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from assistant.geometry import compose, pose_from_mm_deg, relative
from assistant.model.motion import HandStop
from assistant.model.scene import Body, Scene
from sim.a465 import GRIPPER
from sim.shapes import body_box
from sim.touching import contents, in_touch, push_begin, pushed

BOX = Body("box", size_mm=(60.0, 120.0, 90.0))
REACHED = HandStop(10, "touch", "box", "box", 10, 10)
PUSHED = HandStop(40, "touch", "box", "line", 38, 50)
GRASPED = HandStop(40, "grasp", "box", "box", 30, 50)
TIPS_M = GRIPPER.palm_m[0] + GRIPPER.finger_m[0]


def test_a_box_is_touched_from_where_it_was_reached_to_the_line() -> None:
    first, last = in_touch((REACHED, PUSHED))
    assert first.left_at == PUSHED.docking_at
    assert last == PUSHED
    assert push_begin((first, last), last) == REACHED.at


def test_what_is_grasped_is_no_push() -> None:
    assert in_touch((REACHED, GRASPED)) == (REACHED, GRASPED)
    assert in_touch(()) == ()


@settings(max_examples=40)
@given(some.floats(0.0, 0.05), some.floats(-0.05, 0.2), some.floats(-180.0, 180.0))
def test_a_pushed_body_lies_against_the_fingertips(gap: float, way: float, yaw: float) -> None:
    body = pose_from_mm_deg((700.0, 100.0, 240.0), (0.0, 0.0, yaw))
    before = compose(body, np.array([-0.03 - TIPS_M - gap, 0.0, 0.05, 0.0, 0.0, 0.0, 1.0]))
    after = compose(before, np.array([way, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]))
    moved = relative(body, pushed(body, body_box(BOX, body), before, after))
    assert moved[0] == pytest.approx(max(way - gap, 0.0), abs=1e-9)
    assert np.allclose(moved[1:3], 0.0, atol=1e-9)


def test_only_balls_within_the_walls_of_a_cup_go_with_it() -> None:
    cup = Body("cup", "cup", (70.0, 70.0, 100.0))
    ball = Body("ball", "sphere", (18.0, 18.0, 18.0))
    scene = Scene(bodies={"cup": cup, "in": ball, "beside": ball, "above": ball, "block": BOX})
    places = {
        "cup": (600.0, 0.0, 240.0),
        "in": (610.0, 10.0, 246.0),
        "beside": (650.0, 0.0, 240.0),
        "above": (600.0, 0.0, 345.0),
        "block": (600.0, 0.0, 246.0),
    }
    bodies = {name: pose_from_mm_deg(xyz, (0.0, 0.0, 0.0)) for name, xyz in places.items()}
    assert contents(scene, bodies) == {"in"}
