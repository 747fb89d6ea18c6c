"""Corrections: how far, in which frame, told in words, adjusted, taken back."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.machine import public_view
from assistant.dialogue.sketch import Sketch, inserted
from assistant.geometry import rotate_vector
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.feedback import Feedback
from assistant.model.motion import ArmReport
from assistant.model.task import Action
from tests.dialogue.teaching import SCENE, Lessons


def corrected(*meant: acts.TeacherAct, facing: str = "beside you") -> Lessons:
    teacher = Lessons().ready().run()
    for act in meant:
        teacher.hear(act, text="as I say")
        if teacher.asked == "facing":
            teacher.hear(acts.Inform(facing), text=facing)
    return teacher


def last(teacher: Lessons) -> Feedback:
    lesson = teacher.dialogue.known.lesson
    assert lesson is not None
    return lesson.feedback[-1]


@pytest.mark.parametrize(
    ("act", "lost"),
    [
        (acts.Translate("left"), 5.0),
        (acts.Translate("up"), None),
        (acts.Translate("forward"), None),
        (acts.Rotate("left"), 3.0),
        (acts.Rotate("up"), None),
    ],
)
def test_what_closing_fingers_take_away_is_told_with_the_correction(
    act: acts.Translate | acts.Rotate, lost: float | None
) -> None:
    where = acts.Where("grasp object", "during")
    teacher = corrected(replace(act, where=where))
    (told,) = (one for one in teacher.lines if one.act == "done")
    assert told.slots.get("squeezed") == lost
    for language in ("english", "german"):
        assert ("finger" in phrase(told, language).lower()) == (lost is not None)
    # Where it is let go, the hand takes along what it holds.
    placed = corrected(replace(act, where=acts.Where("place object on target", "during")))
    assert not any(one.slots.get("squeezed") for one in placed.lines)


def world(teacher: Lessons, feedback: Feedback) -> Any:
    place = teacher.dialogue.known.setup.places[feedback.frame]
    quat = SCENE.hand_pose(feedback.frame, place)[3:]
    told = feedback.offset_m if feedback.kind == "translate" else feedback.turn_rad
    return rotate_vector(quat, np.array(told))


@pytest.mark.parametrize(
    ("direction", "unit"),
    [
        ("left", (0, 1, 0)),
        ("right", (0, -1, 0)),
        ("up", (0, 0, 1)),
        ("down", (0, 0, -1)),
        ("forward", (1, 0, 0)),
        ("backward", (-1, 0, 0)),
    ],
)
@pytest.mark.parametrize(("degree", "length"), [(None, 5.0), ("little", 2.0), ("much", 15.0)])
def test_steps_are_as_told_in_the_robots_own_directions(
    direction: Any, unit: tuple[int, ...], degree: Any, length: float
) -> None:
    teacher = corrected(acts.Translate(direction, degree))
    assert world(teacher, last(teacher)) * 1000 == pytest.approx(np.array(unit) * length)


def test_a_facing_teachers_left_is_the_robots_right_and_up_stays_up() -> None:
    teacher = corrected(acts.Translate("left"), facing="I am facing you")
    assert world(teacher, last(teacher))[1] == pytest.approx(-0.005)
    teacher.hear(acts.Translate("up"))
    assert world(teacher, last(teacher))[2] == pytest.approx(0.005)
    assert "left" in phrase(corrected(acts.Translate("left"), facing="facing you").lines[1])


@pytest.mark.parametrize(
    ("direction", "axis"),
    [("left", (0, 0, 1)), ("right", (0, 0, -1)), ("forward", (0, 1, 0)), ("backward", (0, -1, 0))],
)
def test_turns_about_the_world(direction: Any, axis: tuple[int, ...]) -> None:
    teacher = corrected(acts.Rotate(direction, angle_deg=6.0))
    assert np.degrees(world(teacher, last(teacher))) == pytest.approx(np.array(axis) * 6.0)


@pytest.mark.parametrize(
    ("direction", "axis"),
    [("up", (0, -1, 0)), ("down", (0, 1, 0)), ("clockwise", (1, 0, 0))],
)
def test_turns_about_the_hand_are_in_its_own_axes(direction: Any, axis: tuple[int, ...]) -> None:
    teacher = corrected(acts.Rotate(direction))
    assert np.degrees(last(teacher).turn_rad) == pytest.approx(np.array(axis) * 3.0)


def test_at_rest_a_correction_belongs_to_the_release_and_moves_with_the_target() -> None:
    feedback = last(corrected(acts.Translate("up")))
    assert (feedback.frame, feedback.primitive) == ("target", "place object on target")
    assert feedback.words == "as I say"


def test_while_a_primitive_runs_a_correction_belongs_to_it() -> None:
    teacher = Lessons().ready().moving().report("primitive", 0).hear(acts.Translate("up"))
    assert (last(teacher).frame, last(teacher).primitive) == ("block", "approach object")
    assert teacher.topics[-1] == "told.next_time"
    assert not any(isinstance(one, fx.Move | fx.GoOn | fx.Check) for one in teacher.effects)


def test_words_may_say_where_a_correction_belongs() -> None:
    where = acts.Where("grasp object", "before")
    feedback = last(corrected(acts.Translate("up", where=where)))
    assert (feedback.frame, feedback.primitive, feedback.when) == (
        "block",
        "grasp object",
        "before",
    )
    inner = last(corrected(acts.Translate("up", where=acts.Where("place it"))))
    assert inner.primitive == "place object on target"


def test_large_and_spoken_numbers_are_read_back_before_they_count() -> None:
    teacher = corrected(acts.Translate("up", distance_m=0.03))
    assert teacher.asked == "did_you_mean"
    assert public_view(teacher.dialogue)["feedback"] == []
    teacher.hear(acts.Affirm())
    assert last(teacher).offset_m[2] == pytest.approx(0.03)
    spoken = Lessons().ready().run().hear(acts.Translate("up", distance_m=0.004), voice=True)
    assert spoken.asked == "did_you_mean"
    assert corrected(acts.Rotate("left", angle_deg=12.0)).asked == "did_you_mean"
    assert corrected(acts.Translate("up", distance_m=0.02)).asked == "ready"


def test_steps_shrink_when_the_teacher_goes_back_and_forth() -> None:
    teacher = corrected(*[acts.Translate(one) for one in ("up", "down", "up", "down")])
    lesson = teacher.dialogue.known.lesson
    assert lesson is not None
    heights = [1000.0 * one.offset_m[2] for one in lesson.feedback]
    assert heights == pytest.approx([5.0, -2.5, 1.25, -0.625])


def test_the_last_correction_is_adjusted() -> None:
    teacher = corrected(acts.Translate("up"), acts.AdjustLast(factor=0.5))
    assert last(teacher).offset_m[2] == pytest.approx(0.0025)
    teacher.hear(acts.AdjustLast("opposite"))
    assert last(teacher).offset_m[2] == pytest.approx(-0.0025)
    teacher.hear(acts.AdjustLast("more"))
    assert len(public_view(teacher.dialogue)["feedback"]) == 2
    assert "5 mm in all" in phrase(teacher.lines[0])


def test_speed_changes_by_a_fifth_and_stays_in_bounds() -> None:
    teacher = corrected(acts.AdjustSpeed("faster"))
    assert public_view(teacher.dialogue)["speed"] == pytest.approx(1.2)
    teacher.hear(acts.AdjustSpeed("slower", "little"))
    assert public_view(teacher.dialogue)["speed"] == pytest.approx(1.08)
    teacher.hear(acts.AdjustSpeed(factor=0.5))
    assert public_view(teacher.dialogue)["speed"] == pytest.approx(0.54)
    # What goes too far goes as far as may be, and is told; from there it goes no further.
    for factor, bound in ((0.01, 0.1), (300.0, 3.0)):
        teacher.hear(acts.AdjustSpeed(factor=factor))
        assert "told.speed_limit" in teacher.topics
        assert public_view(teacher.dialogue)["speed"] == pytest.approx(bound)
        teacher.hear(acts.AdjustSpeed(factor=factor))
        assert teacher.topics[0] == "refuse.speed_bounds"
        assert public_view(teacher.dialogue)["speed"] == pytest.approx(bound)
    teacher.hear(acts.Undo()).hear(acts.Undo())
    assert public_view(teacher.dialogue)["speed"] == pytest.approx(0.54)


def test_opening_above_a_surface_is_confirmed_with_the_height() -> None:
    teacher = Lessons().ready().moving().report("primitive", 2)
    teacher.hear(acts.Stop())
    report = ArmReport("halted", 3.0, 2, "stop", "block", height_mm=84.2)
    teacher.happen(ev.ArmReported(report))
    teacher.hear(acts.Gripper("open"))
    assert teacher.asked == "did_you_mean"
    assert "84 mm" in phrase(teacher.lines[0])
    assert not teacher.did(fx.SetHand)
    assert teacher.hear(acts.Affirm()).effects[-1] == fx.SetHand("open")


def test_a_question_keeps_what_came_with_it() -> None:
    teacher = Lessons().ready().run()
    teacher.hear(acts.Again(), acts.Translate("left"), text="again, more left")
    assert teacher.asked == "facing"
    assert not teacher.did(fx.Check)
    teacher.hear(acts.Inform("facing you"), text="facing you")
    assert teacher.did(fx.Check)
    check = next(one for one in teacher.effects if isinstance(one, fx.Check))
    assert check.task.learned is not None
    assert len(check.task.learned.feedback) == 1


def test_whoever_does_not_say_where_they_stand_stands_as_the_robot_looks() -> None:
    teacher = Lessons().ready().run().hear(acts.Translate("left")).hear(acts.Again())
    assert public_view(teacher.dialogue)["facing"] == "own"
    assert teacher.did(fx.Check)


directions = st.sampled_from(["left", "right", "up", "down", "forward", "backward"])


@settings(max_examples=30, deadline=None, derandomize=True)
@given(st.lists(directions, min_size=1, max_size=6))
def test_every_correction_is_undone_singly_and_comes_back(told: list[Any]) -> None:
    teacher = corrected(*[acts.Translate(one) for one in told])
    given_back = public_view(teacher.dialogue)["feedback"]
    for _ in told:
        teacher.hear(acts.Undo())
        if public_view(teacher.dialogue)["undo"] == "facing":
            break
    for _ in told:
        teacher.hear(acts.Redo())
    assert public_view(teacher.dialogue)["feedback"] == given_back
    assert all(math.isfinite(one) for one in last(teacher).offset_m)


def test_the_action_spoken_of_tells_where_a_correction_belongs() -> None:
    teacher = Lessons().ready().run()
    teacher.hear(acts.Translate("down", "little"), text="grasp it a bit lower")
    assert (last(teacher).frame, last(teacher).primitive) == ("block", "grasp object")
    teacher.hear(acts.Translate("down", "little"), text="a bit lower")
    assert last(teacher).frame == "target"


def test_a_thing_stands_for_the_step_in_which_the_hand_acts_at_it() -> None:
    teacher = corrected(acts.Translate("up", where=acts.Where("block", "during")))
    assert last(teacher).primitive == "grasp object"


def test_no_to_a_large_change_leaves_all_as_it_was() -> None:
    teacher = corrected(acts.Translate("up", distance_m=0.03)).hear(acts.Deny())
    assert teacher.topics[0] == "told.as_it_was"
    assert public_view(teacher.dialogue)["feedback"] == []


def test_a_step_meant_instead_may_be_told_by_what_is_done_in_it() -> None:
    teacher = Lessons().ready()
    where = acts.Where("grasp object", "before")
    teacher.hear(acts.Translate("up", where=where), text="higher before you grasp it")
    teacher.hear(acts.Deny(), text="no, I meant when you place it")
    (given,) = public_view(teacher.dialogue)["feedback"]
    assert given["primitive"] == "place object on target"


def test_an_undo_of_what_was_changed_in_place_names_the_last_words() -> None:
    teacher = Lessons().ready().hear(acts.Translate("up"), text="up")
    teacher.hear(acts.AdjustLast("less"), text="half of that").hear(acts.Undo(), text="undo")
    assert phrase(teacher.lines[0]) == 'I took back the last correction: "up, half of that".'
    teacher.hear(acts.Redo(), text="redo")
    assert phrase(teacher.lines[0]) == 'I brought back the last correction: "up, half of that".'


def test_when_you_place_it_is_where_the_hand_lets_go_and_not_as_it_leaves() -> None:
    teacher = Lessons().ready()
    known = teacher.dialogue.known
    leaving = Sketch("move back", True, (), action=Action("move", "backward"))
    more = replace(known, root=inserted(known.root, (2,), 3, leaving))
    teacher = Lessons(replace(teacher.dialogue, known=more))
    teacher.hear(acts.Translate("up", where=acts.Where("place object", "during")))
    assert last(teacher).primitive == "place object on target"
    teacher.hear(acts.Translate("up", where=acts.Where("move back", "during")))
    assert last(teacher).primitive == "move back"


@pytest.mark.parametrize(
    "text", ["carry it higher", "higher on the way", "carry the block 2 cm higher"]
)
def test_what_is_corrected_on_the_way_leaves_the_release_where_it_was(text: str) -> None:
    teacher = Lessons().ready().run().hear(acts.Translate("up"), text=text)
    assert (last(teacher).primitive, last(teacher).when) == ("place object on target", "before")
    assert 'before "place object on target"' in phrase(teacher.lines[0])


def test_a_correction_of_no_way_is_one_of_the_release() -> None:
    teacher = Lessons().ready().run().hear(acts.Translate("up"), text="put it down higher")
    assert last(teacher).when == "during"
