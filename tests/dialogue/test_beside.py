"""Setups by talk: beside other things, nearer, turned further, put back as shown."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.knowledge import Knowledge
from assistant.geometry import pose_to_mm_deg
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.motion import Refusal
from assistant.model.setup import Place
from tests.dialogue.teaching import SCENE, SETUP, Lessons, moved


def at_mm(known: Knowledge, thing: str) -> np.ndarray:
    """Return where the middle of a thing's base is."""
    xyz, _ = pose_to_mm_deg(known.scene.body_pose(thing, known.setup.places[thing]))
    return np.asarray(xyz)


def told(text: str, facing: str = "beside you", teacher: Lessons | None = None) -> Lessons:
    """Return a lesson in which a teacher who stands somewhere says something at rest."""
    lesson = teacher or Lessons().ready()
    lesson.hear(acts.Unknown(), text=text, sure=0.4)
    if lesson.asked == "facing":
        lesson.hear(acts.Inform(facing), text=facing)
    return lesson


@pytest.mark.parametrize(
    ("text", "facing", "away"),
    [
        ("put the block 10 cm left of the target", "beside you", (0, 100)),
        ("put the block 10 cm left of the target", "facing you", (0, -100)),
        ("the block is 20 cm in front of the target", "beside you", (-200, 0)),
        ("the block is 20 cm in front of the target", "facing you", (200, 0)),
        ("put the block 20 cm behind the target", "beside you", (200, 0)),
        ("put the block next to the target", "beside you", (0, 110)),
    ],
)
def test_a_thing_is_put_beside_another(text: str, facing: str, away: tuple[int, int]) -> None:
    teacher = told(text, facing)
    known = teacher.dialogue.known
    gap = at_mm(known, "block") - at_mm(known, "target")
    assert gap[:2] == pytest.approx(away, abs=0.1)
    before = Lessons().ready().dialogue.known
    assert at_mm(known, "block")[2] == pytest.approx(at_mm(before, "block")[2], abs=0.1)
    assert teacher.did(fx.Arrange)
    assert teacher.did(fx.Check)
    assert not teacher.did(fx.Move)
    assert "the target" in phrase(teacher.lines[-1])


def test_it_is_told_whether_the_new_place_is_within_reach() -> None:
    teacher = told("put the block next to the target")
    there = teacher.dialogue.known.setup
    refused = Refusal("reach", where="grasp of block", amount=87.0, unit="mm", hint="closer")
    teacher.happen(ev.Checked(there, refused))
    assert teacher.topics == ["refuse.reach.only", "ask.ready_refused"]
    told("put the block 20 cm left of the target", teacher=teacher)
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, None, 9.0))
    assert teacher.topics == ["ask.ready_slow"]
    assert phrase(teacher.lines[0]).startswith("I can reach everything there.")
    assert teacher.dialogue.refusal is None


def test_nearer_is_nearer_to_the_robot_wherever_the_teacher_stands() -> None:
    for facing in ("beside you", "facing you"):
        teacher = told("more left please", facing)
        teacher.hear(acts.Translate("left"), text="left")
        teacher.hear(acts.Inform(facing), text=facing)
        before = at_mm(teacher.dialogue.known, "block")
        told("the block is 5 cm closer to you", teacher=teacher)
        after = at_mm(teacher.dialogue.known, "block")
        assert np.hypot(*before[:2]) - np.hypot(*after[:2]) == pytest.approx(50.0, abs=0.1)


def test_it_is_the_thing_moved_last() -> None:
    teacher = told("the target is 5 cm closer to you")
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, None, 9.0))
    before = at_mm(teacher.dialogue.known, "target")
    told("move it 2 cm further away from you", teacher=teacher)
    after = at_mm(teacher.dialogue.known, "target")
    assert np.hypot(*after[:2]) - np.hypot(*before[:2]) == pytest.approx(20.0, abs=0.1)


