"""What the robot says would help is done on a word, or by its own words."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue import events as ev
from assistant.dialogue.spots import spot
from assistant.model import teacher_acts as acts
from assistant.model.motion import Refusal
from assistant.model.scene import Body, Obstacle
from assistant.model.setup import Place
from tests.dialogue.teaching import Lessons

TABLE = Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0))


def refused(refusal: Refusal, base: Place | None = None) -> Lessons:
    teacher = Lessons().ready()
    known = teacher.dialogue.known
    if base is not None:
        places = {**known.setup.places, "block": base}
        bodies = {**known.scene.bodies, "block": Body("block", size_mm=(60.0, 40.0, 100.0))}
        known = replace(
            known,
            setup=replace(known.setup, places=places),
            scene=replace(known.scene, bodies=bodies),
        )
    known = replace(known, scene=replace(known.scene, tables=(TABLE,)))
    teacher.dialogue = replace(teacher.dialogue, known=known)
    teacher.hear(acts.Start())
    return teacher.happen(ev.Checked(teacher.dialogue.known.setup, refusal))


FAR = Refusal("reach", "grasp of block", amount=56.0, unit="mm", hint="closer", by=75.0)


@pytest.mark.parametrize("text", ["do that", "bring it 75 mm closer", "ok, that is so"])
def test_what_was_advised_is_done_for_who_says_so(text: str) -> None:
    teacher = refused(FAR)
    before = teacher.dialogue.known.setup.places["block"].xyz_mm
    teacher.hear(acts.Unknown(), text=text)
    after = teacher.dialogue.known.setup.places["block"].xyz_mm
    assert teacher.topics[0].startswith("read_back.")
    far = [sum(one**2 for one in place[:2]) ** 0.5 for place in (before, after)]
    assert far[0] - far[1] == pytest.approx(75.0, abs=0.2)


@pytest.mark.parametrize(
    "text", ["bring it 20 mm closer?", "do that later in the evening when it is dark"]
)
def test_other_talk_follows_no_advice(text: str) -> None:
    teacher = refused(FAR).hear(acts.Unknown(), text=text)
    assert not teacher.topics[0].startswith("read_back.setup")


def test_advice_for_another_arrangement_is_not_followed() -> None:
    teacher = refused(FAR)
    known = teacher.dialogue.known
    other = replace(known.setup, name="another")
    teacher.dialogue = replace(teacher.dialogue, known=replace(known, setup=other))
    teacher.hear(acts.Unknown(), text="do that")
    assert not teacher.topics[0].startswith("read_back.")


def test_what_is_in_the_way_is_cleared_to_a_free_place() -> None:
    teacher = refused(Refusal("setup", "block", "target", hint="clear"))
    place = spot(teacher.dialogue.known, "target")
    teacher.hear(acts.Unknown(), text="clear the way")
    assert teacher.topics[0] == "read_back.setup"
    assert teacher.dialogue.known.setup.places["target"] == place


@pytest.mark.parametrize(("z_mm", "follows"), [(215.0, True), (240.0, False)])
def test_nothing_is_put_into_the_air(z_mm: float, follows: bool) -> None:
    higher = Refusal("collision", "grasp of block", "table", hint="higher", by=25.0)
    base = Place("body", (500.0, 200.0, z_mm))
    teacher = refused(higher, base).hear(acts.Unknown(), text="do that")
    after = teacher.dialogue.known.setup.places["block"]
    assert after.xyz_mm[2] == (240.0 if follows else z_mm)
