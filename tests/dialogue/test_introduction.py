"""What the robot asks, and that it asks only what it does not know."""

from __future__ import annotations

import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue.machine import public_view
from assistant.dialogue.sketch import names
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import STEPS, Lessons


def begun() -> Lessons:
    return Lessons().open().tell("sorting").tell("all in place").tell(("block", "target"))


def tree_names(teacher: Lessons) -> tuple[str, ...]:
    return names(teacher.dialogue.known.root)


def test_one_sentence_may_answer_several_questions() -> None:
    sentence = "pick and place, first you pick up the block, then you place it on the target"
    teacher = Lessons().open().tell(sentence)
    assert teacher.dialogue.known.name == "pick and place"
    assert tree_names(teacher) == ("pick up the block", "place it on the target")
    teacher.tell("goal").tell(("block", "target"))
    assert teacher.asked == "subtask_count"
    assert teacher.lines[-1].about is not None
    assert teacher.lines[-1].about.index == (1,)


def test_steps_may_be_given_as_a_list() -> None:
    teacher = begun().tell(1).tell("pick up").tell(3)
    teacher.tell("approach block, grasp block and move up block")
    assert tree_names(teacher) == ("pick up", "approach block", "grasp block", "move up block")
    assert teacher.asked == "confirm_tree"


def test_a_list_instead_of_a_number_counts_itself() -> None:
    teacher = begun().tell(("approach the block", "grasp it", "lift it"))
    assert teacher.asked == "confirm_tree"


def test_a_contradiction_is_noticed_and_settled() -> None:
    teacher = begun().tell(3)
    teacher.tell(("approach the block", "grasp it", "lift it", "lower it"))
    assert teacher.topics[-1] == "ask.count_contradicted"
    assert teacher.lines[-1].slots["said"] == 3
    assert teacher.lines[-1].slots["count"] == 4
    assert len(tree_names(Lessons(teacher.dialogue).tell(4))) == 4
    teacher.tell(3)
    assert teacher.asked == "which"
    teacher.tell("lift it")
    assert tree_names(teacher) == ("approach the block", "grasp it", "lower it")


def test_any_depth() -> None:
    teacher = begun().tell(1)
    for depth in range(6):
        teacher.tell(f"serve level {depth}").tell(1)
    teacher.tell("close the hand")
    assert teacher.asked == "confirm_tree"


def test_an_action_without_words_is_done_as_shown() -> None:
    teacher = begun().tell(1).tell("wiggle").tell(0)
    assert teacher.asked == "actions"
    teacher.tell("shake it a little")
    leaf = public_view(teacher.dialogue)["task"]["primitives"][0]
    assert "free" in leaf["action"]


def test_an_action_understood_as_a_command_is_an_answer() -> None:
    teacher = begun().tell(1).tell("fetching").tell(0)
    teacher.hear(acts.Gripper("close"), text="close the hand")
    assert not teacher.did(fx.SetHand)
    leaf = public_view(teacher.dialogue)["task"]["primitives"][0]
    assert leaf["action"] == {"hand": "close", "object": "block"}


def test_an_unknown_thing_gets_shape_size_and_place() -> None:
    teacher = Lessons().open().tell("task").tell("goal").tell(("mug", "target"))
    assert teacher.asked == "body"
    assert teacher.tell("it is round").topics[0] == "error.size"
    teacher.tell("a cylinder 8 centimetres wide and 10 high")
    assert teacher.asked == "pose"
    body = teacher.dialogue.known.scene.bodies["mug"]
    assert (body.shape, body.size_mm) == ("cylinder", (80.0, 80.0, 100.0))
    teacher.hear(acts.SetPose("mug", (500.0, 100.0, 240.0)))
    arrange = next(one for one in teacher.effects if isinstance(one, fx.Arrange))
    assert arrange.setup is not None
    assert arrange.setup.places["mug"].kind == "body"
    assert arrange.scene is not None
    assert "mug" in arrange.scene.bodies
    assert teacher.asked == "subtask_count"


