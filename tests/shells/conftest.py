"""What tests of several shells look at."""

from __future__ import annotations

from pathlib import Path

import pytest

from assistant.files.finding import find_setups
from assistant.files.scenes import find_scene
from assistant.model.scene import Scene
from assistant.ports import ArmLook
from sim.kinematic_arm import KinematicArm


@pytest.fixture(scope="session")
def table() -> tuple[ArmLook, Scene]:
    """The table of the demonstration, and an arm at rest over it."""
    setups, path = find_setups("demonstration", Path())
    scene = find_scene(setups[0].scene, path)
    arm = KinematicArm()
    arm.arrange(scene, setups[0])
    return arm.look(), scene
