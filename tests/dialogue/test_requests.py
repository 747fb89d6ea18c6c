"""Requests that are known by their words."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.machine import listening, public_view
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.motion import ArmReport, Refusal
from tests.dialogue.teaching import SETUP, STEPS, Lessons

LAST = "place object on target"


def test_when_you_place_it_is_the_step_that_opens_the_hand() -> None:
    teacher = Lessons().ready()
    where = acts.Where("place it", "during")
    teacher.hear(acts.Translate("up", where=where), text="higher when you place it")
    view = public_view(teacher.dialogue)["feedback"]
    assert view[0]["primitive"] == LAST


def test_swapped_things_keep_their_heights_and_are_looked_at() -> None:
    teacher = Lessons().ready().hear(acts.Unknown(), text="swap them")
    assert teacher.did(fx.Arrange)
    assert teacher.did(fx.Check)
    assert not teacher.did(fx.Move)
    scene, places = teacher.dialogue.known.scene, teacher.dialogue.known.setup.places
    for one, other in (("block", "target"), ("target", "block")):
        now = scene.body_pose(one, places[one])
        was, there = (scene.body_pose(name, SETUP.places[name]) for name in (one, other))
        assert now[:2] == pytest.approx(there[:2], abs=1e-5)
        assert now[2] == pytest.approx(was[2], abs=1e-5)


def test_a_dry_run_tells_and_moves_nothing() -> None:
    teacher = Lessons().ready().hear(acts.Start(), text="dry run", sure=0.8)
    assert teacher.did(fx.Check)
    teacher.happen(ev.Checked(SETUP, None, 21.0))
    assert teacher.topics == ["told.dry_run", "ask.ready_slow"]
    assert not any(isinstance(one, fx.Move) for one in teacher.every)


def homing() -> Lessons:
    teacher = Lessons().ready().moving().hear(acts.Stop(), text="stop")
    return teacher.hear(acts.Unknown(), text="go home")


def test_after_a_stop_the_hand_can_go_home() -> None:
    teacher = homing()
    assert teacher.did(fx.Home)
    # It is on its way: nothing else begins before it is there.
    assert teacher.hear(acts.Start(), text="go").topics == ["told.moving_already"]
    assert teacher.hear(acts.Gripper("open"), text="open the hand").topics == ["error.while_moving"]
    teacher.report("finished")
    assert teacher.topics == ["done.home", "ask.ready_slow"]
    assert phrase(teacher.lines[0]) == "I am back at my start."
    assert teacher.hear(acts.Start(), text="go").did(fx.Check)


@pytest.mark.parametrize("act", [acts.Stop(), acts.Pause()])
def test_on_its_way_home_a_stop_is_told_as_one(act: acts.Stop | acts.Pause) -> None:
    teacher = homing()
    assert listening(teacher.dialogue).moving
    teacher.hear(act, text="stop")
    assert teacher.did(fx.Halt)
    assert teacher.topics == ["stopped.stop.home", "ask.ready_slow"]
    teacher.report("halted", text="stop")
    assert teacher.hear(acts.Resume(), text="resume").topics == ["told.say_start", "ask.ready_slow"]
    assert teacher.hear(acts.Start(), text="start").did(fx.Check)


def test_on_its_way_home_a_stop_from_outside_and_a_fault_are_told() -> None:
    teacher = homing()
    teacher.happen(ev.Halted("key"))
    assert teacher.topics[0] == "stopped.stop.home"
    teacher = homing()
    teacher.report("unmet", text="contact", object="post")
    assert teacher.topics[0] == "stopped.unmet_home.contact"
    teacher = homing().hear(acts.Quit(), text="quit")
    assert teacher.did(fx.Halt)


def test_what_is_held_at_home_is_not_let_go_unasked() -> None:
    teacher = homing()
    held = ArmReport("finished", 4.0, object="block", height_mm=310.4)
    teacher.happen(ev.ArmReported(held))
    assert phrase(teacher.lines[0]) == "I am back at my start. I still hold the block."
    assert "noch in meiner Hand" in phrase(teacher.lines[0], "german")
    teacher.hear(acts.Gripper("open"), text="open the hand")
    assert teacher.topics == ["confirm.open_above"]
    assert not teacher.did(fx.SetHand)


def test_nothing_runs_backwards() -> None:
    teacher = Lessons().ready()
    teacher.hear(acts.Translate("backward"), text="go back to when the block was picked up")
    assert teacher.topics == ["confirm.begin_until"]
    assert not public_view(teacher.dialogue)["feedback"]
    teacher.hear(acts.Translate("backward"), text="go back to when you felt well")
    assert teacher.topics == ["confirm.begin_anew"]


@pytest.mark.parametrize(
    ("moment", "step"),
    [
        ("the block was picked up", "grasp object"),
        ("you had the block in your hand", "grasp object"),
        ("it was let go", "place object on target"),
        ("moving up object", "move up object"),
    ],
)
def test_a_run_begun_anew_pauses_where_the_teacher_wants_to_be(moment: str, step: str) -> None:
    teacher = Lessons().ready()
    teacher.hear(acts.Translate("backward"), text=f"go back to when {moment}")
    assert teacher.lines[-1].slots["name"] == step
    teacher.hear(acts.Affirm())
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, None, 12.0))
    at = STEPS.index(step)
    for position in range(at + 1):
        teacher.report("primitive", position)
        assert teacher.dialogue.arm == "moving"
    if at + 1 == len(STEPS):
        return
    teacher.report("primitive", at + 1)
    assert teacher.did(fx.Halt)
    assert teacher.topics == ["told.paused_after"]
    teacher.hear(acts.Resume())
    assert teacher.did(fx.GoOn)
    teacher.report("primitive", at + 1)
    assert teacher.dialogue.arm == "moving"


def test_going_on_with_a_kept_task_is_no_start() -> None:
    teacher = Lessons().ready()
    teacher.happen(ev.Kept("sorting")).hear(acts.Start(), text="continue with Sorting")
    assert teacher.did(fx.Load)
    assert not teacher.did(fx.Check)


def test_a_version_that_there_is_not_is_not_deleted() -> None:
    teacher = Lessons().open(saved=("version one",)).hear(acts.Undo(), text="delete version nine")
    assert teacher.topics[0] == "error.no_such_task"
    assert teacher.lines[0].slots["name"] == "version nine"


def test_a_kept_task_is_deleted_after_a_question() -> None:
    teacher = Lessons().open(saved=("put_away",)).hear(acts.Unknown(), text="delete put away")
    assert teacher.topics == ["confirm.discard"]
    assert not teacher.did(fx.Discard)
    assert teacher.hear(acts.Affirm()).did(fx.Discard)
    teacher.happen(ev.Kept("put away", discarded=True))
    assert teacher.dialogue.saved == ()


def test_a_name_kept_by_its_file_is_the_same_name() -> None:
    teacher = Lessons().open(saved=("pick_and_place",))
    teacher.tell("Pick and place").hear(acts.Save())
    assert teacher.topics == ["confirm.overwrite"]


def test_who_says_something_else_than_where_they_stand_is_asked_once_more() -> None:
    teacher = Lessons().ready().hear(acts.Translate("left"), text="left")
    assert teacher.tell("slower").topics == ["help.facing", "ask.facing"]
    assert teacher.tell("beside you").topics[0] == "told.facing_own"


def test_what_is_done_now_what_was_learned_and_how_fast_is_told_from_the_lesson() -> None:
    teacher = Lessons().ready()
    teacher.hear(acts.Show("lessons"), text="what have you learned")
    assert teacher.topics[0] == "explain.learned"
    teacher.hear(acts.Explain("why are you so slow"), text="why are you so slow")
    assert teacher.topics[0] == "explain.pace_slow"
    teacher.moving().report("primitive", 1)
    teacher.hear(acts.Show("plan"), text="what are you doing?")
    assert teacher.topics == ["explain.now"]
    assert teacher.lines[0].slots["number"] == 2


def test_a_kept_task_is_compared_by_its_name() -> None:
    teacher = Lessons().ready()
    teacher.happen(ev.Kept("sorting")).hear(acts.Unknown(), text="compare it with sorting")
    assert teacher.did(fx.Load)
    assert teacher.dialogue.comparing


@pytest.mark.parametrize("text", ["right", "Right!", "more right"])
def test_right_is_no_start_before_it_was_asked_about(text: str) -> None:
    teacher = Lessons().ready().hear(acts.Affirm(), text=text)
    assert teacher.topics == ["confirm.did_you_mean"]
    assert not teacher.did(fx.Check)
    teacher.hear(acts.Affirm(), text="yes")
    assert not teacher.did(fx.Check)
    assert teacher.asked == "facing"


def test_a_refusal_after_a_correction_names_it() -> None:
    teacher = Lessons().ready().hear(acts.Translate("down", "much"), text="way lower")
    teacher.hear(acts.Start())
    refusal = Refusal("collision", "release at target", "table", 7.0, "mm", "clear")
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, refusal))
    assert teacher.topics[:2] == ["refuse.collision", "told.corrected_before"]
    assert "way lower" in phrase(teacher.lines[1])
    # The same again has another cause.
    teacher.hear(acts.Start())
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, refusal))
    assert "told.corrected_before" not in teacher.topics


def test_who_points_is_told_what_the_robot_cannot_see() -> None:
    teacher = Lessons().ready().hear(acts.Unknown(), text="put the block over there")
    assert teacher.topics == ["told.cannot_see", "ask.ready_slow"]


def test_a_name_may_be_told_with_the_yes_to_saving() -> None:
    teacher = Lessons().ready().hear(acts.Quit(), text="bye")
    teacher.hear(acts.Affirm(), text="yes as peg1", sure=0.6)
    (keeping,) = (one for one in teacher.effects if isinstance(one, fx.Keep))
    assert keeping.name == "peg1"


def test_why_the_arm_stands_is_told_truly() -> None:
    teacher = Lessons().ready().moving().report("primitive", 0)
    teacher.report("unmet", 0, text="held", object="block", when="until")
    teacher.hear(acts.Explain("why did you stop"), text="why did you stop")
    assert teacher.topics == ["explain.unmet_until.held"]
    told = phrase(teacher.lines[0])
    assert told.startswith('I stopped because "approach object" was to end when')
    stopped = Lessons().ready().moving().hear(acts.Stop(), text="stop")
    stopped.hear(acts.Explain("why did you stop"), text="why did you stop")
    assert phrase(stopped.lines[0]) == "I stopped because you said stop."


def test_another_name_right_after_saving_is_that_of_the_version() -> None:
    teacher = Lessons().ready().hear(acts.Save("one"), text="save it as one")
    teacher.happen(ev.Kept("one"))
    assert "done.saved" in teacher.topics
    teacher.hear(acts.Deny(), text="no, call it tower two")
    (keeping,) = (one for one in teacher.effects if isinstance(one, fx.Keep))
    assert keeping.name == "tower two"


def test_a_speed_that_limits_do_not_allow_is_told() -> None:
    teacher = Lessons().ready().hear(acts.AdjustSpeed("faster", factor=2.9), text="2.9 times")
    teacher.dialogue = replace(teacher.dialogue, pace="normal")
    teacher.hear(acts.Start())
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, None, 9.0)).finish()
    assert "it would be 3 s, but my limits do not allow that" in phrase(teacher.lines[0])
    teacher = Lessons().ready().moving().finish()
    assert "limits" not in phrase(teacher.lines[0])


@pytest.mark.parametrize("text", ["a random new one", "just a random one please", "at random"])
def test_just_any_arrangement_is_drawn(text: str) -> None:
    teacher = Lessons().ready().hear(acts.Start(), text=text, sure=0.5)
    (effect,) = (one for one in teacher.effects if isinstance(one, fx.Arrange))
    assert effect.random
    assert not teacher.did(fx.Move)
