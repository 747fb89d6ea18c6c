"""Talk about a mistake is no name of a step."""

from __future__ import annotations

import pytest

from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import Lessons


def naming() -> Lessons:
    """Return a lesson that asks for the third of three steps."""
    teacher = Lessons().open().tell("tea").tell("done").tell(("block", "target"))
    return teacher.tell(3).tell("fetch it").tell("bring it")


def named(teacher: Lessons) -> list[str]:
    return [part.name for part in teacher.dialogue.known.root.parts if part.name]


@pytest.mark.parametrize(
    "text", ["wait, there's a mistake", "I forgot to say move up first", "oh I messed up"]
)
def test_a_mistake_is_helped_with(text: str) -> None:
    teacher = naming().hear(acts.Inform(text), text=text)
    assert teacher.topics[0] == "told.slip"
    assert named(teacher) == ["fetch it", "bring it"]


@pytest.mark.parametrize(
    "text", ["no that's wrong, go back", "I am sorry, I answered too quickly, please undo that."]
)
def test_a_wrong_answer_is_taken_back_and_named(text: str) -> None:
    teacher = naming().hear(acts.Inform("go back"), text=text)
    assert teacher.topics[0] == "done.undone"
    assert teacher.lines[0].slots["names"] == ["bring it"]
    assert named(teacher) == ["fetch it"]


def test_there_may_be_fewer_steps_than_were_told() -> None:
    teacher = naming().hear(acts.Inform("that's all"), text="that's all")
    assert teacher.topics[0] == "done.counted"
    assert len(teacher.dialogue.known.root.parts) == 2


def test_a_step_may_turn_out_to_be_a_single_motion() -> None:
    teacher = naming().tell("leave").tell(2)
    assert teacher.dialogue.known.root.parts[0].parts
    text = "no, just one motion"
    teacher.hear(acts.Inform("no"), text=text)
    assert teacher.dialogue.known.root.parts[0].single
    assert not teacher.dialogue.known.root.parts[0].parts


def test_all_can_be_begun_anew_after_a_question() -> None:
    teacher = naming().hear(acts.GoBack("introduction"), text="let's start over")
    assert teacher.topics == ["confirm.begin_introduction"]
    assert teacher.dialogue.known.name == "tea"
    teacher.hear(acts.Affirm(), text="yes")
    assert (teacher.asked, teacher.dialogue.known.name) == ("task_name", "")
    assert teacher.hear(acts.Undo(), text="undo").dialogue.known.name == "tea"


def test_none_is_no_thing_and_no_size() -> None:
    teacher = Lessons().open().tell("tea").tell("done").tell(("teapot", "jug"))
    teacher.tell("none")
    assert teacher.topics == ["told.assumed_body", "ask.pose"]
    teacher.hear(acts.Deny()).tell("none").hear(acts.Deny()).tell(2).tell("grab")
    assert all(thing.name != "none" for thing in teacher.dialogue.known.objects or ())


def test_it_is_the_thing_that_the_whole_step_speaks_of() -> None:
    teacher = Lessons().open().tell("tea").tell("done").tell(("block", "target"))
    teacher.tell(1).tell("take the block by its side").tell(2).tell("grab it").tell("lift it")
    leaf = teacher.dialogue.known.root.parts[0].parts[0]
    assert leaf.action is not None
    assert leaf.action.object == "block"
