"""Checks a motion that was corrected while under way for collision.

What was planned kept its clearance; a correction may use up some of it, but touches nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from assistant.model.motion import JointPath
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import ArmLook
from sim.fine_path import FinePath
from sim.kinematics import forward
from sim.phases import phases

USED_UP_M = 0.001
"""A correction may come so much nearer to things than a plan does."""


def still_free(
    scene: Scene, setup: Setup, look: ArmLook, begin: int
) -> Callable[[JointPath], bool]:
    """Return a check of motions from one of their samples on.

    Parameters
    ----------
    scene, setup
        What things look like and where they were told to be.
    look : ArmLook
        What is held, and where things are seen.
    begin : int
        What lies before is done already.
    """

    def free(motion: JointPath) -> bool:
        part = slice(begin, None)
        q, gripper_m = motion.q[part], motion.gripper_m[part]
        later = [stop for stop in motion.stops if stop.at >= begin]
        stops = tuple(
            replace(s, at=s.at - begin, docking_at=s.docking_at - begin, left_at=s.left_at - begin)
            for s in later
        )
        fine = FinePath(motion.t_s[part], forward(q), gripper_m, motion.primitive_at[part], stops)
        for phase in phases(fine, scene, setup, look):
            samples = np.arange(phase.first, phase.last + 1)
            touch = phase.touches(q[samples], gripper_m[samples], samples)
            if float(np.min(touch.gap)) < -USED_UP_M:
                return False
        return True

    return free
