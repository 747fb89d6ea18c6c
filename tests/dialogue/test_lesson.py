"""Whole lessons, driven through `step` alone."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.machine import listening, public_view
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Question
from assistant.model.motion import Refusal
from assistant.model.scene import Obstacle
from assistant.model.task import primitives
from tests.dialogue.teaching import (
    SCENE,
    SETUP,
    STEPS,
    Lessons,
    demonstration,
    lesson,
    moved,
    tree_task,
)


def agreed_lesson() -> Lessons:
    teacher = Lessons().ready().run().hear(acts.Affirm())
    teacher.happen(ev.Arranged(moved("two", 30.0), SCENE))
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, None, 9.0))
    return teacher.run().hear(acts.Approve())


def test_the_introduction_builds_the_tree_of_the_paper() -> None:
    teacher = Lessons().introduce()
    assert teacher.asked == "confirm_tree"
    view = public_view(teacher.dialogue)
    assert view["primitives"] == list(STEPS)
    task = teacher.dialogue.known.task
    told = [(leaf["action"]) for leaf in view["task"]["primitives"]]  # type: ignore[index]
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
    teacher = agreed_lesson()
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


def test_a_refusal_is_told_and_nothing_moves() -> None:
    teacher = Lessons().ready().hear(acts.Start())
    refusal = Refusal("joint_limit", "target", "joint 5", 12.3, "deg", "turn")
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, refusal))
    assert teacher.topics[0] == "refuse.joint_limit"
    assert not teacher.did(fx.Move)
    assert teacher.asked == "ready"
    assert teacher.hear(acts.Explain("why did you refuse")).topics[0] == "explain.joint_limit"


def test_stop_halts_latches_and_only_a_start_moves_again() -> None:
    teacher = Lessons().ready().moving()
    assert teacher.hear(acts.Stop()).effects[0] == fx.Halt("stop")
    assert teacher.topics == ["stopped.stop"]
    assert not teacher.hear(acts.Resume()).did(fx.GoOn)
    assert not teacher.hear(acts.Affirm()).did(fx.GoOn)
    assert fx.GoOn(anew=True) in teacher.hear(acts.Start()).effects


def test_a_stop_from_outside_is_told() -> None:
    teacher = Lessons().ready().moving()
    assert teacher.happen(ev.Halted("Ctrl-C")).topics == ["stopped.stop"]
    assert public_view(teacher.dialogue)["motion"] == "stopped"


def test_pause_and_resume_keep_the_run() -> None:
    teacher = Lessons().ready().moving().hear(acts.Pause())
    assert teacher.effects[0] == fx.Halt("pause")
    assert fx.GoOn(anew=True) in teacher.hear(acts.Resume()).effects


def test_a_correction_while_paused_is_checked_before_going_on() -> None:
    teacher = Lessons().ready().moving().hear(acts.Pause())
    teacher.hear(acts.Translate("up"))
    teacher.hear(acts.Resume())
    check = next(one for one in teacher.effects if isinstance(one, fx.Check))
    assert check.anew
    assert not teacher.did(fx.GoOn)
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, None))
    move = next(one for one in teacher.effects if isinstance(one, fx.Move))
    assert move.anew
    assert move.task.learned is not None
    assert len(move.task.learned.feedback) == 1


def test_an_unmet_condition_ends_the_run_and_is_told() -> None:
    teacher = Lessons().ready().moving().report("primitive", 1)
    teacher.report("unmet", 1, text="held", object="block")
    assert teacher.topics == ["stopped.unmet.held"]
    assert public_view(teacher.dialogue)["motion"] == "stopped"


def test_the_robot_does_not_agree_after_one_setup() -> None:
    teacher = Lessons().ready().run().hear(acts.Affirm()).run().hear(acts.Approve())
    assert teacher.topics[0] == "explain.not_agreed"
    assert not teacher.did(fx.Keep)


def test_a_correction_makes_the_robot_start_counting_again() -> None:
    teacher = agreed_lesson().happen(ev.Kept("pick and place"))
    teacher.hear(acts.Translate("up"))
    teacher.moving().finish().hear(acts.Approve())
    assert teacher.topics[0] == "explain.not_agreed"


def test_leaving_with_unsaved_work_asks() -> None:
    teacher = Lessons().ready().hear(acts.Quit())
    assert teacher.asked == "unsaved"
    teacher.hear(acts.Affirm())
    assert teacher.did(fx.Keep)
    assert teacher.happen(ev.Kept("pick and place")).did(fx.Leave)
    refused = Lessons().ready().hear(acts.Quit()).hear(acts.Deny())
    assert refused.did(fx.Leave)


def test_overwriting_asks() -> None:
    teacher = Lessons()
    teacher.ready()
    teacher.dialogue = Lessons(teacher.dialogue).happen(ev.Kept("pick and place")).dialogue
    other = Lessons().open(tree_task(lesson()), saved=("stacking",))
    other.hear(acts.Save("stacking"))
    assert other.asked == "unsaved"
    assert not other.did(fx.Keep)
    keep = next(one for one in other.hear(acts.Affirm()).effects if isinstance(one, fx.Keep))
    assert keep.overwrite


def test_going_back_keeps_everything() -> None:
    teacher = Lessons().ready().run()
    known = teacher.dialogue.known
    for stage in ("introduction", "demonstration", "learning", "practice"):
        teacher.hear(acts.GoBack(stage))
        assert public_view(teacher.dialogue)["stage"] == stage
        assert teacher.dialogue.known.lesson is known.lesson
        assert teacher.dialogue.known.demonstrations == known.demonstrations


def test_a_missing_step_is_asked_and_needs_a_new_demonstration() -> None:
    facts = {"introduced": 5, "seen": 4}
    question = Question("missing_step", "move up object", "fewer_episodes", facts)
    teacher = Lessons().learned(question)
    assert teacher.asked == "missing_step"
    teacher.tell("lifting it")
    assert teacher.topics[0] == "told.needs_demonstration"
    assert teacher.asked == "ready"


def test_yes_to_optional_makes_a_step_optional() -> None:
    teacher = Lessons().learned(Question("optional", "move up object", "no_change"))
    assert teacher.asked == "optional"
    teacher.hear(acts.Affirm())
    leaves = public_view(teacher.dialogue)["task"]["primitives"]  # type: ignore[index]
    assert [leaf["optional"] for leaf in leaves] == [False, False, True, False, False]


def test_a_learned_task_from_a_file_goes_straight_to_practice() -> None:
    teacher = Lessons().open(tree_task(lesson()))
    assert teacher.asked == "ready"
    assert public_view(teacher.dialogue)["stage"] == "practice"


def test_a_moved_cut_is_learned_anew_and_corrections_stay() -> None:
    teacher = Lessons().ready().hear(acts.Translate("up"))
    teacher.hear(acts.MoveCut("grasp object", direction="later"))
    learn = next(one for one in teacher.effects if isinstance(one, fx.Learn))
    assert learn.cuts_s == pytest.approx((2.0, 4.5, 6.0, 8.0))
    assert learn.assigned[1] == (2, "grasp object")
    teacher.happen(ev.Learned(lesson()))
    assert len(public_view(teacher.dialogue)["feedback"]) == 1  # type: ignore[arg-type]


def test_renaming_reaches_into_the_lesson() -> None:
    teacher = Lessons().ready().hear(acts.Rename("move up object", "lift"))
    assert not teacher.did(fx.Learn)
    view = public_view(teacher.dialogue)
    assert "lift" in view["primitives"]  # type: ignore[operator]
    episodes = view["lesson"]["episodes"]  # type: ignore[index]
    assert episodes[2]["primitive"] == "lift"


def test_removing_a_step_after_learning_learns_again() -> None:
    teacher = Lessons().ready().hear(acts.RemoveSubtask("move up object"))
    assert teacher.topics[0] == "done.removed_shown"
    assert teacher.did(fx.Learn)


def test_a_question_asked_again_is_short_and_repeating_says_it_in_full() -> None:
    teacher = Lessons().ready()
    full = phrase(teacher.lines[-1])
    short = phrase(teacher.hear(acts.Optional("move up object")).lines[-1])
    assert len(short) < len(full)
    assert phrase(teacher.hear(acts.RepeatLine()).lines[-1]) == full


@pytest.mark.parametrize(("z_mm", "kind"), [(300.0, "hand"), (240.0, "body"), (500.0, "hand")])
def test_a_place_is_of_what_would_stand_on_the_table(z_mm: float, kind: str) -> None:
    table = Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0))
    teacher = Lessons().ready()
    scene = replace(SCENE, tables=(table,))
    teacher.happen(ev.Arranged(SETUP, scene)).happen(ev.Checked(SETUP, None))
    teacher.hear(acts.SetPose("block", (500.0, 0.0, z_mm)))
    assert teacher.lines[0].slots["place"]["of"] == kind


def test_why_a_cut_and_why_a_step_are_answered_from_the_lesson() -> None:
    teacher = Lessons().learned()
    teacher.hear(acts.Explain("why did you cut at 4 seconds"))
    assert teacher.topics[0] == "explain.cut"
    assert teacher.lines[0].slots["signals"] == ["gripper", "voice"]
    teacher.hear(acts.Explain("why is the second part the grasp"))
    assert teacher.topics[0] == "explain.assignment"
    assert teacher.lines[0].slots["name"] == "grasp object"
    assert teacher.hear(acts.Explain("how sure are you")).topics[0] == "explain.sure"
    assert teacher.hear(acts.Explain("what did you learn")).topics[0] == "explain.learned"


def test_a_step_nobody_introduced_gets_a_name_and_its_own_part() -> None:
    facts = {"from_s": 4.0, "to_s": 6.0, "introduced": 5, "shown": 6}
    teacher = Lessons().learned(Question("missing_step", "", "never_introduced", facts))
    teacher.tell("shake it")
    assert teacher.topics[0] == "done.added"
    learn = next(one for one in teacher.effects if isinstance(one, fx.Learn))
    assert (3, "shake it") in learn.assigned
    leaves = [leaf.name for leaf in primitives(learn.task.tree)]
    assert leaves.index("shake it") == 2


def test_comparing_tells_what_differs() -> None:
    teacher = Lessons().open(tree_task(lesson()), saved=("old",)).hear(acts.Compare("old"))
    assert fx.Load("old") in teacher.effects
    teacher.hear(acts.Undo())
    known = teacher.dialogue.known
    teacher.happen(ev.Loaded("old", tree_task(lesson())))
    assert teacher.topics[0] in ("told.comparison", "told.comparison_same")
    assert teacher.dialogue.known == known


def test_the_demonstration_can_be_seen_again() -> None:
    teacher = Lessons().learned().hear(acts.Show("trajectory"))
    assert teacher.asked == "ready"
    assert not teacher.did(fx.Replay)
    teacher.hear(acts.Affirm())
    assert teacher.did(fx.Replay)
    teacher.report("primitive", 0)
    assert teacher.topics == ["announce.primitive"]
    teacher.report("finished", 4)
    assert teacher.asked == "confirm_segmentation"


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


def test_what_could_not_be_learned_is_told_and_watched_again() -> None:
    teacher = Lessons().confirmed().hear(acts.Start()).hear(acts.Approve())
    teacher.happen(ev.Shown(demonstration())).happen(ev.Learned(None, "never_closed"))
    assert "the hand never closed" in phrase(teacher.lines[0])
    assert teacher.asked == "ready"


def test_a_second_miss_offers_what_can_be_said() -> None:
    teacher = Lessons().ready().hear(acts.Start(), sure=0.5)
    assert teacher.asked == "did_you_mean"
    assert not teacher.did(fx.Check)
    teacher.hear(acts.Start(), sure=0.5)
    assert "help.ready" in teacher.topics
    assert teacher.asked == "ready"


def test_agreeing_on_a_name_that_is_taken_asks_before_it_is_replaced() -> None:
    teacher = Lessons().open(tree_task(lesson()), saved=("pick and place", "other"))
    teacher.dialogue = replace(teacher.dialogue, saved_as="", pace="normal")
    for setup in (moved("two", 30.0), moved("three", 40.0)):
        teacher.happen(ev.Arranged(setup, SCENE))
        teacher.happen(ev.Checked(setup, None)).run()
    teacher.hear(acts.Affirm())
    assert teacher.topics[0] == "done.agreed"
    assert teacher.asked == "unsaved"
    assert not teacher.did(fx.Keep)
    assert fx.Keep(teacher.dialogue.known.task, "mine") in teacher.hear(acts.Save("mine")).effects


def test_after_a_refusal_the_robot_asks_for_another_place() -> None:
    teacher = Lessons().ready().hear(acts.Start())
    refusal = Refusal("reach", "grasp of block", "", 80.0, "mm", "closer")
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, refusal))
    assert teacher.topics[-1] == "ask.ready_refused"


def test_who_has_said_yes_to_the_unsure_cuts_is_not_asked_about_all_of_them_again() -> None:
    question = Question("confirm_segmentation", "grasp object", "unsure_cut", {"at_s": 4.0})
    teacher = Lessons().learned(question)
    assert teacher.asked == "confirm_segmentation"
    assert teacher.hear(acts.Affirm()).asked == "ready"
