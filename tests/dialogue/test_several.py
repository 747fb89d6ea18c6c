"""One sentence that answers several questions, or another than was asked."""

from __future__ import annotations

import pytest

from assistant.dialogue.sketch import names
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import Lessons


def steps(teacher: Lessons) -> tuple[str, ...]:
    return names(teacher.dialogue.known.root)


def test_all_of_a_sentence_is_taken_and_only_the_rest_is_asked() -> None:
    teacher = Lessons().open()
    teacher.tell("it's called tidy, the goal is that the block is away, you need block and target")
    known = teacher.dialogue.known
    assert (known.name, known.goal) == ("tidy", "the block is away")
    assert [one.name for one in known.objects or ()] == ["block", "target"]
    assert teacher.topics == ["done.goal", "done.things", "ask.subtask_count"]
    teacher.hear(acts.Undo())
    assert teacher.topics == ["done.undone", "ask.task_name"]


def test_an_answer_to_another_question_is_no_goal() -> None:
    teacher = Lessons().open().tell("tidy")
    teacher.tell("it has two steps, grasp the block and release it on the target")
    assert teacher.dialogue.known.goal is None
    assert steps(teacher) == ("grasp the block", "release it on the target")
    assert teacher.asked == "goal"
    teacher.tell("all is tidy, and you need the block and the target")
    assert teacher.asked == "confirm_tree"


def test_a_count_that_does_not_fit_its_own_list_is_noticed() -> None:
    teacher = Lessons().open().tell("tidy").tell("all is done").tell(("block", "target"))
    teacher.tell("three steps: grasp the block, lift it, lower it, release it")
    assert teacher.topics == ["ask.count_contradicted"]
    assert teacher.lines[-1].slots["said"] == 3
    teacher.hear(acts.Undo())
    teacher.tell("it has four steps: grasp the block, lift it, release it")
    assert steps(teacher) == ("grasp the block", "lift it", "release it")
    assert teacher.lines[-1].slots["which"] == 4


def test_a_list_of_another_step_is_its_own() -> None:
    teacher = Lessons().open().tell("tidy").tell("all is done").tell(("block", "target"))
    teacher.tell(("fetch the block", "release it"))
    teacher.tell("it has two parts: grasp it, lift it")
    assert steps(teacher) == ("fetch the block", "grasp it", "lift it", "release it")


def test_no_goal_is_no_goal() -> None:
    # The robot itself says that this may be said.
    assert Lessons().open().tell("tidy").tell("no goal").dialogue.known.goal == ""


def test_what_it_needs_to_do_is_no_thing() -> None:
    teacher = Lessons().open().tell("tidy").tell("it needs to be on the target")
    assert teacher.dialogue.known.goal == "it needs to be on the target"


def test_fewer_named_than_said_are_asked_for() -> None:
    teacher = Lessons().open().tell("tidy").tell("all is done").tell(("block", "target"))
    for told in ("three steps, grasp the block and release it", "3 parts: grasp it and let it go"):
        asked = Lessons(teacher.dialogue).tell(told)
        assert len(steps(asked)) == 2
        assert asked.lines[-1].slots["which"] == 3


@pytest.mark.parametrize(
    ("text", "steps"),
    [
        ("two steps, grab the sponge and wipe the board", ["grab the sponge", "wipe the board"]),
        ("3 steps: grab it, polish it and leave it", ["grab it", "polish it", "leave it"]),
        ("two steps, I think", ["", ""]),
    ],
)
def test_a_list_as_long_as_was_said_needs_no_known_verbs(text: str, steps: list[str]) -> None:
    teacher = Lessons().open().tell("task").tell("done so").tell(("block", "target"))
    teacher.hear(acts.Inform(len(steps)), text=text)
    assert [part.name for part in teacher.dialogue.known.root.parts] == steps
