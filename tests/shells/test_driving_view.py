from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from assistant.files.finding import find_setups
from assistant.files.scenes import find_scene
from assistant.language.hints import page
from assistant.model.scene import Scene
from assistant.ports import ArmLook
from assistant.shells.driving_view import Gap, Overhead, gap_line, gaps, key_for, marks
from sim.kinematic_arm import KinematicArm

WORDS = page("terminal")["driving"]


@pytest.fixture(scope="module")
def table() -> tuple[ArmLook, Scene]:
    setups, path = find_setups("demonstration", Path())
    scene = find_scene(setups[0].scene, path)
    arm = KinematicArm()
    arm.arrange(scene, setups[0])
    return arm.look(), scene


def test_the_way_is_told_in_words_and_keys(table: tuple[ArmLook, Scene]) -> None:
    look, scene = table
    block, target = gaps(look, scene)
    told = gap_line(block, WORDS, facing=False, holding=False)
    assert told.startswith("to the block   15")
    assert "forward (w)" in told
    assert "left (a)" in told
    assert "down (f)" in told
    assert "turn left 35 degrees (q)" in gap_line(target, WORDS, facing=False, holding=False)


def test_facing_the_robot_its_left_is_my_right(table: tuple[ArmLook, Scene]) -> None:
    block = gaps(*table)[0]
    told = gap_line(block, WORDS, facing=True, holding=False)
    assert "right (d)" in told
    assert "back (s)" in told
    assert "down (f)" in told
    assert key_for("d", facing=True) == "a"
    assert key_for("r", facing=True) == "r"


def test_going_the_way_told_leads_there(table: tuple[ArmLook, Scene]) -> None:
    look, scene = table
    goal = look.hand.copy()
    goal[:3] += gaps(look, scene)[0].xyz_mm / 1000.0
    there = gaps(replace(look, hand=goal), scene)[0]
    assert there.there
    assert "c closes the hand" in gap_line(there, WORDS, facing=False, holding=False)
    assert "o opens the hand" in gap_line(there, WORDS, facing=False, holding=True)
    held = gaps(replace(look, held="block"), scene)[0]
    assert "in the hand" in gap_line(held, WORDS, facing=False, holding=True)


@pytest.mark.parametrize("facing", [False, True])
def test_the_view_from_above_has_the_hand_and_every_place(
    table: tuple[ArmLook, Scene], facing: bool
) -> None:
    look, scene = table
    near = gaps(look, scene)
    lines = Overhead.around(look, near, facing=facing).drawn(look, near)
    at = {
        mark: (row, line.index(mark))
        for row, line in enumerate(lines)
        for mark in "BT+"
        if mark in line
    }
    assert set(at) == {"B", "T", "+"}
    # The block is left of the target and farther from the robot's base than the hand.
    assert (at["B"][1] < at["T"][1]) is not facing
    assert (at["B"][0] < at["+"][0]) is not facing


def test_a_hand_off_the_view_stays_at_its_edge(table: tuple[ArmLook, Scene]) -> None:
    look, scene = table
    view = Overhead.around(look, gaps(look, scene), facing=False)
    away = look.hand.copy()
    away[:2] += 5.0
    assert any("+" in line for line in view.drawn(replace(look, hand=away), ()))


def test_every_thing_has_a_letter_of_its_own() -> None:
    told = marks(["block", "base", "b", "block b"])
    assert len(set(told.values())) == 4
    assert told["block"] == "B"


def test_a_gap_of_nothing_is_there() -> None:
    assert Gap("block", np.zeros(3), 0.0).there
    assert not Gap("block", np.zeros(3), 10.0).there
