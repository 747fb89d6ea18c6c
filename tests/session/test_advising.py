"""What is advised where a setup is refused does help, or it is said that nothing does."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.dialogue.advice import concerned, moved
from assistant.dialogue.reporting import refusal_line
from assistant.language.speech import phrase
from assistant.learning.adaptation import adapt, plan_adaptation
from assistant.model.bearing import stands
from assistant.model.motion import Refusal
from assistant.model.robot_acts import RobotAct
from assistant.model.scene import Body, Obstacle, Scene
from assistant.model.setup import Place, Setup
from assistant.session.advising import NOTHING, advised
from sim.planner import A465Planner
from tests.session.test_practice import learned
from tests.sim.hand_paths import scene, setup

PLAN = plan_adaptation(learned("pick_and_place"))
PLANNER = A465Planner()


def refused(told: Setup, where: Scene | None = None) -> Refusal | None:
    found = PLANNER.plan(adapt(PLAN, where or scene(), told), where or scene(), told)
    return found if isinstance(found, Refusal) else None


def scattered(random: np.random.Generator) -> Setup:
    spots = []
    for side in (1.0, -1.0):
        radius, azimuth = random.uniform(250.0, 800.0), side * random.uniform(0.3, 1.4)
        x, y = radius * np.cos(azimuth), radius * np.sin(azimuth)
        spots.append((float(x), float(y), float(random.uniform(300.5, 420.0))))
    yaws = random.uniform(-180.0, 180.0, 2)
    return setup(spots[0], float(yaws[0]), spots[1], float(yaws[1]))


@pytest.mark.parametrize("seed", range(8))
def test_following_the_advice_helps_or_there_is_none(seed: int) -> None:
    told = scattered(np.random.default_rng(seed))
    why = refused(told)
    if why is None:
        return
    advice = advised(why, PLAN, scene(), told, PLANNER)
    thing = concerned(advice, told)
    assert thing
    if advice.hint == NOTHING:
        assert advice.by == 0.0
        return
    left = refused(moved(told, thing, advice.hint, advice.by))
    # It can be done then, or only the other thing is left to blame.
    assert left is None or not left.where.endswith(thing)


def test_a_thing_told_in_the_table_is_to_be_put_higher() -> None:
    told = setup((500.0, 240.0, 280.0), 20.0, (500.0, -240.0, 300.0), -20.0)
    why = refused(told)
    assert why is not None
    advice = advised(why, PLAN, scene(), told, PLANNER)
    assert advice.hint == "higher"
    assert advice.by == pytest.approx(20.0)
    assert stands(scene(), moved(told, "block", "higher", advice.by), "block")


def test_what_stands_in_the_way_is_to_be_cleared_only_if_that_helps() -> None:
    post = Obstacle("post", (30.0, 30.0, 300.0), (640.0, -250.0, 240.0))
    told = setup((500.0, 240.0, 300.0), 20.0, (500.0, -240.0, 300.0), -20.0)
    why = refused(told, scene(post))
    assert why is not None
    assert why.what == "post"
    assert advised(why, PLAN, scene(post), told, PLANNER).hint == "clear"
    leaning = replace(why, hint="clear", what="table", where="grasp of block")
    assert advised(leaning, PLAN, scene(post), told, PLANNER).hint != "clear"


def test_a_robot_that_starts_out_of_reach_is_to_start_closer() -> None:
    told = replace(
        setup((500.0, 240.0, 300.0), 20.0, (500.0, -240.0, 300.0), -20.0),
        robot_start=Place("hand", (760.0, 0.0, 500.0)),
    )
    why = refused(told)
    assert why is not None
    assert why.where == "start"
    advice = advised(why, PLAN, scene(), told, PLANNER)
    assert advice.hint == "closer"
    assert refused(moved(told, "start", "closer", advice.by)) is None


@pytest.mark.parametrize(
    ("language", "told"),
    [("english", "bring it 50 mm closer"), ("german", "50 mm näher heran zu rücken")],
)
def test_how_far_is_told(language: str, told: str) -> None:
    slots = {"where": "grasp of block", "hint": "closer", "by": 50}
    assert told.lower() in phrase(RobotAct("refuse", "reach.only", slots=slots), language).lower()
    without = phrase(RobotAct("refuse", "reach.only", slots=slots | {"by": None}), language)
    assert "50" not in without


def test_the_longest_name_is_meant() -> None:
    bodies = {name: Body(name) for name in ("cup", "red cup")}
    places = {name: Place("body", (500.0, 0.0, 240.0)) for name in bodies}
    why = Refusal("reach", "grasp of red cup")
    assert concerned(why, Setup(places=places)) == "red cup"


def test_what_is_too_low_for_the_hand_is_to_stand_higher() -> None:
    low = Body("block", size_mm=(60.0, 40.0, 40.0), grasp_xyz_mm=(-134.1, 0.0, 30.0))
    where = replace(scene(), bodies={**scene().bodies, "block": low})
    told = setup((500.0, 240.0, 270.0), 20.0, (500.0, -240.0, 300.0), -20.0)
    why = refused(told, where)
    assert why is not None
    assert (why.reason, why.what, why.hint) == ("collision", "table", "higher")
    assert advised(why, PLAN, where, told, PLANNER).hint == "higher"


@pytest.mark.parametrize("language", ["english", "german"])
def test_a_way_that_slides_in_from_the_side_is_to_be_shown_from_above(language: str) -> None:
    refusal = Refusal("collision", "way to target", "target", 1.0, "mm", hint="from_above")
    told = phrase(refusal_line("refuse", refusal), language)
    assert ("I will show it again" if language == "english" else "ich zeige es noch einmal") in told
