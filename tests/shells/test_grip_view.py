"""What a closed hand holds is told as soon as it can be known, and what it missed, too."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.dialogue.bodies import ASSUMED_MM
from assistant.dialogue.knowledge import Knowledge
from assistant.geometry import compose, inverse
from assistant.language.hints import page
from assistant.model.scene import Body, Obstacle, Scene
from assistant.model.task import TaskObject
from assistant.ports import ArmLook, HandSample
from assistant.shells.grip_view import Closings, Missed, left_over, missed_line, taken, width_mm
from sim.driving import TIP

WORDS = page("terminal")["driving"]
TABLE = Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0))
THINGS = (TaskObject("tea box", "object"), TaskObject("coaster", "target"))


def closed(tip_mm: tuple[float, float, float], gripper_m: float = 0.0) -> ArmLook:
    q = np.deg2rad([0.0, 0.0, 90.0, 0.0, 0.0, 0.0])
    tip = np.array([*(one / 1000.0 for one in tip_mm), 0.0, np.sqrt(0.5), 0.0, np.sqrt(0.5)])
    return ArmLook(q, compose(tip, inverse(TIP)), gripper_m, "", {}, False, 0.0)


def known(*sizes: tuple[str, tuple[float, float, float]]) -> Knowledge:
    bodies = {name: Body(name, size_mm=size) for name, size in sizes}
    return Knowledge(objects=THINGS, scene=Scene(bodies=bodies, tables=(TABLE,)))


SMALL = known(("tea box", (40.0, 30.0, 40.0)))


@pytest.mark.parametrize(("height_mm", "held"), [(20, True), (51, True), (53, False), (120, False)])
def test_on_an_empty_table_a_thing_is_held_where_it_can_stand(height_mm: int, held: bool) -> None:
    found = taken(SMALL, closed((450.0, 0.0, 240.0 + height_mm)), SMALL.scene, TIP)
    if held:
        assert found == "tea box"
        return
    assert isinstance(found, Missed)
    assert found.below == pytest.approx(height_mm - 40.0)
    told = missed_line(found, WORDS, "english")
    assert "only 40 mm high" in told
    assert f"{height_mm - 40} mm below" in told
    assert "u takes that back" in told


@pytest.mark.parametrize("one", [known(), known(("tea box", ASSUMED_MM))])
def test_of_a_size_nobody_knows_nothing_is_doubted(one: Knowledge) -> None:
    assert taken(one, closed((450.0, 0.0, 500.0)), SMALL.scene, TIP) == "tea box"


def test_an_open_hand_holds_nothing_and_a_full_one_what_it_holds() -> None:
    look = closed((450.0, 0.0, 500.0))
    assert taken(SMALL, replace(look, gripper_m=0.08), SMALL.scene, TIP) == ""
    assert (
        taken(SMALL, replace(look, held="tea box", gripper_m=0.03), SMALL.scene, TIP) == "tea box"
    )
    assert width_mm(SMALL, "tea box") == 30.0
    assert width_mm(SMALL, "coaster") is None


@pytest.mark.parametrize("tip_mm", [(450.0, 0.0, 300.0), (500.0, 0.0, 260.0)])
def test_what_stands_somewhere_is_told_to_be_below_or_beside(tip_mm: tuple[float, ...]) -> None:
    base = np.array([0.45, 0.0, 0.24, 0.0, 0.0, 0.0, 1.0])
    x, y, z = tip_mm
    look = replace(closed((x, y, z)), bodies={"tea box": base})
    found = taken(SMALL, look, SMALL.scene, TIP)
    assert isinstance(found, Missed)
    told = missed_line(found, WORDS, "english")
    assert ("20 mm below" in told) is (z == 300.0)
    assert ("30 mm beside" in told) is (x == 500.0)


def test_what_a_showing_leaves_open_is_told_at_its_end() -> None:
    assert "still in my hand" in left_over("tea box", SMALL, WORDS, "english")
    assert left_over("", SMALL, WORDS, "english") == ""
    lifting = replace(SMALL, objects=THINGS[:1])
    assert left_over("tea box", lifting, WORDS, "english") == ""
    assert "Nothing is between" in left_over(Missed("tea box", 5, 0, 40), SMALL, WORDS, "english")


def test_the_words_are_there_in_german() -> None:
    words = page("terminal", "german")["driving"]
    assert "u nimmt" in missed_line(Missed("tea box", 5, 9), words, "german")
    assert "noch in meiner Hand" in left_over("tea box", SMALL, words, "german")


def test_what_the_hand_closed_on_goes_with_it_and_a_closing_taken_back_never_was() -> None:
    closings = Closings()
    low, high = closed((450.0, 0.0, 260.0)), closed((450.0, 0.0, 400.0))
    lifted = replace(high, gripper_m=0.08)
    closings.see(replace(low, gripper_m=0.08), [], returning=False)
    assert closings.first is None
    for look in (low, high):
        closings.see(look, [], returning=False)
        assert closings.last is low.hand
        assert closings.first is low.hand
    closings.see(lifted, [], returning=False)
    assert closings.last is None
    assert closings.first is low.hand
    shown = [HandSample(0.0, high.hand, 0.08), HandSample(0.1, low.hand, 0.0)]
    for samples, first in ((shown, low.hand), (shown[:1], None)):
        closings.see(lifted, shown, returning=True)
        closings.see(lifted, samples, returning=False)
        assert closings.first is first
