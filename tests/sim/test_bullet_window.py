"""A picture shows what is; the world does the same with it as without."""

from __future__ import annotations

import select

import numpy as np
import pytest

from assistant.geometry import Array
from assistant.language.speech import phrase
from assistant.model.robot_acts import RobotAct
from sim.bullet_arm import CLOSED, BulletArm
from sim.bullet_picture import Picture
from sim.bullet_window import PICTURE_TICKS, WatchedWorld, Window
from sim.bullet_world import BulletWorld
from sim.driving import Driven
from sim.jogging import Jog, Jogger, joint_path
from sim.kinematic_arm import KinematicArm
from sim.kinematics import forward
from sim.world import Allowed
from tests.sim.placing import lesson


def moved(world: BulletWorld | WatchedWorld, ticks: int) -> Array:
    """Return the joints, shape (6,), after a short motion with the hand closing."""
    _, scene, setup = lesson()
    arm = KinematicArm()
    arm.arrange(scene, setup)
    look = arm.look()
    ahead = np.array([0.1, 0.0, 0.0, 0.0, 0.0, 0.0])
    jog = Jogger(scene, setup, look).towards(Driven.resting(look.q), ahead)
    assert isinstance(jog, Jog)
    world.arrange(scene, look.bodies, look.q)
    for k in range(ticks):
        world.step(jog.q[k], forward(jog.q[k]), 0.08 - 0.002 * k, Allowed())
    return world.joints()[0]


def test_the_picture_follows_and_changes_nothing() -> None:
    picture, world, alone = Picture(), BulletWorld(), BulletWorld()
    watched = WatchedWorld(world, picture, lambda: None)
    ticks = 5 * PICTURE_TICKS
    assert np.array_equal(moved(watched, ticks), moved(alone, ticks))
    assert picture.joints()[0] == pytest.approx(watched.joints()[0], abs=1e-9)
    assert picture.joints()[1] == pytest.approx(watched.joints()[1], abs=1e-9)
    for name, pose in watched.bodies().items():
        assert picture.bodies()[name] == pytest.approx(pose, abs=1e-6)


def test_a_window_that_is_closed_is_told_once_and_the_world_goes_on() -> None:
    picture, told = Picture(), []
    watched = WatchedWorld(BulletWorld(), picture, lambda: told.append("closed"))
    moved(watched, PICTURE_TICKS)
    picture.close()
    moved(watched, 4 * PICTURE_TICKS)
    assert told == ["closed"]
    assert watched.held() == ""


def drawn(window: Window) -> None:
    """Wait until all that was told has been drawn."""
    for _ in range(3000):
        window.look()
        if not window.owed:
            return
        select.select([window.answers], [], [], 0.02)
    raise AssertionError("nothing is drawn")


def test_a_window_that_is_killed_ends_itself_alone_and_stops_the_arm(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    windows: list[Window] = []

    def hidden() -> Window:
        windows.append(Window(hidden=True))
        return windows[0]

    monkeypatch.setattr("sim.bullet_arm.Window", hidden)
    _, scene, setup = lesson()
    arm = BulletArm(window=True)
    arm.arrange(scene, setup)
    (window,) = windows
    look = arm.look()
    ahead = np.array([0.1, 0.0, 0.0, 0.0, 0.0, 0.0])
    jog = Jogger(scene, setup, look).towards(Driven.resting(look.q), ahead)
    assert isinstance(jog, Jog)
    drawn(window)
    arm.start(joint_path(jog, look.gripper_m))
    told = [report for _ in range(2 * PICTURE_TICKS) for report in arm.tick()]
    # A picture that is still being drawn keeps nobody waiting.
    assert window.owed <= 1
    window.process.kill()
    window.process.wait()
    while arm.look().moving:
        told += arm.tick()
    assert (told[-1].kind, told[-1].text) == ("halted", CLOSED)
    for language in ("english", "german"):
        assert phrase(RobotAct("stopped", "stop", slots={"why": CLOSED}), language)
    window.close()
    window.close()
