"""Where things belong, and how well they lie there: corners, edges, surfaces."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.geometry import angle_between, compose, inverse, pose_from_mm_deg
from assistant.model.motion import HandStop
from assistant.model.placing import alignment, alignments, in_line, place_of, place_on, rests_on
from assistant.model.scene import Body, Scene
from assistant.model.setup import Place, Setup

BLOCK = Body("block")
PLACE = pose_from_mm_deg((500, 100, 240), (0, 0, 30))
small = st.floats(-3.0, 3.0)


@given(small, small)
def test_a_shifted_block_is_off_by_its_shift(x_mm: float, y_mm: float) -> None:
    pose = compose(PLACE, pose_from_mm_deg((x_mm, y_mm, 0), (0, 0, 0)))
    found = alignment(BLOCK, pose, PLACE, "target")
    assert found.distance_mm == pytest.approx(np.hypot(x_mm, y_mm), abs=1e-9)
    assert in_line(BLOCK, pose, PLACE, "target") == (found.distance_mm <= 1.0)
    assert found.angle_deg == pytest.approx(0.0, abs=1e-6)


@given(small)
def test_a_turned_block_is_off_by_its_corner(deg: float) -> None:
    pose = compose(PLACE, pose_from_mm_deg((0, 0, 0), (0, 0, deg)))
    found = alignment(BLOCK, pose, PLACE, "target")
    assert found.angle_deg == pytest.approx(abs(deg), abs=1e-6)
    chord = 2 * np.hypot(30, 20) * np.sin(np.deg2rad(abs(deg)) / 2)
    assert found.distance_mm == pytest.approx(chord, abs=1e-9)


def test_the_place_on_a_movable_body_is_its_top_wherever_it_is() -> None:
    lower = Body("lower", size_mm=(80, 60, 70))
    scene = Scene(bodies={"block": BLOCK, "lower": lower})
    setup = Setup(places={"lower": Place("body", (0, 0, 240))})
    place = place_on(scene, setup, "block", "lower", {"lower": PLACE})
    assert np.allclose(place[:3], PLACE[:3] + np.array([0, 0, 0.07]))
    assert rests_on(scene, "block", "lower", place, place)
    tilted = compose(place, pose_from_mm_deg((0, 0, 0), (10, 0, 0)))
    assert not rests_on(scene, "block", "lower", tilted, place)


@pytest.mark.parametrize("target", ["lower", "mark"])
def test_a_corrected_place_moves_along_its_surface(target: str) -> None:
    lower = Body("lower", size_mm=(80, 60, 70))
    mark = Body("mark", size_mm=(80, 60, 0), mass_kg=0.0)
    scene = Scene(bodies={"block": BLOCK, "lower": lower, "mark": mark})
    setup = Setup(places={target: Place("body", (500, 100, 240), (0, 0, 30))})
    shift = pose_from_mm_deg((0, 5, 2), (0, 0, 3))
    stop = HandStop(5, "release", "block", target, 0, 9)
    bodies = {target: PLACE}
    told = place_of(scene, setup, stop, bodies)
    assert np.allclose(told, place_on(scene, setup, "block", target, bodies))
    place = place_of(scene, setup, replace(stop, shift=tuple(shift.tolist())), bodies)
    assert place[2] == pytest.approx(told[2])
    assert np.rad2deg(float(angle_between(place, told))) == pytest.approx(3.0)
    # The frame is the hand's: 134.1 mm behind the middle of the block, and turned with it.
    by = compose(inverse(told), place)[:2] * 1000.0
    turn = np.deg2rad(3.0)
    assert np.allclose(by, 134.1 * np.array([np.cos(turn) - 1, np.sin(turn)]) + [0, 5], atol=1e-6)


def test_alignment_tells_where_a_body_lies_seen_from_its_told_place() -> None:
    mark = Body("mark", size_mm=(60, 40, 0), mass_kg=0.0)
    scene = Scene(bodies={"block": BLOCK, "mark": mark})
    setup = Setup(places={"mark": Place("body", (500, 100, 240), (0, 0, 30))})
    shift = pose_from_mm_deg((0, 5, 0), (0, 0, 0))
    stop = HandStop(5, "release", "block", "mark", 0, 9, tuple(shift.tolist()))
    told = place_on(scene, setup, "block", "mark", {})
    pose = compose(told, shift)
    (found,) = alignments(scene, setup, [stop], {"block": pose})
    # In line with where the teacher wants it, and 5 mm to the left of the mark's own axes.
    assert found.distance_mm == pytest.approx(0.0, abs=1e-9)
    assert (found.x_mm, found.y_mm) == pytest.approx(tuple(1000.0 * (pose - told)[:2]), abs=1e-9)
    assert np.hypot(found.x_mm, found.y_mm) == pytest.approx(5.0)


@given(deg=st.floats(-180.0, 180.0), shape=st.sampled_from(["cylinder", "cup"]))
def test_how_a_round_body_is_turned_about_its_axis_does_not_count(deg: float, shape: str) -> None:
    bowl = Body("bowl", "cup" if shape == "cup" else "cylinder", (60.0, 60.0, 70.0))
    pose = compose(PLACE, pose_from_mm_deg((0.6, -0.2, 0), (0, 0, deg)))
    found = alignment(bowl, pose, PLACE, "target")
    assert found.distance_mm == pytest.approx(np.hypot(0.6, 0.2), abs=1e-9)
    assert found.angle_deg == pytest.approx(0.0, abs=1e-6)
    assert in_line(bowl, pose, PLACE, "target")
    leaning = compose(pose, pose_from_mm_deg((0, 0, 0), (0, 3, 0)))
    assert alignment(bowl, leaning, PLACE, "target").angle_deg == pytest.approx(3.0, abs=1e-6)
    # What is oval, or has edges, shows how it is turned.
    oval = replace(bowl, size_mm=(60.0, 50.0, 70.0))
    assert alignment(oval, pose, PLACE, "target").angle_deg == pytest.approx(abs(deg), abs=1e-6)


@given(st.floats(-180.0, 180.0), st.floats(-180.0, 180.0), st.floats(-180.0, 180.0))
def test_a_ball_is_where_its_middle_is_however_it_has_rolled(a: float, b: float, c: float) -> None:
    ball = Body("ball", "sphere", (40.0, 40.0, 40.0))
    middle = compose(PLACE, pose_from_mm_deg((0, 0, 20), (a, b, c)))
    pose = compose(middle, pose_from_mm_deg((0, 0, -20), (0, 0, 0)))
    found = alignment(ball, pose, PLACE, "target")
    assert found.distance_mm == pytest.approx(0.0, abs=1e-6)
    assert found.angle_deg == pytest.approx(0.0, abs=1e-5)
    scene = Scene(bodies={"ball": ball, "mark": Body("mark", size_mm=(80.0, 60.0, 0.0))})
    assert rests_on(scene, "ball", "mark", pose, PLACE)
