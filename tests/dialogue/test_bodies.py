"""Bodies the teacher tells of: held where the hand has room, targets as high as what comes."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.bodies import CLEAR_MM, HELD_MM, standing, with_body
from assistant.dialogue.knowledge import Knowledge
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.scene import Obstacle, Scene
from assistant.model.setup import Place, Setup
from assistant.model.task import TaskObject
from tests.dialogue.teaching import Lessons, demonstration

KNOWN = Knowledge(objects=(TaskObject("lid", "object"), TaskObject("jar", "target")))


@pytest.mark.parametrize(
    ("tall_mm", "held_mm"), [(100.0, 60.0), (200.0, 120.0), (70.0, CLEAR_MM), (40.0, 30.0)]
)
def test_a_thing_is_held_where_the_palm_clears_the_table(tall_mm: float, held_mm: float) -> None:
    body = with_body(KNOWN, "lid", "cylinder", (60.0, 60.0, tall_mm)).scene.bodies["lid"]
    assert body.grasp_xyz_mm[2] == pytest.approx(held_mm)
    assert body.mass_kg > 0


@pytest.mark.parametrize("order", [("lid", "jar"), ("jar", "lid")])
def test_over_a_target_the_hand_is_as_high_as_it_holds_what_it_puts_there(
    order: tuple[str, str],
) -> None:
    sizes = {"lid": (60.0, 60.0, 70.0), "jar": (80.0, 80.0, 60.0)}
    known = KNOWN
    for name in order:
        known = with_body(known, name, "cylinder", sizes[name])
    jar = known.scene.bodies["jar"]
    assert jar.grasp_xyz_mm[2] == pytest.approx(60.0 + CLEAR_MM)
    assert jar.mass_kg == 0


def test_a_flat_mark_is_as_the_shipped_one() -> None:
    known = with_body(KNOWN, "jar", "box", (60.0, 40.0, 0.0))
    assert known.scene.bodies["jar"].grasp_xyz_mm[2] == HELD_MM


def test_the_session_is_shown_what_was_told() -> None:
    teacher = Lessons().open()
    teacher.tell("lid on").tell("the lid is on the jar").tell(("lid", "jar"))
    teacher.tell("a box, 6 by 6 by 7 centimetres")
    (arranged,) = (one for one in teacher.effects if isinstance(one, fx.Arrange))
    assert arranged.scene is not None
    assert "lid" in arranged.scene.bodies
    assert isinstance(arranged.scene, Scene)
    assert isinstance(arranged.setup, Setup)


def test_what_the_hand_cannot_go_around_is_told_once_it_never_closed() -> None:
    def shown(size: str) -> str:
        teacher = Lessons().open().tell("tidy").tell("the cup is away").tell("the cup").tell(size)
        teacher.hear(acts.Deny()).tell(("approach the cup", "grasp the cup", "release the cup"))
        teacher.hear(acts.Affirm()).hear(acts.Start()).hear(acts.Approve())
        teacher.happen(ev.Shown(demonstration())).happen(ev.Learned(None, "never_closed"))
        assert teacher.asked == "ready"
        return phrase(teacher.lines[0])

    assert "75 millimetres at most, and the cup is wider" in shown("8 cm wide and 7 high")
    assert "wider" not in shown("7 cm wide and 8 high")


@pytest.mark.parametrize(("size", "wide"), [("9 by 9 by 10 cm", True), ("9 by 4 by 10 cm", False)])
def test_what_is_too_wide_to_hold_is_told_at_once(size: str, wide: bool) -> None:
    teacher = Lessons().open().tell("move the drum").tell("the drum stands on the mat")
    teacher.tell(("drum", "mat"))
    assert teacher.asked == "body"
    teacher.tell(f"a box, {size}")
    assert ("told.too_wide" in teacher.topics) == wide
    # What is not carried may be as wide as it is.
    while teacher.asked == "pose":
        teacher.tell("I will show you")
    assert teacher.asked == "body"
    assert "told.too_wide" not in teacher.tell("a box, 30 by 30 by 1 cm").topics


TABLE = Obstacle("table", (900.0, 900.0, 40.0), (500.0, 0.0, 200.0))


@pytest.mark.parametrize(
    ("thing", "over_mm", "stands"),
    [
        *(("lid", over, True) for over in (-12.0, 0.0, 12.0)),
        # A thing may stand on another one; nothing is known of that.
        *(("lid", over, False) for over in (40.0, -40.0)),
        *(("jar", over, True) for over in (-12.0, 50.0)),
        ("jar", 90.0, False),
    ],
)
def test_what_the_hand_met_near_the_table_stands_on_it(
    thing: str, over_mm: float, stands: bool
) -> None:
    known = replace(KNOWN, scene=Scene(tables=(TABLE,)))
    known = with_body(known, "lid", "cylinder", (60.0, 60.0, 100.0))
    known = with_body(known, "jar", "box", (60.0, 60.0, 20.0))
    met = known.scene.hand_pose(thing, Place("body", (500.0, 100.0, 240.0 + over_mm)))
    place = standing(known, thing, met)
    base = known.scene.body_pose(thing, place)
    assert base[:2] == pytest.approx((0.5, 0.1))
    wanted = 240.0 if stands else 240.0 + over_mm
    assert 1000.0 * base[2] == pytest.approx(wanted, abs=0.01)
