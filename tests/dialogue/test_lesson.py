"""Whole lessons, driven through `step` alone."""

from __future__ import annotations

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.machine import listening, public_view
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import (
    STEPS,
    Lessons,
    demonstration,
    lesson,
    tree_task,
)


def test_the_introduction_builds_the_tree_of_the_paper() -> None:
    teacher = Lessons().introduce()
    assert teacher.asked == "confirm_tree"
    view = public_view(teacher.dialogue)
    assert view["primitives"] == list(STEPS)
    task = teacher.dialogue.known.task
    told = [(leaf["action"]) for leaf in view["task"]["primitives"]]
    assert told == [
        {"move": "approach", "object": "block"},
        {"hand": "close", "object": "block"},
        {"move": "up", "object": "block"},
        {"move": "down", "object": "target"},
        {"hand": "open", "object": "target"},
    ]
    assert {one.name: one.role for one in task.objects} == {"block": "object", "target": "target"}


def test_a_lesson_goes_through_all_stages_and_is_saved() -> None:
    teacher = Lessons().introduce()
    assert public_view(teacher.dialogue)["stage"] == "introduction"
    assert teacher.hear(acts.Affirm()).asked == "ready"
    assert listening(teacher.dialogue).stage == "demonstration"
    assert teacher.hear(acts.Start()).did(fx.Record)
    assert teacher.hear(acts.Approve()).did(fx.EndRecording)
    teacher = Lessons().agreed()
    assert teacher.topics == ["done.agreed"]
    assert teacher.did(fx.Keep)
    assert teacher.happen(ev.Kept("pick and place")).topics[0] == "done.saved"
    view = public_view(teacher.dialogue)
    assert view["agreed"] is True
    assert view["unsaved"] is False
    assert view["saved"] == ["pick and place"]


def test_slow_practice_announces_each_primitive_before_it_moves_on() -> None:
    teacher = Lessons().ready().moving()
    move = next(one for one in teacher.effects if isinstance(one, fx.Move))
    assert (move.speed, move.pause_before_primitives) == (0.5, True)
    for at, name in enumerate(STEPS):
        teacher.report("primitive", at)
        assert teacher.topics == ["announce.primitive"]
        line = teacher.lines[0]
        assert line.about is not None
        assert line.about.name == name
        assert {"before", "until", "action", "expect"} <= set(line.slots)
        assert isinstance(teacher.effects[-1], fx.GoOn)
    assert teacher.report("perceived", 4, text="held", object="block").topics == ["perceived.held"]


def test_practice_at_normal_speed_is_silent_about_itself() -> None:
    teacher = Lessons().ready().run().hear(acts.Affirm()).moving()
    move = next(one for one in teacher.effects if isinstance(one, fx.Move))
    assert (move.speed, move.pause_before_primitives) == (1.0, False)
    assert teacher.report("primitive", 0).effects == ()
    assert teacher.report("perceived", 1, text="held", object="block").effects == ()


def test_going_back_keeps_everything() -> None:
    teacher = Lessons().ready().run()
    known = teacher.dialogue.known
    for stage in ("introduction", "demonstration", "learning", "practice"):
        teacher.hear(acts.GoBack(stage))
        assert public_view(teacher.dialogue)["stage"] == stage
        assert teacher.dialogue.known.lesson is known.lesson
        assert teacher.dialogue.known.demonstrations == known.demonstrations


def test_a_learned_task_from_a_file_goes_straight_to_practice() -> None:
    teacher = Lessons().open(tree_task(lesson()))
    assert teacher.asked == "ready"
    assert public_view(teacher.dialogue)["stage"] == "practice"


def test_a_question_asked_again_is_short_and_repeating_says_it_in_full() -> None:
    teacher = Lessons().ready()
    full = phrase(teacher.lines[-1])
    short = phrase(teacher.hear(acts.Optional("move up object")).lines[-1])
    assert len(short) < len(full)
    assert phrase(teacher.hear(acts.RepeatLine()).lines[-1]) == full


def test_while_watching_markers_and_chat_are_met_with_silence() -> None:
    teacher = Lessons().confirmed().hear(acts.Start())
    for quiet in (acts.Cue("next"), acts.KeyState("look"), acts.Unknown(), acts.Translate("up")):
        assert teacher.hear(quiet).effects == ()
    assert teacher.hear(acts.Gripper("open")).effects == (fx.SetHand("open"),)
    assert fx.EndRecording(keep=False) in teacher.hear(acts.Again()).effects
    assert teacher.asked == "ready"


def test_a_stop_while_watching_keeps_what_was_shown() -> None:
    teacher = Lessons().confirmed().hear(acts.Start()).hear(acts.Stop())
    assert teacher.effects[0] == fx.Halt("stop")
    assert fx.EndRecording(keep=True) in teacher.effects
    assert teacher.happen(ev.Shown(demonstration())).asked == "satisfied"
    assert teacher.hear(acts.Affirm()).did(fx.Learn)


def test_a_second_miss_offers_what_can_be_said() -> None:
    teacher = Lessons().ready().hear(acts.Start(), sure=0.5)
    assert teacher.asked == "did_you_mean"
    assert not teacher.did(fx.Check)
    teacher.hear(acts.Start(), sure=0.5)
    assert "help.ready" in teacher.topics
    assert teacher.asked == "ready"


def test_a_new_guess_after_one_that_was_passed_over_is_read_back_too() -> None:
    teacher = Lessons().introduce()
    teacher.hear(acts.Split("grasp object"), sure=0.7)
    teacher.hear(acts.RemoveSubtask("grasp object"), sure=0.7)
    assert teacher.topics == ["confirm.did_you_mean"]
    teacher.hear(acts.RemoveSubtask("grasp object"), sure=0.7)
    assert teacher.topics[0] == "error.not_understood_again"
