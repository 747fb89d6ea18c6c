"""A hand that closed above or beside a thing of known size is told with how far."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue import events as ev
from assistant.dialogue.bodies import with_body
from assistant.model import teacher_acts as acts
from assistant.model.setup import Place, Setup
from tests.dialogue.teaching import SCENE, SETUP, Lessons, demonstration, lesson


def shown(xyz_mm: tuple[float, float, float], *, told: bool = True) -> Lessons:
    """Show a grasp of a block that stands that far from where the hand closed."""
    teacher = Lessons().confirmed().hear(acts.Start()).hear(acts.Approve())
    if told:
        known = with_body(teacher.dialogue.known, "block", "box", (60.0, 42.0, 100.0))
        teacher.dialogue = replace(teacher.dialogue, known=known)
    base = SCENE.body_pose("block", SETUP.places["block"])[:3] * 1000.0
    at = [float(one) - by for one, by in zip(base, xyz_mm, strict=True)]
    place = Place("body", (at[0], at[1], at[2]))
    setup = Setup(places={**SETUP.places, "block": place})
    teacher.happen(ev.Shown(replace(demonstration(), setup=setup)))
    return teacher.happen(ev.Learned(lesson()))


@pytest.mark.parametrize(
    ("off_mm", "topic"),
    [((0.0, 0.0, 98.0), "missed_above"), ((0.0, 60.0, 0.0), "missed_beside")],
)
def test_fingers_beyond_the_thing_held_nothing(
    off_mm: tuple[float, float, float], topic: str
) -> None:
    teacher = shown(off_mm)
    assert teacher.topics == [f"error.{topic}", "ask.ready_to_watch"]
    told = {"missed_above": 58, "missed_beside": 40}[topic]
    assert teacher.lines[0].slots["mm"] == pytest.approx(told, abs=1.0)
    assert teacher.dialogue.known.demonstrations == ()


@pytest.mark.parametrize("off_mm", [(0.0, 0.0, 0.0), (20.0, 10.0, 30.0)])
def test_fingers_around_the_thing_are_believed(off_mm: tuple[float, float, float]) -> None:
    assert shown(off_mm).topics[0] == "read_back.episodes"


def test_of_a_thing_nobody_told_the_size_of_nothing_is_said() -> None:
    assert shown((0.0, 0.0, 98.0), told=False).topics[0] == "read_back.episodes"
