"""Words about a thing move the thing where only that can be meant; else the robot asks."""

from __future__ import annotations

from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import Lessons

FAR = acts.Translate("left", distance_m=0.1)


def ready() -> Lessons:
    return Lessons().ready().hear(acts.Inform("beside you"), text="I am standing beside you")


def test_a_target_that_is_put_elsewhere_stands_elsewhere() -> None:
    teacher = ready()
    before = teacher.dialogue.known.setup.places["target"].xyz_mm
    teacher.hear(FAR, text="put the target ten centimetres further left")
    assert teacher.topics == ["read_back.place"]
    after = teacher.dialogue.known.setup.places["target"].xyz_mm
    assert after == (before[0], before[1] + 100.0, before[2])


def test_what_is_carried_may_be_meant_either_way() -> None:
    text = "put the block ten centimetres further left"
    teacher = ready().hear(FAR, text=text)
    assert teacher.topics == ["confirm.stands_elsewhere"]
    before = teacher.dialogue.known.setup.places["block"].xyz_mm[1]
    moved = Lessons(teacher.dialogue).hear(acts.Affirm(), text="yes").dialogue.known
    assert moved.setup.places["block"].xyz_mm[1] == before + 100.0
    teacher.hear(acts.Deny(), text="no")
    assert teacher.topics == ["confirm.did_you_mean"]
    corrected = teacher.hear(acts.Affirm(), text="yes").dialogue.known
    assert corrected.setup.places["block"].xyz_mm[1] == before
    assert corrected.lesson is not None
    assert len(corrected.lesson.feedback) == 1


def test_a_correction_stays_one() -> None:
    for text in ("place it ten centimetres further left", "ten centimetres left"):
        assert ready().hear(FAR, text=text).topics == ["confirm.large"]
    near = acts.Translate("left", distance_m=0.01)
    assert ready().hear(near, text="put the block 1 cm left").topics[0] == "done.translate"


def test_where_the_teacher_stands_is_asked_before_a_thing_is_put_to_the_left() -> None:
    teacher = Lessons().ready().hear(FAR, text="move the target 10 cm to the left")
    assert teacher.asked == "facing"
    before = teacher.dialogue.known.setup.places["target"].xyz_mm[1]
    teacher.hear(acts.Inform("facing you"), text="facing you")
    assert teacher.dialogue.known.setup.places["target"].xyz_mm[1] == before - 100.0


def test_a_target_put_a_bit_aside_is_asked_about() -> None:
    near = acts.Translate("right", "little")
    teacher = ready().hear(near, text="move the target a bit to the right")
    assert teacher.topics == ["confirm.stands_elsewhere"]
    before = teacher.dialogue.known.setup.places["target"].xyz_mm[1]
    teacher.hear(acts.Affirm(), text="yes")
    assert teacher.dialogue.known.setup.places["target"].xyz_mm[1] == before - 20.0
    assert (
        ready().hear(near, text="move the block a bit to the right").topics[0] == "done.translate"
    )
