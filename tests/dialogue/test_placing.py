"""Places told by numbers: what was measured a little too low stands on the table."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue.placing import new_place
from assistant.model import teacher_acts as acts
from assistant.model.scene import Obstacle
from tests.dialogue.teaching import Lessons

TABLE = Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0))


@pytest.mark.parametrize(
    ("told_mm", "taken_mm"), [(233.0, 240.0), (239.9, 240.0), (240.0, 240.0), (260.0, 260.0)]
)
def test_a_thing_does_not_stand_in_the_table(told_mm: float, taken_mm: float) -> None:
    known = Lessons().ready().dialogue.known
    known = replace(known, scene=replace(known.scene, tables=(TABLE,)))
    told = acts.SetPose("block", position_mm=(500.0, 100.0, told_mm))
    place = new_place(known, "block", told, f"the block's body is at 500, 100, {told_mm}")
    assert place is not None
    assert (place.kind, place.xyz_mm) == ("body", (500.0, 100.0, taken_mm))


def test_a_place_of_the_hand_and_one_beside_the_table_are_taken_as_told() -> None:
    known = Lessons().ready().dialogue.known
    known = replace(known, scene=replace(known.scene, tables=(TABLE,)))
    for words, x_mm in (("the hand is at the block", 500.0), ("the block's body is at", 950.0)):
        told = acts.SetPose("block", position_mm=(x_mm, 100.0, 233.0))
        place = new_place(known, "block", told, words)
        assert place is not None
        assert place.xyz_mm == (x_mm, 100.0, 233.0)
