"""What is watched goes no faster than the clock on the wall."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from assistant.files.finding import find_setups
from assistant.files.scenes import find_scene
from assistant.shells.pacing import PERIOD_S, PacedArm
from sim.driving import Driven
from sim.jogging import Jog, Jogger, joint_path
from sim.kinematic_arm import KinematicArm


class Wall:
    """A clock that is told how long things take."""

    def __init__(self) -> None:
        self.at_s, self.waited_s = 0.0, 0.0

    def now_s(self) -> float:
        return self.at_s

    def pass_s(self, seconds: float) -> None:
        assert seconds >= 0.0
        self.at_s += seconds
        self.waited_s += seconds


@pytest.mark.parametrize("slow_s", [0.0, 0.005, 0.05])
def test_a_motion_takes_its_own_time_or_longer(slow_s: float) -> None:
    setups, path = find_setups("demonstration", Path())
    scene, wall = find_scene(setups[0].scene, path), Wall()
    arm = KinematicArm()
    paced = PacedArm(arm, wall)
    paced.arrange(scene, setups[0])
    wall.at_s += 100.0
    look = paced.look()
    ahead = np.array([0.1, 0.0, 0.0, 0.0, 0.0, 0.0])
    jog = Jogger(scene, setups[0], look).towards(Driven.resting(look.q), ahead)
    assert isinstance(jog, Jog)
    paced.start(joint_path(jog, look.gripper_m))
    began_s, ticks, told = wall.at_s, 0, ""
    while told != "finished":
        wall.at_s += slow_s
        told = "".join(report.kind for report in paced.tick())
        ticks += 1
    assert ticks == len(jog.q) - 1
    # Planning before is no time that must be caught up with, nor is a tick that took long.
    assert wall.at_s - began_s == pytest.approx(ticks * max(PERIOD_S, slow_s))
    assert (wall.waited_s == 0.0) is (slow_s > PERIOD_S)


def test_stopping_goes_to_the_arm() -> None:
    setups, path = find_setups("demonstration", Path())
    arm = PacedArm(KinematicArm(), Wall())
    arm.arrange(find_scene(setups[0].scene, path), setups[0])
    arm.stop("key")
    assert not arm.look().moving
