"""Names heard by voice are read back before they are taken; known words are not."""

from __future__ import annotations

import pytest

from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import Lessons


def heard(teacher: Lessons, value: str | tuple[str, ...]) -> Lessons:
    return teacher.hear(acts.Inform(value), text=str(value), voice=True)


def yes(teacher: Lessons) -> Lessons:
    return teacher.hear(acts.Affirm(), text="yes", voice=True)


def test_a_name_is_taken_after_a_yes() -> None:
    teacher = heard(Lessons().open(), "pick and plays")
    assert teacher.topics[-1] == "confirm.heard_names"
    assert teacher.lines[-1].slots["names"] == ["pick and plays"]
    assert not teacher.dialogue.known.name
    assert yes(teacher).dialogue.known.name == "pick and plays"
    assert teacher.asked == "goal"


def test_a_name_in_a_sentence_is_read_back_too() -> None:
    teacher = Lessons().open()
    teacher.hear(acts.Inform("pick in place"), text="it's called pick in place", voice=True)
    assert teacher.lines[-1].slots["names"] == ["pick in place"]


def test_after_a_no_it_is_asked_for_again() -> None:
    teacher = heard(Lessons().open(), "pick and plays")
    teacher.hear(acts.Deny(), text="no", voice=True)
    assert "told.say_or_spell" in teacher.topics
    assert teacher.asked == "task_name"
    assert not teacher.dialogue.known.name


def test_another_name_in_place_of_a_yes_is_read_back_too() -> None:
    teacher = heard(heard(Lessons().open(), "pick and plays"), "pick and place")
    assert teacher.lines[-1].slots["names"] == ["pick and place"]
    assert yes(teacher).dialogue.known.name == "pick and place"


def test_typed_it_is_taken_at_once() -> None:
    teacher = heard(Lessons().open(), "pick and plays").tell("pick and place")
    assert teacher.dialogue.known.name == "pick and place"
    assert teacher.asked == "goal"


@pytest.mark.parametrize(
    ("named", "doubted"), [(("block", "target"), None), (("red blog", "target"), ["red blog"])]
)
def test_only_unknown_things_are_read_back(
    named: tuple[str, ...], doubted: list[str] | None
) -> None:
    teacher = heard(Lessons().open().tell("sorting").tell("all in place"), named)
    slots = [one.slots["names"] for one in teacher.lines if one.topic == "heard_names"]
    assert slots == ([doubted] if doubted else [])


def test_a_step_the_robot_has_a_word_for_is_not_doubted() -> None:
    teacher = Lessons().open().tell("sorting").tell("all in place").tell(("block", "target"))
    heard(teacher.tell(2), "lift the block")
    assert teacher.asked == "subtask_name"
    heard(teacher, "tidy up")
    assert teacher.lines[-1].slots["names"] == ["tidy up"]
