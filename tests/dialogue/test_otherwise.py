"""Who meant the other one gets the other one: of two steps, of two things, of two readings."""

from __future__ import annotations

import pytest

from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import Lessons, lesson

OTHER = "no, I meant the other one"


def test_a_correction_goes_to_the_other_of_two_places() -> None:
    teacher = Lessons().ready().run().hear(acts.Translate("up", "little"), text="a bit up")
    assert teacher.dialogue.known.lesson is not None
    first = teacher.dialogue.known.lesson.feedback[-1].primitive
    teacher.hear(acts.Deny(), text=OTHER)
    assert teacher.topics[:2] == ["done.undone", "done.translate"]
    (kept,) = teacher.dialogue.known.lesson.feedback
    assert {first, kept.primitive} == {"grasp object", "place object on target"}
    back = teacher.hear(acts.Deny(), text=OTHER).dialogue.known.lesson
    assert back is not None
    assert [one.primitive for one in back.feedback] == [first]


def test_a_place_goes_to_the_other_of_two_things() -> None:
    teacher = Lessons().ready().hear(acts.Inform("beside you"), text="I stand beside you")
    before = teacher.dialogue.known.setup.places
    teacher.hear(acts.SetPose("block", by_mm=(0.0, 50.0, 0.0)), text="it is 5 cm further left")
    teacher.hear(acts.Deny(), text=OTHER)
    after = teacher.dialogue.known.setup.places
    assert after["block"] == before["block"]
    assert after["target"] != before["target"]


def test_the_other_of_two_steps_is_taken() -> None:
    teacher = Lessons().introduce()
    teacher.hear(acts.Optional("move"), text="you can skip moving")
    assert teacher.asked == "which"
    one, two = teacher.lines[-1].slots["names"]
    teacher.hear(acts.Inform(one), text=one)
    assert teacher.topics[0] == "done.optional"
    teacher.hear(acts.Deny(), text=OTHER)
    (told,) = (line for line in teacher.lines if line.topic == "optional")
    assert told.slots["name"] == two


def test_the_second_reading_of_a_guess_is_read_back() -> None:
    teacher = Lessons().ready().hear(acts.Affirm(), text="right")
    assert teacher.lines[0].slots["acts"][0]["act"] == "translate"
    teacher.hear(acts.Deny(), text=OTHER)
    assert teacher.topics == ["confirm.did_you_mean"]
    assert teacher.lines[0].slots["acts"][0]["act"] == "affirm"


def test_without_another_it_is_an_ordinary_no() -> None:
    teacher = Lessons().ready().run().hear(acts.Deny(), text=OTHER)
    assert teacher.topics == ["told.what_to_change"]


def test_a_correction_goes_to_the_step_that_is_named_instead() -> None:
    teacher = Lessons().ready().run().hear(acts.Translate("up", "little"), text="a bit up")
    teacher.hear(acts.Deny(), text="no, I meant grasp object")
    (kept,) = (teacher.dialogue.known.lesson or lesson()).feedback
    assert kept.primitive == "grasp object"


def test_a_no_to_one_of_two_readings_reads_the_other_back() -> None:
    teacher = Lessons().ready().hear(acts.Affirm(), text="right").hear(acts.Deny(), text="no")
    assert teacher.topics == ["confirm.did_you_mean"]
    assert teacher.lines[0].slots["acts"][0]["act"] == "affirm"


def test_another_direction_was_meant() -> None:
    teacher = Lessons().ready().run()
    teacher.hear(acts.Translate("up", None, 0.004), text="4 mm up")
    teacher.hear(acts.Deny(), acts.Translate("down"), text="no, I meant down", sure=0.5)
    assert teacher.topics[:2] == ["done.undone", "done.translate"]
    assert teacher.dialogue.known.lesson is not None
    (kept,) = teacher.dialogue.known.lesson.feedback
    assert kept.offset_m[2] == pytest.approx(-0.004)
    assert kept.words == "4 mm up; no, I meant down"


def test_another_turn_and_another_pace_were_meant() -> None:
    teacher = Lessons().ready().run()
    teacher.hear(acts.Rotate("up", None, 10.0), text="tilt up ten degrees")
    teacher.hear(acts.Deny(), text="no, I meant down", sure=0.5)
    assert teacher.lines[1].slots["size"] == pytest.approx(10.0)
    teacher.hear(acts.AdjustSpeed("slower"), text="slower")
    teacher.hear(acts.Deny(), text="no, I meant faster", sure=0.5)
    assert teacher.topics[:2] == ["done.undone", "done.faster"]


def test_a_no_before_a_guess_is_no_part_of_it() -> None:
    teacher = Lessons().ready().run()
    teacher.hear(acts.Deny(), acts.Translate("up"), text="no hup", sure=0.4)
    assert [one["act"] for one in teacher.lines[-1].slots["acts"]] == ["translate"]
