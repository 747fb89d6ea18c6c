"""Places told by another thing, or as nearer to the robot."""

from __future__ import annotations

import pytest

from assistant.language.relations import relation
from assistant.model.task import TaskObject

THINGS = (TaskObject("block", "object"), TaskObject("target", "target"))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("the block is to the left of the target", ("block", "left", "target", None, "is")),
        ("put the block 10 cm right of the target", ("block", "right", "target", 100.0, "put")),
        ("the target stands in front of the block", ("target", "front", "block", None, "is")),
        ("set it half a metre behind the target", ("", "behind", "target", 500.0, "put")),
        ("next to the block", ("", "beside", "block", None, "")),
        ("move it 3 cm further away from you", ("", "farther", "", 30.0, "put")),
        ("the block is two inches closer to you", ("block", "closer", "", 50.8, "is")),
        ("can you put the block beside the target?", ("block", "beside", "target", None, "put")),
    ],
)
def test_a_relation_is_read(text: str, told: tuple[str, str, str, float | None, str]) -> None:
    found = relation(text, THINGS)
    assert found is not None
    assert (found.thing, found.side, found.other, found.posture) == (*told[:3], told[4])
    assert found.distance_mm == pytest.approx(told[3])


@pytest.mark.parametrize(
    "text",
    [
        "is the block left of the target?",
        "where is the block, left of the target",
        "the block should be left of the target",
        "the block is too close to the target",
        "the block is not next to the target",
        "the hand is left of the target",
        "when you place it, the block goes next to the target",
        "the block is left of the block",
        "the block and the target are next to each other",
        "move closer to the block",
        "more left",
        "put the block on the target",
    ],
)
def test_what_tells_no_place_by_another_thing_is_left_alone(text: str) -> None:
    found = relation(text, THINGS)
    # What names no thing that stands there is known by nobody but who spoke of one before.
    assert found is None or (not found.thing and found.posture != "is")


def test_german_tells_them_too() -> None:
    found = relation("stell den block 10 cm links neben das target", THINGS, "german")
    assert found is not None
    assert (found.thing, found.side, found.other) == ("block", "left", "target")
    assert found.distance_mm == pytest.approx(100.0)
