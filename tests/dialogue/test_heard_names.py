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


def asked_for_steps() -> Lessons:
    return Lessons().open().tell("sorting").tell("all in place").tell(("block", "target"))


def test_a_number_not_heard_surely_is_read_back() -> None:
    teacher = asked_for_steps().hear(acts.Inform(10), text="ten", sure=0.6, voice=True)
    assert teacher.lines[-1].slots["names"] == ["ten"]
    teacher.hear(acts.Deny(), text="no", voice=True)
    assert teacher.asked == "subtask_count"
    teacher.hear(acts.Inform(2), text="two", sure=0.6, voice=True)
    assert yes(teacher).asked == "subtask_name"
    assert len(teacher.dialogue.known.root.parts) == 2


def test_a_number_heard_surely_or_typed_is_taken() -> None:
    for voice, sure in ((True, 1.0), (False, 0.6)):
        teacher = asked_for_steps().hear(acts.Inform(2), text="two", sure=sure, voice=voice)
        assert teacher.asked == "subtask_name"


def test_one_is_read_back_for_it_sounds_like_none() -> None:
    teacher = asked_for_steps().hear(acts.Inform(1), text="one", voice=True)
    assert teacher.lines[-1].slots["names"] == ["one"]


@pytest.mark.parametrize("act", [acts.Inform("move up"), acts.Translate("up")])
def test_a_step_not_heard_surely_is_read_back_as_it_was_heard(act: acts.TeacherAct) -> None:
    teacher = asked_for_steps().tell(2).hear(act, text="move up", sure=0.6, voice=True)
    assert teacher.lines[-1].slots["names"] == ["move up"]
    assert yes(teacher).dialogue.known.root.parts[0].name == "move up"


def test_steps_told_in_one_breath_are_read_back_if_not_heard_surely() -> None:
    steps = "first grasp the block, then lift the block"
    teacher = asked_for_steps().hear(acts.AddSubtask(steps), text=steps, sure=0.6, voice=True)
    assert teacher.topics[-1] == "confirm.heard_names"
    assert len(teacher.lines[-1].slots["names"]) == 2
    assert not teacher.dialogue.known.root.parts


def test_a_renamed_step_must_have_been_heard_well() -> None:
    rename = acts.Rename("grasp object", "hold object")
    for sure, topic in ((0.6, "confirm.did_you_mean"), (1.0, None)):
        teacher = Lessons().introduce()
        teacher.hear(rename, text="call grasp object hold object", sure=sure, voice=True)
        assert (topic is None) or topic in teacher.topics
        assert ("hold object" in str(teacher.dialogue.known.root)) == (topic is None)


@pytest.mark.parametrize(
    ("name", "plain"),
    [
        ("approach object", True),
        ("move up", True),
        ("approach and project", False),
        ("grasp a cheque", False),
    ],
)
def test_a_step_of_words_the_robot_does_not_know_is_read_back(name: str, plain: bool) -> None:
    teacher = heard(asked_for_steps().tell(2), name)
    assert (teacher.asked == "subtask_name") == plain
