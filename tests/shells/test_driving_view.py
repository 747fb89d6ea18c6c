from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from assistant.geometry import compose, inverse, pose_from_mm_deg, quat_multiply
from assistant.language.hints import page
from assistant.model.motion import ArmReport, Refusal
from assistant.model.placing import in_line
from assistant.model.scene import Scene
from assistant.model.task import TaskObject
from assistant.ports import ArmLook
from assistant.shells.driving_view import (
    NEAR_DEG,
    NEAR_MM,
    Gap,
    above_table,
    end_gap,
    gap_line,
    gaps,
    in_the_way,
    key_for,
    step_line,
    unplaced,
)
from sim.driving import TIP

WORDS = page("terminal")["driving"]
OTHERS = ("slipped", "aligned", "clear")
"""What else goes wrong when a hand is opened or closed."""


def test_the_way_is_told_in_words_and_keys(table: tuple[ArmLook, Scene]) -> None:
    look, scene = table
    block, target = gaps(look, scene, TIP)
    told = gap_line(block, WORDS, facing=False, holding=False)
    assert told.startswith("to the block   15")
    assert "forward (w)" in told
    assert "left (a)" in told
    assert "down (f)" in told
    assert "turn left 35 degrees (q)" in gap_line(target, WORDS, facing=False, holding=False)


def test_facing_the_robot_its_left_is_my_right(table: tuple[ArmLook, Scene]) -> None:
    block = gaps(*table, TIP)[0]
    told = gap_line(block, WORDS, facing=True, holding=False)
    assert "right (d)" in told
    assert "back (s)" in told
    assert "down (f)" in told
    assert key_for("d", facing=True) == "a"
    assert key_for("r", facing=True) == "r"


def test_going_the_way_told_leads_there(table: tuple[ArmLook, Scene]) -> None:
    look, scene = table
    goal = look.hand.copy()
    goal[:3] += gaps(look, scene, TIP)[0].xyz_mm / 1000.0
    there = gaps(replace(look, hand=goal), scene, TIP)[0]
    assert there.there
    assert "c closes the hand" in gap_line(there, WORDS, facing=False, holding=False)
    assert "o opens the hand" in gap_line(there, WORDS, facing=False, holding=True)
    held = gaps(replace(look, held="block"), scene, TIP)[0]
    assert "in the hand" in gap_line(held, WORDS, facing=False, holding=True)


@pytest.mark.parametrize("signs", [(1.0, 1.0, 1.0), (-1.0, 1.0, -1.0), (1.0, -1.0, 0.0)])
def test_who_is_told_to_let_go_is_in_line(
    table: tuple[ArmLook, Scene], signs: tuple[float, float, float]
) -> None:
    look, scene = table
    body = scene.bodies["block"]
    least = np.array([*signs[:2], 0.0])
    for share in (0.99, 2.0):
        off = pose_from_mm_deg(share * NEAR_MM * least, (0, 0, share * NEAR_DEG * signs[2]))
        goal = compose(look.bodies["target"], scene.bodies["target"].hand_in_body)
        tip = compose(goal, TIP)
        moved = np.concatenate([tip[:3] + off[:3], quat_multiply(off[3:], tip[3:])])
        hand = compose(moved, inverse(TIP))
        gap = gaps(replace(look, hand=hand), scene, TIP)[1]
        place = inverse(body.hand_in_body)
        lies = in_line(body, compose(hand, place), compose(goal, place), "target")
        assert gap.there is (share < 1.0)
        # Each way that is still to go is told: nobody stands before a gap that says nothing.
        assert lies if gap.there else len(gap_line(gap, WORDS, facing=False, holding=True)) > 20


def test_the_way_to_where_a_step_ended_is_told_until_the_hand_is_there(
    table: tuple[ArmLook, Scene],
) -> None:
    look, _ = table
    goal = look.hand + np.array([0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0])
    told = gap_line(end_gap(look, goal, TIP), WORDS, facing=False, holding=True)
    assert told == "to where the step ended   100 mm up (r)"
    there = gap_line(end_gap(look, look.hand, TIP), WORDS, facing=False, holding=True)
    assert there.endswith("Esc ends it")


