"""The plan changed in words that mean it whatever is asked."""

from __future__ import annotations

import pytest

from assistant.dialogue.machine import begin
from assistant.dialogue.sketch import at, names
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import STEPS, Lessons, lesson, tree_task


def counting() -> Lessons:
    """Return a lesson in which the parts of the second step are asked for."""
    teacher = Lessons().open().tell("task").tell("done").tell(("block", "target"))
    return teacher.tell(("fetch", "serve")).tell(("grasp the block", "lift it"))


def test_a_step_is_called_by_its_number_whatever_is_asked() -> None:
    teacher = counting()
    assert teacher.asked == "subtask_count"
    teacher.tell("the second step is called hand over")
    assert names(teacher.dialogue.known.root)[-1] == "hand over"
    teacher.tell("no, step 1.2 should be called raise it")
    assert names(teacher.dialogue.known.root)[2] == "raise it"
    assert teacher.asked == "subtask_count"


def test_a_number_that_no_step_has_is_told() -> None:
    teacher = counting().hear(acts.Optional("grasp the block"), text="step 2.1 is optional")
    assert teacher.topics[0] == "error.no_such_step"
    assert teacher.lines[0].slots["name"] == "step 2.1"
    assert not at(teacher.dialogue.known.root, (1, 1)).optional


@pytest.mark.parametrize(
    "text",
    [
        "add release it inside the first step",
        "insert a step release it as part of fetch",
        "please put release it into step 1",
    ],
)
def test_a_part_is_added_inside_a_step(text: str) -> None:
    teacher = counting().tell(text)
    inside = at(teacher.dialogue.known.root, (1,)).parts
    assert [part.name for part in inside] == ["grasp the block", "lift it", "release it"]
    assert teacher.topics[0] == "done.added_inside"


def test_a_single_motion_with_a_part_has_another() -> None:
    teacher = Lessons().introduce().tell(f"add a wiggle inside {STEPS[0]}")
    opened = at(teacher.dialogue.known.root, (1, 1))
    assert [part.name for part in opened.parts] == ["wiggle", ""]
    assert teacher.asked == "subtask_name"
    teacher.hear(acts.RemoveSubtask("wiggle"))
    assert at(teacher.dialogue.known.root, (1, 1)).action is not None
    assert teacher.asked == "confirm_tree"


def test_things_put_into_things_are_no_parts() -> None:
    teacher = counting().tell("put the block into the box")
    assert "done.added_inside" not in teacher.topics


@pytest.mark.parametrize(
    ("text", "position"), [("add move away at the end", -1), ("insert a look at the start", 0)]
)
def test_a_step_is_added_at_an_end_whatever_is_asked(text: str, position: int) -> None:
    root = counting().tell(text).dialogue.known.root
    assert root.parts[position].name in ("move away", "look")
    assert len(root.parts) == 3


def test_the_order_is_free() -> None:
    teacher = counting().hear(acts.Unknown(), text="the order doesn't matter")
    assert teacher.dialogue.known.root.order == "any"
    assert teacher.topics[0] == "done.unordered"


def test_some_steps_in_any_order_leave_the_others_in_theirs() -> None:
    teacher = Lessons().introduce()
    teacher.hear(acts.Unordered(STEPS[:2]))
    first = teacher.dialogue.known.root.parts[0]
    assert first.order == "sequential"
    assert [part.name for part in first.parts] == [f"{STEPS[0]} and {STEPS[1]}", STEPS[2]]
    assert first.parts[0].order == "any"
    assert teacher.lines[0].slots["names"] == list(STEPS[:2])


def test_german_words_change_the_plan() -> None:
    teacher = Lessons(begin("german")).open().tell("Umsetzen").tell("nichts")
    teacher.tell(("Block", "Ziel")).tell(("holen", "hinstellen")).tell("zum Ziel und loslassen")
    teacher.tell("füge wackeln im ersten Schritt hinzu")
    assert "wackeln" in names(teacher.dialogue.known.root)
    teacher.tell("der zweite Schritt heißt abgeben")
    assert "abgeben" in names(teacher.dialogue.known.root)


def test_words_that_change_the_plan_are_no_name() -> None:
    teacher = Lessons().open().tell("task").tell("done").tell(("block", "target"))
    teacher.tell(3).tell("grasp the block")
    teacher.tell("add a step before grasp the block called approach the block")
    assert names(teacher.dialogue.known.root)[:2] == ("approach the block", "grasp the block")
    teacher.tell("remove grasp the block")
    assert "grasp the block" not in names(teacher.dialogue.known.root)
    assert teacher.tell("remove the lid").dialogue.known.root.parts[1].name == "remove the lid"


def test_no_more_is_an_answer_once_a_part_is_named() -> None:
    teacher = Lessons().open().tell("task").tell("done").tell(("block", "target"))
    teacher.tell(("fetch", "serve")).tell(3)
    assert teacher.tell("none").topics[0] == "error.not_an_answer"
    teacher.tell("grasp the block").tell("none")
    assert names(teacher.dialogue.known.root) == ("fetch", "grasp the block", "serve")


def test_two_steps_called_by_name_are_exchanged_and_shown_anew() -> None:
    teacher = Lessons().ready().tell(f"switch {STEPS[0]} and {STEPS[1]}")
    assert names(teacher.dialogue.known.root.parts[0])[:2] == (STEPS[1], STEPS[0])
    assert teacher.topics == ["done.ordered", "ask.show_again_now"]
    # What is not shown anew is as it was: no order is kept that cannot be carried out.
    denied = Lessons(teacher.dialogue).hear(acts.Deny())
    assert denied.topics[0] == "done.undone"
    assert names(denied.dialogue.known.root.parts[0])[:2] == STEPS[:2]
    # Things change places, not steps.
    kept = Lessons().ready().tell("swap the block and the target").dialogue.known.root
    assert names(kept.parts[0]) == STEPS[:3]


@pytest.mark.parametrize("text", ["let me show you the second step again", "I show it anew"])
def test_one_step_shown_again_needs_the_whole_where_nothing_is_left_of_it(text: str) -> None:
    teacher = Lessons().open(tree_task(lesson())).hear(acts.GoBack("demonstration"), text=text)
    assert teacher.asked == "ready"
    assert ("told.step_again" in teacher.topics) == ("second" in text)
