"""What a hand that is driven by keys holds: carried on, put anywhere, let go of in any pose."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sim.hands import KeyedHand
from sim.kinematic_arm import KinematicArm
from sim.planner import A465Planner
from sim.sensor import InHandSensor, PlaceNoise
from tests.sim.keying import settled
from tests.sim.placing import lesson


def test_what_is_in_the_hand_shortens_no_step() -> None:
    _, scene, setup = lesson()
    arm = KinematicArm()
    block = replace(setup.places["block"], kind="hand")
    beside = replace(setup, robot_start=block)
    arm.arrange(scene, beside)
    hand = KeyedHand(arm, A465Planner(), scene, beside)
    hand.press("c")
    for _ in range(80):
        hand.tick()
    assert arm.look().held == "block"
    before = arm.look().hand[2]
    for _ in range(2):
        hand.press("r")
        for _ in range(30):
            hand.tick()
    assert arm.look().hand[2] - before == pytest.approx(0.010, abs=1e-5)


def test_what_is_held_may_be_put_on_any_body() -> None:
    _, scene, setup = lesson()
    arm = KinematicArm()
    arm.arrange(scene, replace(setup, robot_start=replace(setup.places["block"], kind="hand")))
    hand = KeyedHand(arm, A465Planner(), scene, setup)
    hand.press("c")
    for _ in range(80):
        hand.tick()
    target = scene.hand_pose("target", setup.places["target"])
    above = target[:3] + np.array([0.0, 0.0, 0.15])
    for goal in (arm.look().hand[:3] + np.array([0.0, 0.0, 0.15]), above, target[:3]):
        away = goal - arm.look().hand[:3]
        hand.lead((float(away[0]), float(away[1]), float(away[2])))
        for _ in range(60 + round(np.linalg.norm(away) / 0.0012)):
            hand.tick()
        assert hand.state.blocked is None
    assert arm.look().hand[:3] == pytest.approx(target[:3], abs=1e-4)
    assert arm.look().held == "block"


@pytest.mark.parametrize("seed", [1, 2, 5])
def test_a_thing_that_sits_elsewhere_in_the_hand_is_let_go_all_the_same(seed: int) -> None:
    _, scene, setup = lesson()
    noise = PlaceNoise(0.02, 12.0, seed)
    arm = KinematicArm(sensor=InHandSensor(), noise=noise)
    beside = replace(setup, robot_start=replace(setup.places["block"], kind="hand"))
    arm.arrange(scene, beside)
    hand = KeyedHand(arm, A465Planner(), scene, beside)
    assert settled(hand, "c").gripper_m == pytest.approx(0.04, abs=0.021)
    assert arm.look().held == "block"
    settled(hand, "r", 4)
    assert settled(hand, "o").gripper_m == pytest.approx(0.08)
    assert arm.look().held == ""
    assert hand.state.blocked is None