def test_what_has_no_place_yet_is_told_to_be_where_the_hand_acts(
    table: tuple[ArmLook, Scene],
) -> None:
    look, scene = table
    bare = replace(look, bodies={})
    things = (TaskObject("red cup", "object"), TaskObject("tray", "target"))
    (cup,) = unplaced(things, bare, WORDS, closed=False)
    assert "red cup" in cup
    assert "close the hand (c)" in cup
    (tray,) = unplaced(things, bare, WORDS, closed=True)
    assert "tray" in tray
    assert "open the hand (o)" in tray
    assert unplaced((TaskObject("block", "object"),), look, WORDS, closed=False) == ()
    above_mm = above_table(look, scene, TIP)
    lower = look.hand - np.array([0.0, 0.0, 0.05, 0.0, 0.0, 0.0, 0.0])
    assert above_mm is not None
    assert above_table(replace(look, hand=lower), scene, TIP) == pytest.approx(above_mm - 50.0)


@pytest.mark.parametrize("lower_mm", [0.0, 12.0])
@pytest.mark.parametrize("shape", ["box", "cylinder"])
def test_to_a_place_it_is_as_far_as_what_is_held_has_to_go(
    table: tuple[ArmLook, Scene], shape: Any, lower_mm: float
) -> None:
    look, scene = table
    block, target = scene.bodies["block"], look.bodies["target"]
    above = pose_from_mm_deg((30.0, 0.0, 100.0 + target_mm(scene)), (0.0, 0.0, 0.0))
    base = compose(target, above)
    # However low it was taken, it is its base that has to come down.
    hand = compose(base, block.hand_in_body) - np.array([0, 0, lower_mm / 1000.0, 0, 0, 0, 0])
    held = replace(look, hand=hand, held="block", bodies={**look.bodies, "block": base})
    round_one = replace(block, shape=shape, size_mm=(50.0, 50.0, 100.0))
    bodies = {**scene.bodies, "block": round_one}
    gap = gaps(held, replace(scene, bodies=bodies), TIP)[1]
    assert gap.xyz_mm[2] == pytest.approx(-100.0)
    assert np.linalg.norm(gap.xyz_mm[:2]) == pytest.approx(30.0)
    turned = replace(held, bodies={**held.bodies, "block": compose(base, QUARTER)})
    turn_deg = gaps(turned, replace(scene, bodies=bodies), TIP)[1].yaw_deg
    assert turn_deg == pytest.approx(0.0 if shape == "cylinder" else -20.0, abs=1e-6)


QUARTER = pose_from_mm_deg((0.0, 0.0, 0.0), (0.0, 0.0, 20.0))


def target_mm(scene: Scene) -> float:
    return scene.bodies["target"].size_mm[2]


@pytest.mark.parametrize("lean_deg", [0.0, 40.0, 90.0])
@pytest.mark.parametrize("yaw_deg", [-70.0, 0.0, 35.0])
def test_the_turn_told_is_about_the_vertical_however_the_hand_leans(
    table: tuple[ArmLook, Scene], lean_deg: float, yaw_deg: float
) -> None:
    look, _ = table
    leaning = pose_from_mm_deg((450, 100, 400), (0.0, lean_deg, 0.0))
    goal = pose_from_mm_deg((450, 100, 400), (0.0, 0.0, yaw_deg))
    for about, held in ((0.0, ""), (180.0, "")):
        turned = pose_from_mm_deg((450, 100, 400), (0.0, lean_deg, about))
        gap = end_gap(replace(look, hand=turned, held=held), goal, TIP)
        assert gap.yaw_deg == pytest.approx(yaw_deg, abs=1e-6)
    full = end_gap(replace(look, hand=leaning, held="block"), goal, TIP)
    assert full.yaw_deg == pytest.approx(yaw_deg, abs=1e-6)


def test_a_stretched_arm_is_not_told_to_stretch_further() -> None:
    stretched = in_the_way(Refusal("speed", "next step", "joint 3"), WORDS, "english")
    assert "(s)" in stretched
    assert "folded" not in stretched


