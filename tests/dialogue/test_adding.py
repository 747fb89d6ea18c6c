"""The plan is corrected as people talk about it."""

from __future__ import annotations

import pytest

from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import Lessons


def planned() -> Lessons:
    """Return a lesson whose plan of three steps is read back."""
    teacher = Lessons().open().tell("task").tell("done").tell(("block", "target"))
    return teacher.tell(("grab the block", "lift the block", "lower it to the target"))


def steps(teacher: Lessons) -> list[str]:
    return [part.name for part in teacher.dialogue.known.root.parts]


@pytest.mark.parametrize(
    ("text", "at", "name"),
    [
        ("you forgot to let go", 3, "let go"),
        ("and then release the block", 3, "release the block"),
        ("move away comes last", 3, "move away"),
        ("no, first approach the block", 0, "approach the block"),
        ("approach the block comes first", 0, "approach the block"),
    ],
)
def test_a_step_is_added_at_an_end(text: str, at: int, name: str) -> None:
    teacher = planned().hear(acts.Affirm(), text=text, sure=0.5)
    assert teacher.topics[0] == "done.added"
    assert steps(teacher)[at] == name
    assert len(steps(teacher)) == 4


def test_a_known_step_goes_to_the_end() -> None:
    assert steps(planned().hear(acts.Cue("last"), text="lift the block comes last")) == [
        "grab the block",
        "lower it to the target",
        "lift the block",
    ]


@pytest.mark.parametrize(
    ("text", "first"),
    [
        ("swap the first two steps", ["lift the block", "grab the block"]),
        ("swap steps 1 and 2", ["lift the block", "grab the block"]),
        ("swap the last two", ["grab the block", "lower it to the target"]),
    ],
)
def test_two_steps_are_exchanged(text: str, first: list[str]) -> None:
    assert steps(planned().hear(acts.Split("swap the"), text=text, sure=0.7))[:2] == first


def test_a_step_that_is_not_there_is_not_guessed_about() -> None:
    teacher = planned().hear(acts.RemoveSubtask("step 3.1"), text="remove step 3.1", sure=0.7)
    assert teacher.topics[0] == "error.no_such_step"


def test_a_yes_with_a_word_before_it_stays_a_yes() -> None:
    for text in ("then yes", "first off that is right"):
        assert planned().hear(acts.Affirm(), text=text).asked == "ready"


@pytest.mark.parametrize("text", ["first grab the block, then lift the block"])
def test_two_known_steps_are_no_new_one(text: str) -> None:
    teacher = planned()
    teacher.hear(acts.Ordered("grab the block", "lift the block"), text=text)
    assert steps(teacher) == steps(planned())
