"""Pictures of characters: to scale, right way round, and moves that mean what they look like."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.model.scene import Scene
from assistant.ports import ArmLook
from assistant.shells.driving_picture import Sight, around_mm, drawn, marks, seen_mm, sights
from sim.driving import TIP


def both(look: ArmLook, scene: Scene, *, facing: bool = False) -> tuple[Sight, Sight]:
    poses = [look.hand, *look.bodies.values()]
    return sights(seen_mm(look, poses, scene), 12, 24, facing=facing)


def places(lines: tuple[str, ...], mark: str) -> np.ndarray:
    """Return rows and columns where a mark is."""
    found = [
        (row, column)
        for row, line in enumerate(lines)
        for column, one in enumerate(line[::2])
        if one == mark
    ]
    return np.array(found, dtype=float).reshape(-1, 2)


@pytest.mark.parametrize("facing", [False, True])
def test_from_above_left_is_the_teachers_left(table: tuple[ArmLook, Scene], facing: bool) -> None:
    look, scene = table
    lines = drawn(both(look, scene, facing=facing)[0], look, scene, TIP)
    block, target, hand = (places(lines, mark).mean(axis=0) for mark in "BT+")
    # The block is left of the target and farther from the robot's base than the hand.
    assert (block[1] < target[1]) is not facing
    assert (block[0] < hand[0]) is not facing
    assert len(places(lines, "+")) == 1


def test_from_the_side_the_hand_is_above_the_block_on_the_table(
    table: tuple[ArmLook, Scene],
) -> None:
    look, scene = table
    lines = drawn(both(look, scene)[1], look, scene, TIP)
    assert places(lines, "+")[:, 0].max() < places(lines, "B")[:, 0].min()
    assert places(lines, "B")[:, 0].max() <= places(lines, "_")[:, 0].min()


def test_a_closed_or_full_hand_is_drawn_closed(table: tuple[ArmLook, Scene]) -> None:
    look, scene = table
    above = both(look, scene)[0]
    shut = drawn(above, replace(look, gripper_m=0.0), scene, TIP)
    full = drawn(above, replace(look, gripper_m=0.04, held="block"), scene, TIP)
    assert len(places(shut, "*")) == len(places(full, "*")) == 1
    assert not len(places(shut, "+"))


@pytest.mark.parametrize("facing", [False, True])
@pytest.mark.parametrize("up", [0, 2])
def test_a_move_of_some_cells_is_seen_as_such(facing: bool, up: int) -> None:
    sight = Sight(up, (-300.0, 100.0), 20.0, 12, 24, facing)
    begin = np.array([[220.0, -60.0, 220.0]])
    moved = begin + 1000.0 * np.array(sight.move_m(2, -3))
    ((row, column),) = sight.cells(begin)
    assert sight.cells(moved) == [(row + 2, column - 3)]


def test_what_is_beyond_the_picture_stays_at_its_edge(table: tuple[ArmLook, Scene]) -> None:
    look, scene = table
    away = look.hand.copy()
    away[:2] += 5.0
    for sight in both(look, scene):
        assert any("+" in line for line in drawn(sight, replace(look, hand=away), scene, TIP))


def test_every_thing_has_a_letter_of_its_own() -> None:
    told = marks(["block", "base", "b", "block b"])
    assert len(set(told.values())) == 4
    assert told["block"] == "B"


def test_where_nothing_is_placed_the_table_is_seen_far_below_and_to_both_sides() -> None:
    tip = np.array([0.5, 0.0, 0.6, 0.0, 0.0, 0.0, 1.0])
    low, high = around_mm(tip, 360.0)
    assert (low[2], high[2]) == pytest.approx((240.0, 600.0))
    assert low[1] < 0.0 < high[1]
    assert around_mm(tip, None)[0][2] == pytest.approx(600.0)


def test_letters_are_those_of_the_names_the_robot_says() -> None:
    assert marks(("block", "target")) == {"block": "B", "target": "T"}
    assert marks(("block", "target"), "german") == {"block": "B", "target": "Z"}
