"""Checks, motion, halts and agreement in practice."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.machine import public_view
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.motion import GOING_ON, Refusal
from assistant.model.scene import Obstacle
from tests.dialogue.teaching import (
    SCENE,
    SETUP,
    Lessons,
)


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


@pytest.mark.parametrize(
    ("language", "told"), [("english", "I go on."), ("german", "Ich mache weiter.")]
)
def test_a_start_heard_before_the_halt_took_effect_is_not_undone_by_it(
    language: str, told: str
) -> None:
    teacher = Lessons().ready().moving().hear(acts.Stop()).hear(acts.Start())
    assert phrase(teacher.lines[0], language) == told
    teacher.report("halted", 1, text=GOING_ON)
    assert teacher.effects == ()
    assert public_view(teacher.dialogue)["motion"] == "moving"
    # A halt of its own still ends the run.
    assert teacher.report("halted", 1, text="stop").topics == ["stopped.stop"]


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


@pytest.mark.parametrize(
    ("amount", "unit", "told"),
    [
        (14.2, "mm", ("14 mm off", "14 mm daneben")),
        (9.0, "deg", ("9 degrees off", "9 Grad daneben")),
        (None, "", ("not where I was told.", "nicht, wo es hieß.")),
    ],
)
def test_what_slipped_in_the_hand_is_told_as_that(
    amount: float | None, unit: str, told: tuple[str, str]
) -> None:
    teacher = Lessons().ready().moving().report("primitive", 3)
    teacher.report("unmet", 3, text="slipped", object="block", amount=amount, unit=unit)
    assert teacher.topics == ["stopped.unmet.slipped"]
    for language, words in zip(("english", "german"), told, strict=True):
        assert words in phrase(teacher.lines[0], language)


def test_a_condition_of_a_step_is_told_with_what_was_wanted_and_what_is() -> None:
    teacher = Lessons().ready().moving().report("primitive", 1)
    told = {"text": "hand", "object": "closed", "when": "before", "found": "open"}
    teacher.report("unmet", 1, **told)
    assert teacher.topics == ["stopped.unmet_before.hand"]
    assert phrase(teacher.lines[0]).startswith(
        'I stopped: "grasp object" was to start when the hand is closed, but the hand is open.'
    )


def test_a_run_that_was_helped_over_a_condition_does_not_count() -> None:
    teacher = Lessons().ready().moving().report("primitive", 1)
    teacher.report("unmet", 1, text="hand", object="closed", when="before", found="open")
    teacher.hear(acts.Start()).finish()
    assert teacher.dialogue.runs[-1].complete
    assert teacher.dialogue.clean == ()


def test_the_robot_does_not_agree_after_one_setup() -> None:
    teacher = Lessons().ready().run().hear(acts.Affirm()).run().hear(acts.Approve())
    assert teacher.topics[0] == "explain.not_agreed"
    assert not teacher.did(fx.Keep)


def test_a_correction_makes_the_robot_start_counting_again() -> None:
    teacher = Lessons().agreed().happen(ev.Kept("pick and place"))
    teacher.hear(acts.Translate("up"))
    teacher.moving().finish().hear(acts.Approve())
    assert teacher.topics[0] == "explain.not_agreed"


@pytest.mark.parametrize(("z_mm", "kind"), [(300.0, "hand"), (240.0, "body"), (500.0, "hand")])
def test_a_place_is_of_what_would_stand_on_the_table(z_mm: float, kind: str) -> None:
    table = Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0))
    teacher = Lessons().ready()
    scene = replace(SCENE, tables=(table,))
    teacher.happen(ev.Arranged(SETUP, scene)).happen(ev.Checked(SETUP, None))
    teacher.hear(acts.SetPose("block", (500.0, 0.0, z_mm)))
    assert teacher.lines[0].slots["place"]["of"] == kind


def test_after_a_refusal_the_robot_asks_for_another_place() -> None:
    teacher = Lessons().ready().hear(acts.Start())
    refusal = Refusal("reach", "grasp of block", "", 80.0, "mm", "closer")
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, refusal))
    assert teacher.topics[-1] == "ask.ready_refused"


@pytest.mark.parametrize("words", ["why", "Why not?", "why can't you"])
def test_after_a_refusal_why_is_answered_with_its_reason_and_nothing_moves(words: str) -> None:
    teacher = Lessons().ready().hear(acts.Start())
    refusal = Refusal("reach", "grasp of block", "", 195.0, "mm", "closer")
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, refusal))
    teacher.hear(acts.Affirm(), text=words)
    assert teacher.topics[0] == "explain.reach.only"
    assert not teacher.did(fx.Check)


def test_who_asks_to_wait_before_anything_moved_is_given_time() -> None:
    assert Lessons().introduce().hear(acts.Pause(), text="hmm wait").topics == ["told.waiting"]
    assert Lessons().ready().hear(acts.Pause(), text="wait").topics == ["told.still"]