def test_a_folded_arm_is_told_which_way_is_free() -> None:
    folded = Refusal("joint_limit", "next step", "joint 3")
    assert "first (w)" in in_the_way(folded, WORDS, "english")
    assert "first (s)" in in_the_way(folded, WORDS, "english", facing=True)
    assert "(w)" not in in_the_way(Refusal("joint_limit", "next step", "joint 5"), WORDS, "english")


def test_a_gap_of_nothing_is_there() -> None:
    assert Gap("block", np.zeros(3), 0.0).there
    assert not Gap("block", np.zeros(3), 10.0).there


VIEW = {
    "step_shown": "",
    "task": {"primitives": [{"name": name} for name in ("approach", "grasp", "lift")]},
}


def test_the_step_being_shown_is_told_with_the_key_for_the_next() -> None:
    def told(*cues: str) -> str:
        return step_line(VIEW, cues, WORDS)

    assert told() == "press 1 and show: approach"
    assert told("first step").startswith("step 1 of 3: approach")
    assert told("first step").endswith("n when you go on to: grasp")
    assert told("first step", "then").startswith("step 2 of 3: grasp")
    # Who says nothing at the beginning marks the first transition first.
    assert told("then") == told("first step", "then")
    last = "step 3 of 3: lift   Esc when it is done"
    assert told("next step", "next step") == told("first step", "n", "n", "n") == last
    assert step_line({**VIEW, "task": {"primitives": []}}, (), WORDS) == ""
    assert "show only: lift" in step_line({**VIEW, "step_shown": "lift"}, (), WORDS)


def test_what_is_in_the_way_is_told_in_the_robots_words() -> None:
    refusal = Refusal("joint_limit", "next step", "joint 2")
    told = in_the_way(refusal, WORDS, "english")
    assert told == "I do not go: at the next step joint 2 would pass its limit."
    wound = in_the_way(Refusal("joint_limit", "next step", "joint 4"), WORDS, "english")
    assert "h unwinds" in wound
    low = Refusal("collision", "next step", "table")
    for part in ("fingers", "palm", "arm", "carried"):
        told = in_the_way(low, WORDS, "english", touching=part)
        assert "touch the table" in told
        assert ("h points" in told) is (part == "palm")
    down = in_the_way(low, WORDS, "english", touching="palm", down=True)
    assert "h points" not in down
    assert "r lifts it" in down
    assert "(s)" in in_the_way(Refusal("reach", "next step"), WORDS, "english")
    assert "(w)" in in_the_way(Refusal("reach", "next step"), WORDS, "english", facing=True)
    slipped = ArmReport("unmet", 1.0, text="held", object="block")
    assert "block slipped" in in_the_way(slipped, WORDS, "english")
    for text in OTHERS:
        fault = ArmReport("unmet", 1.0, text=text, object="block")
        for language in ("english", "german"):
            words = page("terminal", language)["driving"]
            assert "block" in in_the_way(fault, words, language).lower()
    touched = ArmReport("unmet", 1.0, text="contact", object="target")
    assert "bumped into the target" in in_the_way(touched, WORDS, "english")
    assert in_the_way(touched, WORDS, "english", "block").startswith("the block touches the target")


@pytest.mark.parametrize("reason", ["reach", "joint_limit", "collision", "speed"])
@pytest.mark.parametrize("language", ["english", "german"])
def test_every_reason_has_a_sentence(reason: Any, language: str) -> None:
    told = in_the_way(Refusal(reason, "next step", "joint 3"), WORDS, language)
    assert len(told.split()) > 3
    assert "_" not in told


@pytest.mark.parametrize("language", ["english", "german"])
def test_every_fault_and_key_has_words(language: str) -> None:
    words = page("terminal", language)["driving"]
    assert set(words["faults"]) == {"held", "contact", "tracking", *OTHERS}
    shown = " ".join(words["rows"].values()).split()
    assert sorted(shown) == sorted(words["keys"])
    assert set(words["touching"]) == {"fingers", "palm", "palm_down", "arm", "arm_down", "carried"}
    assert set(words["touching"]) == {"fingers", "palm", "palm_down", "arm", "arm_down", "carried"}
    assert set(words["headings"]) == {*words["rows"], "mouse"}
