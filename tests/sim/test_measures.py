"""What tells success where corners and edges do not."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from assistant.geometry import IDENTITY, pose_from_mm_deg
from assistant.model.scene import Body
from sim.bullet_bodies import holed
from sim.measures import covered, depth, edge, inside

SOCKET = Body("socket", size_mm=(80.0, 70.0, 60.0), hole_mm=(30.0, 20.0, 50.0), mass_kg=0.0)


@pytest.mark.parametrize(
    ("height_mm", "beside_mm", "good"),
    [(10.0, 0.0, True), (10.9, 0.1, True), (12.0, 0.0, False), (10.0, 16.0, False)],
)
def test_an_object_is_in_a_hole_at_its_bottom(
    height_mm: float, beside_mm: float, good: bool
) -> None:
    base = np.array(IDENTITY)
    base[:3] = beside_mm / 1000.0, 0.0, height_mm / 1000.0
    found = depth("peg", SOCKET, base)
    assert found.good is good
    assert found.value == pytest.approx(60.0 - height_mm)


@settings(max_examples=60)
@given(some.tuples(*[some.floats(-0.5, 0.5)] * 3))
def test_boxes_around_a_hole_fill_all_but_the_hole(share: tuple[float, float, float]) -> None:
    point = np.array(share) * np.array(SOCKET.size_mm) / 1000.0
    halves, middles = holed(SOCKET)
    filled = any(
        bool(np.all(np.abs(point - middle) <= np.array(half) + 1e-9))
        for half, middle in zip(halves, middles, strict=True)
    )
    up = point[2] > -0.030 + 0.010 + 1e-9
    beside = np.abs(point[:2]) < np.array([0.015, 0.010]) - 1e-9
    assert filled != bool(up and np.all(beside))


@pytest.mark.parametrize(
    ("xyz_mm", "yaw_deg", "off_mm"),
    [
        ((-30.0, 100.0, 0.0), 0.0, 0.0),
        ((30.0, 0.0, 0.0), 0.0, 0.0),
        ((-32.0, 0.0, 0.0), 0.0, 2.0),
        ((-60.0, 50.0, 0.0), 90.0, 0.0),
    ],
)
def test_the_nearest_edge_counts_at_a_line(
    xyz_mm: tuple[float, float, float], yaw_deg: float, off_mm: float
) -> None:
    box, line = Body("box", size_mm=(60.0, 120.0, 90.0)), Body("line", size_mm=(4.0, 400.0, 0.0))
    found = edge(box, line, pose_from_mm_deg(xyz_mm, (0.0, 0.0, yaw_deg)))
    assert found.value == pytest.approx(off_mm, abs=1e-9)
    assert found.good


def test_a_box_that_is_skew_is_not_at_the_line() -> None:
    box, line = Body("box", size_mm=(60.0, 120.0, 90.0)), Body("line", size_mm=(4.0, 400.0, 0.0))
    assert not edge(box, line, pose_from_mm_deg((-30.0, 0.0, 0.0), (0.0, 0.0, 5.0))).good


@pytest.mark.parametrize(
    ("width_mm", "height_mm", "percent"),
    [(100.0, 0.0, 100.0), (50.0, 0.0, 50.0), (100.0, 5.0, 0.0)],
)
def test_a_mark_is_covered_where_the_base_was_close(
    width_mm: float, height_mm: float, percent: float
) -> None:
    board, sponge = (
        Body("board", size_mm=(40.0, 200.0, 0.0)),
        Body("sponge", size_mm=(40.0, 40.0, 90.0)),
    )
    way = [
        pose_from_mm_deg((0.0, y, height_mm), (0.0, 0.0, 0.0)) for y in np.linspace(-80.0, 80.0, 33)
    ]
    kept = [pose for pose in way if pose[1] <= -0.08 + (2.0 * width_mm - 40.0) / 1000.0 + 1e-9]
    found = covered(sponge, board, np.array(kept))
    assert found.value == pytest.approx(percent, abs=2.5)
    assert found.good is (percent == 100.0)


def test_balls_in_the_bowl_are_counted() -> None:
    bowl = Body("bowl", "cup", (190.0, 190.0, 85.0))
    at = pose_from_mm_deg((600.0, 0.0, 240.0), (0.0, 0.0, 0.0))
    near, far = ((620.0, 50.0, 244.0), (720.0, 0.0, 240.0))
    balls = {
        str(k): pose_from_mm_deg(xyz, (0.0, 0.0, 0.0))
        for k, xyz in enumerate((near, near, far, near))
    }
    found = inside("cup", bowl, at, balls)
    assert found.value == 75.0
    assert not found.good