def test_a_size_is_no_place() -> None:
    teacher = Lessons().open().tell("task").tell("goal").tell(("mug",))
    teacher.tell("a cylinder 8 centimetres wide and 10 high")
    teacher.hear(acts.SetPose("flat box", (120.0, 120.0, 10.0)))
    assert "error.no_such_thing" in teacher.topics
    assert teacher.asked == "pose"
    assert "mug" not in teacher.dialogue.known.setup.places


def test_a_place_may_be_left_to_the_demonstration() -> None:
    teacher = Lessons().open().tell("task").tell("goal").tell(("mug",))
    teacher.tell("a cylinder 8 centimetres wide and 10 high").hear(acts.Deny())
    assert teacher.asked == "subtask_count"


@pytest.mark.parametrize("taken", ["approach object", "Approach  Object"])
def test_names_are_unique(taken: str) -> None:
    teacher = begun().tell(2).tell("approach object").tell(taken)
    assert teacher.topics[0] == "error.name_taken"
    assert teacher.asked == "subtask_name"


def test_nonsense_counts_are_refused() -> None:
    assert begun().tell(5000).topics[0] == "error.count"
    assert begun().tell(-1).topics[0] == "error.count"


def test_a_task_of_one_motion() -> None:
    teacher = Lessons().open().tell("approach the block").tell("near").tell(("block",)).tell(0)
    assert teacher.asked == "confirm_tree"
    assert public_view(teacher.dialogue)["primitives"] == ["approach the block"]


def test_the_tree_is_corrected_by_name() -> None:
    teacher = Lessons().introduce()
    teacher.hear(acts.Rename("move up object", "lift it"))
    teacher.hear(acts.AddSubtask("retreat", after="place object on target"))
    teacher.hear(acts.Optional("lift it"))
    teacher.hear(acts.Unordered(("pick up object", "place object")))
    assert teacher.asked == "confirm_tree"
    leaves = public_view(teacher.dialogue)["primitives"]
    assert leaves == [*STEPS[:2], "lift it", *STEPS[3:], "retreat"]
    teacher.hear(acts.Ordered("pick up object", "place object"))
    assert teacher.dialogue.known.root.order == "sequential"
    teacher.hear(acts.RemoveSubtask("retreat"))
    teacher.hear(acts.Merge(("approach object", "grasp object")))
    leaves = public_view(teacher.dialogue)["primitives"]
    assert leaves == ["approach object and grasp object", "lift it", *STEPS[3:]]
    teacher.hear(acts.Split("lift it"))
    assert teacher.asked == "subtask_name"


def test_reordering_moves_a_step() -> None:
    teacher = Lessons().introduce().hear(acts.Ordered("place object", "pick up object"))
    assert teacher.dialogue.known.root.parts[0].name == "place object"


def test_undo_takes_back_one_answer_and_asks_it_again() -> None:
    teacher = begun().tell(2).tell("pick up")
    teacher.hear(acts.Undo())
    assert teacher.asked == "subtask_name"
    assert tree_names(teacher) == ()
    teacher.hear(acts.Redo())
    assert tree_names(teacher) == ("pick up",)


def test_the_red_block_is_the_block() -> None:
    teacher = Lessons().open().tell("task").tell("goal").tell("the small block and the target")
    assert teacher.asked == "subtask_count"
    assert [one.name for one in teacher.dialogue.known.objects or ()] == ["block", "target"]


def test_not_knowing_is_an_answer() -> None:
    teacher = Lessons().open().tell("task").tell("goal").tell(("mug",))
    teacher.hear(acts.Unknown(), text="I don't know", sure=0.4)
    assert teacher.topics[0] == "told.assumed_body"
    teacher.hear(acts.Unknown(), text="no idea", sure=0.4)
    assert teacher.asked == "subtask_count"


def test_bare_numbers_answer_where_something_is() -> None:
    teacher = Lessons().open().tell("task").tell("goal").tell(("mug",)).tell("a cube, 5 cm")
    teacher.hear(acts.Inform("500 -20.5 240 and 15"), text="500 -20.5 240 and 15")
    place = teacher.dialogue.known.setup.places["mug"]
    assert (place.xyz_mm, place.rpy_deg) == ((500.0, -20.5, 240.0), (0.0, 0.0, 15.0))


