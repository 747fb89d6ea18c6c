"""What newcomers say beside the question, and what the robot makes of it."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.dialogue import effects as fx
from assistant.dialogue.machine import begin
from assistant.language.asides import introduced_person, is_greeting, recounted, unknowing
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import Lessons


def newcomer(*said: str) -> Lessons:
    """Return a lesson in which nothing said is understood as more than an answer."""
    teacher = Lessons().open()
    for text in said:
        teacher.tell(text)
    return teacher


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("hi, my name is Anna", "Anna"),
        ("My name's Jean Paul.", "Jean Paul"),
        ("hello robot, I'm bob", "Bob"),
        ("i am Anna and I want to teach you something", "Anna"),
        ("call me Kim", "Kim"),
        ("I'm ready", ""),
        ("i am going to show you", ""),
        ("I'm not sure", ""),
        ("this is a block", ""),
        ("my block is red", ""),
    ],
)
def test_a_person_tells_a_name(text: str, name: str) -> None:
    assert introduced_person(text)[0] == name


@given(st.text(max_size=60))
@settings(max_examples=60)
def test_anything_may_be_said(text: str) -> None:
    introduced_person(text)
    is_greeting(text)
    unknowing(text)


def test_a_teachers_name_is_not_the_tasks() -> None:
    teacher = newcomer("hi, my name is Anna")
    assert teacher.topics == ["told.nice_to_meet", "ask.task_name"]
    assert teacher.dialogue.known.name == ""


def test_who_introduces_both_is_greeted_and_goes_on() -> None:
    teacher = newcomer("I'm Anna and I want to teach you sorting the cups")
    assert teacher.topics == ["told.nice_to_meet", "ask.goal"]
    assert teacher.dialogue.known.name == "sorting the cups"


def test_a_greeting_is_answered_and_the_question_stays() -> None:
    teacher = newcomer("good evening, robot!")
    assert teacher.topics == ["told.hello", "ask.task_name"]


def test_a_name_told_late_renames_the_task() -> None:
    teacher = newcomer("anna", "it's called sorting the cups")
    assert teacher.dialogue.known.name == "sorting the cups"
    assert teacher.topics == ["done.renamed", "ask.goal"]
    assert teacher.dialogue.known.goal is None
    assert teacher.hear(acts.Undo()).dialogue.known.name == "anna"


def test_a_goal_and_a_thing_told_late_are_kept() -> None:
    teacher = newcomer("sorting", "tidy", "the goal is that the block is on the target")
    assert teacher.dialogue.known.goal == "the block is on the target"
    assert teacher.asked == "objects"
    teacher.tell("block").tell("you also need the target")
    assert [one.name for one in teacher.dialogue.known.objects or ()] == ["block", "target"]


def test_a_sentence_names_its_things() -> None:
    teacher = newcomer("sorting", "tidy", "the cup should be on the tray")
    assert [one.name for one in teacher.dialogue.known.objects or ()] == ["cup", "tray"]


def test_steps_told_early_are_not_asked_for_again() -> None:
    teacher = newcomer("sorting", "tidy", "cup", "you grasp the cup and lift it")
    assert teacher.topics[0] == "done.steps"
    parts = teacher.dialogue.known.root.parts
    assert [part.name for part in parts] == ["grasp the cup", "lift it"]


@pytest.mark.parametrize("name", ["what?", "no", "12", "a", "i wonder whether that works out well"])
def test_an_odd_name_is_asked_about(name: str) -> None:
    teacher = newcomer(name)
    assert teacher.topics == ["confirm.odd_name"]
    assert Lessons(teacher.dialogue).hear(acts.Deny()).topics[-1] == "ask.task_name"
    assert teacher.hear(acts.Affirm()).dialogue.known.name
    assert teacher.asked == "goal"


def test_the_second_miss_brings_examples() -> None:
    teacher = newcomer("sorting", "tidy", "cup")
    assert teacher.asked == "body"
    assert teacher.tell("nice").topics == ["error.size", "ask.body"]
    assert teacher.tell("very nice").topics == ["error.size", "help.body", "ask.body"]


def test_who_knows_nothing_is_led_to_a_plan() -> None:
    teacher = Lessons().open()
    for _ in range(3):
        teacher.hear(acts.Unknown(), text="I don't know")
    assert teacher.dialogue.known.name == "new task"
    assert [one.name for one in teacher.dialogue.known.objects or ()] == ["block", "target"]
    teacher.hear(acts.Unknown(), text="no idea")
    assert teacher.topics == ["confirm.suggested_steps"]
    teacher.hear(acts.Affirm())
    assert teacher.asked == "confirm_tree"
    assert len(teacher.dialogue.known.root.parts) == 6


def test_not_sure_but_answering_is_an_answer() -> None:
    assert not unknowing("not sure, maybe three")
    assert unknowing("I have no idea")


def test_where_the_teacher_stands_may_be_told_first() -> None:
    teacher = Lessons().ready().hear(acts.Unknown(), text="I am standing opposite you")
    assert teacher.dialogue.known.facing == "facing"
    assert teacher.hear(acts.Translate("left")).topics[0] == "done.translate"


def test_nothing_beside_the_question_is_answered_in_motion() -> None:
    teacher = Lessons().ready().moving().hear(acts.Unknown(), text="hello")
    assert "told.hello" not in teacher.topics


def test_another_task_asks_about_unsaved_work() -> None:
    teacher = Lessons().ready()
    teacher.hear(acts.Unknown(), text="I want to teach you another task")
    assert teacher.topics == ["ask.unsaved.other"]
    kept = Lessons(teacher.dialogue).hear(acts.Affirm())
    assert kept.did(fx.Keep)
    teacher.hear(acts.Deny())
    assert teacher.topics == ["told.fresh", "ask.task_name"]
    assert teacher.dialogue.known.lesson is None
    assert teacher.hear(acts.Undo()).dialogue.known.lesson is not None


def test_loading_over_unsaved_work_asks() -> None:
    teacher = Lessons().open(saved=("stacking",)).tell("sorting").tell("tidy")
    teacher.hear(acts.Load("stacking"))
    assert teacher.topics == ["ask.unsaved.other"]
    assert not teacher.did(fx.Load)
    assert teacher.hear(acts.Deny()).did(fx.Load)


def test_places_may_be_left_to_the_demonstration() -> None:
    teacher = newcomer("sorting", "tidy", "cup and tray", "8 by 8 by 10 cm")
    assert teacher.asked == "pose"
    teacher.hear(acts.Unknown(), text="I will show you where everything is")
    assert set(teacher.dialogue.known.unplaced) == {"cup", "tray"}
    assert teacher.asked == "body"


def test_a_size_is_no_thing() -> None:
    teacher = newcomer("sorting", "tidy", "a cup, 8 cm wide and 10 high")
    assert [one.name for one in teacher.dialogue.known.objects or ()] == ["cup"]


def test_who_cannot_name_the_first_step_is_helped() -> None:
    teacher = newcomer("sorting", "tidy", "block and target").tell(2)
    teacher.hear(acts.Unknown(), text="I don't know")
    assert teacher.topics == ["confirm.suggested_steps"]
    assert teacher.hear(acts.Affirm()).asked == "confirm_tree"


def test_a_change_at_a_step_named_in_full_needs_no_question() -> None:
    teacher = Lessons().introduce()
    teacher.hear(acts.Rename("move up object", "lift"), text="call move up object lift", sure=0.7)
    assert teacher.topics[0] == "done.renamed"
    teacher.hear(acts.Rename("up", "rise"), text="call up rise", sure=0.7)
    assert teacher.topics[0] == "confirm.did_you_mean"


def test_another_number_of_steps_is_taken_where_a_name_is_asked() -> None:
    teacher = newcomer("sorting", "tidy", "block and target").tell(3)
    assert teacher.tell("no, four").topics[0] == "done.counted"
    assert len(teacher.dialogue.known.root.parts) == 4
    assert teacher.tell("none").topics[0] == "error.not_an_answer"


@pytest.mark.parametrize(
    ("text", "language", "count"),
    [
        ("I meant five", "english", 5),
        ("five, not three", "english", 5),
        ("not three, five steps", "english", 5),
        ("I think it should be 4 instead of 3", "english", 4),
        ("not three", "english", None),
        ("five cups, not three", "english", None),
        ("ich meinte fünf", "german", 5),
        ("fünf, nicht drei", "german", 5),
        ("nicht drei", "german", None),
    ],
)
def test_a_number_is_told_beside_the_wrong_one(text: str, language: str, count: int | None) -> None:
    assert recounted(text, language) == count


def test_a_number_meant_instead_is_no_name_of_a_step() -> None:
    for text in ("I meant four", "four, not three"):
        teacher = newcomer("sorting", "tidy", "block and target").tell(3)
        teacher.hear(acts.Inform(text), text=text, sure=0.5)
        assert teacher.topics[0] == "done.counted"
        assert len(teacher.dialogue.known.root.parts) == 4


def test_the_goal_may_be_changed_while_steps_are_told() -> None:
    teacher = newcomer("sorting", "tidy", "block and target")
    teacher.tell("change the goal to the block is on the lid")
    assert teacher.topics[0] == "done.goal"
    assert teacher.dialogue.known.goal == "the block is on the lid"


def test_a_name_is_what_is_said_in_the_end() -> None:
    teacher = newcomer("it's called stacking, no wait, putting away")
    assert teacher.dialogue.known.name == "putting away"


def test_what_the_hand_does_is_told_whole() -> None:
    teacher = newcomer("sorting", "tidy", "block and target").tell(1)
    teacher.hear(acts.Inform("go of it"), text="let go of it")
    assert teacher.dialogue.known.root.parts[0].name == "let go of it"
    assert teacher.asked == "confirm_tree"


@pytest.mark.parametrize(
    ("text", "name", "language"),
    [
        (
            "I'd like you to learn how to pour me a cup of tea",
            "pour me a cup of tea",
            "english",
        ),
        ("Ich möchte dir zeigen, wie man Tee einschenkt", "Tee einschenkt", "german"),
    ],
)
def test_the_task_is_named_by_what_is_to_be_taught(text: str, name: str, language: str) -> None:
    teacher = Lessons(begin(language)).open()
    teacher.hear(acts.Inform("x"), text=text, sure=0.6)
    assert teacher.dialogue.known.name == name
    assert teacher.asked == "goal"


def test_a_size_is_no_name_of_a_task() -> None:
    teacher = Lessons().open().tell("8 wide 9 high")
    assert teacher.topics == ["confirm.odd_name"]


@pytest.mark.parametrize("text", ["how do I show you", "ok, how?", "with my mouse"])
def test_who_asks_how_to_show_is_told_before_the_robot_watches(text: str) -> None:
    teacher = Lessons().confirmed().hear(acts.Start(), text=text, sure=0.7)
    assert teacher.topics == ["help.demonstration", "ask.ready_to_watch"]


def test_a_question_is_no_doubtful_yes() -> None:
    teacher = Lessons().ready().hear(acts.Affirm(), text="is it heavy", sure=0.5)
    assert teacher.topics == ["error.not_understood", "ask.ready_slow"]


def test_to_teach_something_is_no_name() -> None:
    vague = ("I want to teach you something", "hi, I am Bob and I'd like to teach you a new task")
    for text in (*vague, "stacking"):
        teacher = newcomer(text)
        assert bool(teacher.dialogue.known.name) == (text == "stacking")
        assert teacher.asked == ("goal" if text == "stacking" else "task_name")