def test_after_a_run_where_a_thing_is_tells_how_the_run_went() -> None:
    teacher = Lessons().ready().run()
    teacher.hear(acts.Unknown(), text="the block is to the left of the target", sure=0.4)
    assert not teacher.did(fx.Arrange)
    known = teacher.dialogue.known
    told("put the block to the left of the target", teacher=teacher)
    assert teacher.asked == "did_you_mean"
    assert teacher.dialogue.known.setup == known.setup
    teacher.hear(acts.Affirm(), text="yes")
    assert teacher.did(fx.Arrange)


def test_a_turn_by_so_much_adds_to_how_a_thing_stands() -> None:
    teacher = Lessons().ready()
    act = acts.SetPose("target", rpy_deg=(0.0, 0.0, 30.0))
    teacher.hear(act, text="turn the target by 30 degrees")
    assert teacher.dialogue.known.setup.places["target"].rpy_deg[2] == pytest.approx(120.0)
    teacher.hear(act, text="the target is turned by 30 degrees")
    assert teacher.dialogue.known.setup.places["target"].rpy_deg[2] == pytest.approx(30.0)


def test_everything_is_put_back_as_it_was_shown() -> None:
    teacher = Lessons().ready().happen(ev.Arranged(moved("two", 30.0), SCENE))
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, None, 9.0))
    told("put everything back where it was", teacher=teacher)
    assert dict(teacher.dialogue.known.setup.places) == dict(SETUP.places)
    assert teacher.did(fx.Arrange)


def test_a_place_asked_for_may_be_told_by_another_thing() -> None:
    places = {"block": SETUP.places["block"]}
    teacher = Lessons().happen(ev.Begun(SCENE, replace(SETUP, places=places)))
    teacher.tell("pick and place").tell("done").tell(("block", "target"))
    teacher.tell(("approach the block", "grasp the block", "release the block at the target"))
    while teacher.asked not in ("pose", "confirm_tree"):
        teacher.hear(acts.Inform(0), text="none")
    assert teacher.asked == "pose"
    told("20 cm right of the block", teacher=teacher)
    gap = at_mm(teacher.dialogue.known, "target") - at_mm(teacher.dialogue.known, "block")
    assert gap[:2] == pytest.approx((0, -200), abs=0.1)


def test_it_is_what_the_robot_advised_to_move() -> None:
    teacher = Lessons().ready().hear(acts.Start())
    setup = teacher.dialogue.known.setup
    refusal = Refusal("joint_limit", "release at target", "joint 3", hint="farther")
    teacher.happen(ev.Checked(setup, refusal))
    before = teacher.dialogue.known
    assert "move it farther away" in phrase(teacher.lines[0])
    told("move it farther away", teacher=teacher)
    away = np.linalg.norm(at_mm(teacher.dialogue.known, "target")[:2])
    assert away == pytest.approx(np.linalg.norm(at_mm(before, "target")[:2]) + 50.0, abs=0.1)
    assert at_mm(teacher.dialogue.known, "block") == pytest.approx(at_mm(before, "block"))


@pytest.mark.parametrize(("y_mm", "side"), [(150.0, -1.0), (-150.0, 1.0)])
def test_just_beside_is_toward_the_middle_and_asks_for_no_left(y_mm: float, side: float) -> None:
    lesson = Lessons().ready()
    known = lesson.dialogue.known
    places = {**known.setup.places, "target": Place("body", (450.0, y_mm, 240.0))}
    setup = replace(known.setup, places=places)
    lesson.dialogue = replace(lesson.dialogue, known=replace(known, setup=setup))
    lesson.hear(acts.Unknown(), text="put the block beside the target", sure=0.4)
    assert lesson.asked != "facing"
    after = lesson.dialogue.known
    gap = at_mm(after, "block") - at_mm(after, "target")
    assert (gap[0], gap[1] * side) == (pytest.approx(0.0, abs=0.1), pytest.approx(110.0, abs=0.1))
    read_back = next(one for one in lesson.lines if one.topic == "place")
    assert "cm in front of me" in phrase(read_back)
