"""What a step does is told anew by its name or number, in either language."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue.sketch import at
from tests.dialogue.teaching import Lessons, said

STEPS = ("take it", "carry it over", "put it there", "let go")


def planned(language: str = "english") -> Lessons:
    """Return a lesson whose plan of four steps is read back."""
    teacher = Lessons().open().tell("tidy").tell("the block is on the target")
    teacher.tell(("block", "target")).tell(STEPS)
    while teacher.asked != "confirm_tree":
        teacher.tell("move down" if teacher.asked == "actions" else 0)
    known = replace(teacher.dialogue.known, language=language)
    teacher.dialogue = replace(teacher.dialogue, known=known)
    return teacher


@pytest.mark.parametrize(
    ("language", "text", "verb", "way"),
    [
        ("english", "No, in step 3 the hand goes up.", "move", "up"),
        (
            "english",
            "Not quite, in step 3 the hand should go up until the block is free, "
            "and it only opens in step 4.",
            "move",
            "up",
        ),
        ("english", "put it there: close the hand", "hand", "close"),
        ("german", "nein, in Schritt 3 soll die Hand nach oben gehen", "move", "up"),
        ("german", "Schritt 3: Hand schließen", "hand", "close"),
    ],
)
def test_a_step_does_what_is_told_of_it(language: str, text: str, verb: str, way: str) -> None:
    teacher = planned(language)
    said(teacher, text)
    action = at(teacher.dialogue.known.root, (3,)).action
    assert action is not None
    assert (action.verb, action.way) == (verb, way)
    assert teacher.topics[-1] == "confirm.tree"


@pytest.mark.parametrize(
    "text",
    [
        "step 3 should be optional",
        "step 3 should come before step 2",
        "in step 3 the hand should not close",
        "step 3 is called close the hand",
        "in step 3 you take it and carry it over?",
    ],
)
def test_what_else_is_said_of_a_step_changes_no_motion(text: str) -> None:
    teacher = planned()
    before = [part.action for part in teacher.dialogue.known.root.parts]
    said(teacher, text)
    assert sorted(map(str, (part.action for part in teacher.dialogue.known.root.parts))) == sorted(
        map(str, before)
    )


@pytest.mark.parametrize(
    ("text", "way"),
    [
        ("None, it just goes down gently until it touches the target.", "down"),
        ("none. it lifts the block", "up"),
    ],
)
def test_a_step_of_no_parts_does_what_is_told_with_that(text: str, way: str) -> None:
    teacher = Lessons().open().tell("tidy").tell("the block is on the target")
    teacher.tell(("block", "target")).tell(("bring it about", "carry it over"))
    assert teacher.asked == "subtask_count"
    said(teacher, text)
    action = at(teacher.dialogue.known.root, (1,)).action
    assert action is not None
    assert (action.verb, action.way) == ("move", way)
    assert not at(teacher.dialogue.known.root, (1,)).parts


@pytest.mark.parametrize(
    ("text", "way"),
    [("open the hand at the target", "open"), ("none, it goes down", "down"), ("lift it", "up")],
)
def test_a_motion_told_where_parts_are_counted_is_the_only_one(text: str, way: str) -> None:
    teacher = said(counting(), text)
    assert at(teacher.dialogue.known.root, (1,)).single
    action = at(teacher.dialogue.known.root, (1,)).action
    assert action is not None
    assert action.way == way


@pytest.mark.parametrize("text", ["two: open the hand, go up", "go back", "lift it and tip it"])
def test_several_motions_and_other_wishes_are_not_one(text: str) -> None:
    assert not at(said(counting(), text).dialogue.known.root, (1,)).single


def counting() -> Lessons:
    """Return a lesson in which it is asked how many parts the first step has."""
    teacher = Lessons().open().tell("tidy").tell("the block is on the target")
    return teacher.tell(("block", "target")).tell(STEPS)
