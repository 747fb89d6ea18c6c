"""Figures of the Thermo CRS A465 and of the parallel gripper it carries.

At q = 0 the arm points straight up; every joint angle is then a turn about the base's own
axes: joints 1, 4 and 6 about z, joints 2, 3 and 5 about y. The flange frame has x along the
hand's approach and z up at READY, where it stands at (406.4, 0, 635.0) mm unturned, which is
the paper's robot start. Source: the maker's data sheet; paper, Table I.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array

JOINTS = 6
BASE_M = 0.3302
"""Height of the shoulder above the base."""
UPPER_ARM_M = 0.3048
FOREARM_M = 0.3302
"""From the elbow to the middle of the wrist."""
FLANGE_M = 0.0762
"""From the middle of the wrist to the flange."""
TCP_M = 0.1341
"""From the flange to the point between the finger pads, along the approach."""
REACH_M = 0.628
"""How far the middle of the wrist may be from the shoulder; 635 mm is the stretched arm."""
CONTROL_HZ = 50.0


def _constant(degrees: list[float]) -> Array:
    angles: Array = np.deg2rad(np.array(degrees, dtype=float))
    angles.setflags(write=False)
    return angles


LIMITS: Array = _constant([175.0, 90.0, 110.0, 180.0, 105.0, 180.0])
"""Joint angles lie within plus or minus these, rad, shape (6,)."""
SPEEDS: Array = _constant([180.0, 180.0, 180.0, 171.0, 173.0, 171.0])
"""rad/s, shape (6,)."""
ACCELERATIONS: Array = _constant([720.0, 720.0, 720.0, 1430.0, 1430.0, 1430.0])
"""rad/s^2, shape (6,)."""
READY: Array = _constant([0.0, 0.0, 90.0, 0.0, 0.0, 0.0])


@dataclass(frozen=True, slots=True)
class Gripper:
    """A parallel gripper seen from the flange: x approach, y across the fingers, z up.

    Parameters
    ----------
    open_m : float
        Greatest opening: distance between the inner faces of the pads.
    palm_m : 3 floats
        The palm, a box from the flange on: length, width, height.
    finger_m : 3 floats
        A finger, a box from the palm on: length, thickness, height.
    speed_m_s : float
        Greatest speed of the opening.
    """

    open_m: float = 0.080
    palm_m: tuple[float, float, float] = (0.085, 0.110, 0.060)
    finger_m: tuple[float, float, float] = (0.070, 0.012, 0.028)
    speed_m_s: float = 0.10


GRIPPER = Gripper()

BASE_RADIUS_M = 0.085
UPPER_ARM_RADIUS_M = 0.060
FOREARM_RADIUS_M = 0.048
WRIST_RADIUS_M = 0.040
"""Radii of the capsules that enclose the links, for collision checks and the URDF."""
