"""Names and answers tell actions."""

from __future__ import annotations

import pytest

from assistant.language.actions import mentioned_objects, read_action
from assistant.model.task import Action, TaskObject, Verb

THINGS = (TaskObject("block", "object"), TaskObject("target", "target"))
STACK = (
    TaskObject("red block", "object"),
    TaskObject("green block", "object"),
    TaskObject("blue block", "target"),
)


@pytest.mark.parametrize(
    ("text", "verb", "way", "thing"),
    [
        ("approach object", "move", "approach", "block"),
        ("grasp object", "hand", "close", "block"),
        ("close the hand", "hand", "close", "block"),
        ("move up object", "move", "up", "block"),
        ("lift it", "move", "up", "block"),
        ("move object down to target", "move", "down", "target"),
        ("move down to the target", "move", "down", "target"),
        ("lower the block", "move", "down", "target"),
        ("let go of the block", "hand", "open", "target"),
        ("open the hand", "hand", "open", "target"),
        ("go to the target", "move", "to", "target"),
        ("turn the block left", "turn", "left", "block"),
        ("rotate it a bit clockwise", "turn", "clockwise", "block"),
        ("retreat", "move", "depart", "block"),
    ],
)
def test_plain_motions_are_sure(text: str, verb: Verb, way: str, thing: str) -> None:
    reading = read_action(text, THINGS)
    assert reading.action == Action(verb, way, thing)
    assert reading.sure


@pytest.mark.parametrize(
    "text", ["pick up object", "place object on target", "put it down", "take it", "wipe the table"]
)
def test_what_may_be_several_motions_is_not_sure(text: str) -> None:
    assert not read_action(text, THINGS).sure


def test_longer_names_take_their_words_away() -> None:
    things = (TaskObject("block", "object"), TaskObject("blue block", "target"))
    assert mentioned_objects("the blue block", things) == ("blue block",)


def test_the_place_something_goes_to_is_the_one_concerned() -> None:
    down = read_action("move red block down to blue block", STACK).action
    assert down == Action("move", "down", "blue block")
    place = read_action("place green block on red block", STACK).action
    assert place == Action("hand", "open", "red block")


@pytest.mark.parametrize(
    ("text", "verb", "way", "sure"),
    [
        ("senk ihn zum Ziel ab", "move", "down", True),
        ("heb ihn an", "move", "up", True),
        ("heb den Block hoch", "move", "up", True),
        ("heb ihn auf", "hand", "close", False),
        ("leg ihn auf das Ziel", "hand", "open", False),
        ("stell ihn hin", "hand", "open", False),
        ("setz ihn auf das Ziel", "hand", "open", False),
    ],
)
def test_what_is_told_to_a_friend_in_german_names_its_motion(
    text: str, verb: Verb, way: str, sure: bool
) -> None:
    reading = read_action(text, (), "german")
    assert reading.action == Action(verb, way, None)
    assert reading.sure == sure


def test_a_thing_is_meant_by_what_it_is_where_no_other_is_such() -> None:
    cup, box = TaskObject("red cup", "object"), TaskObject("blue box", "target")
    assert mentioned_objects("move the box 5 cm farther away", (cup, box)) == ("blue box",)
    assert mentioned_objects("the cup goes on the box", (cup, box)) == ("red cup", "blue box")
    # Of two boxes neither is just the box.
    other = TaskObject("red box", "object")
    assert mentioned_objects("move the box", (other, box)) == ()
    assert mentioned_objects("move the blue one", (other, box)) == ("blue box",)


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("carry it over", "saucer"),
        ("carry the cup", "saucer"),
        ("go to the cup", "cup"),
        ("move to it", "cup"),
        ("go down to it", "cup"),
    ],
)
def test_what_is_carried_goes_where_things_are_put(text: str, where: str) -> None:
    things = (TaskObject("cup", "object"), TaskObject("saucer", "target"))
    action = read_action(text, things).action
    assert action is not None
    assert action.object == where