def test_where_several_steps_fit_the_robot_asks_which() -> None:
    teacher = Lessons().introduce().hear(acts.RemoveSubtask("move"))
    assert teacher.asked == "which"
    teacher.tell("move up object")
    assert teacher.topics[0] == "done.removed"
    assert "move up object" not in tree_names(teacher)


def test_what_is_called_so_names_the_task() -> None:
    teacher = Lessons().open().hear(acts.Rename("it", "sorting"), text="it's called sorting")
    assert teacher.dialogue.known.name == "sorting"


def test_commas_lost_in_understanding_are_found_again() -> None:
    teacher = begun().tell(1).tell("pick up").tell(3)
    said = "approach block, grasp block and move up block"
    teacher.hear(acts.Inform(said.replace(",", "")), text=said)
    assert len(tree_names(teacher)) == 4


def test_steps_heard_without_commas_are_told_apart_by_their_verbs() -> None:
    teacher = begun().tell(1).tell("pick up").tell(3)
    teacher.tell("approach block grasp block and move up block")
    assert tree_names(teacher)[1:] == ("approach block", "grasp block", "move up block")


def test_a_list_of_steps_answers_how_many_whatever_was_understood() -> None:
    teacher = begun()
    said = "first you approach the block, then grasp it, then lift it, and finally release it"
    teacher.hear(acts.Inform(2), text=said, sure=0.7)
    assert teacher.asked == "confirm_tree"
    assert tree_names(teacher) == ("approach the block", "grasp it", "lift it", "release it")


@pytest.mark.parametrize(
    ("text", "asked", "count"),
    [
        ("three steps: pick it up, carry it and put it down", "subtask_count", 3),
        ("Three, pick it up, carry it over, put it down", "subtask_count", 3),
        ("four: pick it up, carry it over, put it down", "subtask_name", 4),
    ],
)
def test_a_number_and_the_steps_are_heard_in_one(text: str, asked: str, count: int) -> None:
    teacher = Lessons().open().tell("task").tell("done").tell(("block", "target"))
    teacher.hear(acts.Inform(count), text=text)
    parts = teacher.dialogue.known.root.parts
    assert len(parts) == count
    assert parts[0].name == "pick it up"
    assert teacher.asked == asked


def test_a_number_that_the_steps_contradict_is_asked_about() -> None:
    teacher = Lessons().open().tell("task").tell("done").tell(("block", "target"))
    text = "two steps: pick it up, carry it over, put it down"
    teacher.hear(acts.Inform(2), text=text)
    assert teacher.topics == ["ask.count_contradicted"]


def test_a_step_of_one_part_is_a_single_motion() -> None:
    teacher = Lessons().open().tell("task").tell("done it is").tell(("block", "target"))
    teacher.tell(2).tell("fetch").tell("serve").tell(1)
    root = teacher.dialogue.known.root
    assert root.parts[0].single
    assert root.parts[0].parts == ()


def test_a_letter_is_no_goal_and_a_size_no_number_of_steps() -> None:
    teacher = Lessons().open().tell("task").tell("y")
    assert teacher.topics[0] == "error.not_an_answer"
    teacher.tell("all is tidy").tell(("block", "target")).tell("box 30x20x1")
    assert teacher.topics[0] == "error.count"
    teacher.tell("move it 10 cm")
    assert teacher.topics[0] == "error.count"
    assert teacher.dialogue.known.root.parts == ()


def test_who_has_no_idea_of_a_size_may_tell_one_all_the_same() -> None:
    teacher = Lessons().open().tell("task").tell("all is tidy").tell(("drum", "target"))
    teacher.hear(acts.Unknown(), text="idk 10x6x4cm", sure=0.9)
    assert teacher.dialogue.known.scene.bodies["drum"].size_mm == (100.0, 60.0, 40.0)
