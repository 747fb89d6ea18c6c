"""The A465 as URDF, generated from its figures, for PyBullet or any other reader.

`arm_urdf()` returns the text; `write_urdf(folder)` writes ``a465.urdf`` there and returns its
path. Names are fixed:

* joints ``joint_1`` .. ``joint_6`` (revolute, in this order from the base; names in
  `ARM_JOINTS`), angles and signs as in `sim.kinematics`;
* the link ``flange`` (fixed to the last joint's link, its link frame is the flange frame:
  x approach, z up at READY), which carries the palm;
* joints ``finger_left`` and ``finger_right`` (prismatic, names in `FINGER_JOINTS`, from 0 to
  half the opening; child links ``pad_left``, ``pad_right``): the opening of the gripper is
  the sum of both, and at 0 the pads touch. Left lies on the flange's +y side.

Collision shapes are capsules and boxes of the same figures as in `sim.collision`, but for the
pads, which are rolled a little, see `PAD_ROLL_RAD`. Limits of
effort are generous: the planner, not the motor, keeps within speeds and accelerations.
"""

from __future__ import annotations

from math import cos, pi, sin
from pathlib import Path

from sim import a465
from sim.a465 import GRIPPER

ARM_JOINTS = tuple(f"joint_{number}" for number in range(1, a465.JOINTS + 1))
FINGER_JOINTS = ("finger_left", "finger_right")
PAD_LINKS = ("pad_left", "pad_right")
FLANGE_LINK = "flange"
PAD_ROLL_RAD = 0.12
"""About the fingers' axis. Where edges of a pad ran along edges of a block, the engine would take
the two for crossing each other and make up a direction in which they touch."""

Triple = tuple[float, float, float]
ZERO: Triple = (0.0, 0.0, 0.0)
GRAY, YELLOW, DARK = "0.35 0.36 0.4 1", "0.93 0.75 0.2 1", "0.15 0.15 0.17 1"


def arm_urdf() -> str:
    """Return the URDF of arm and gripper, base at the origin."""
    parts = ['<?xml version="1.0"?>', '<robot name="a465">', *_arm(), *_gripper(), "</robot>"]
    return "\n".join(parts) + "\n"


def write_urdf(folder: Path) -> Path:
    """Write ``a465.urdf`` into a folder that exists and return its path."""
    path = folder / "a465.urdf"
    path.write_text(arm_urdf(), encoding="utf-8")
    return path


def _arm() -> list[str]:
    upper = _capsule(0.0, a465.UPPER_ARM_M, a465.UPPER_ARM_RADIUS_M)
    fore = _capsule(0.0, a465.FOREARM_M, a465.FOREARM_RADIUS_M)
    wrist = _capsule(0.0, a465.FLANGE_M / 2, a465.WRIST_RADIUS_M)
    links = [
        _link("base", 10.0, ZERO, _cylinder(a465.BASE_M / 2, a465.BASE_RADIUS_M), GRAY),
        _link("waist", 6.0, (0.0, 0.0, a465.BASE_M / 2), "", GRAY),
        _link("upper_arm", 5.0, (0.0, 0.0, a465.UPPER_ARM_M / 2), upper, YELLOW),
        _link("forearm", 3.0, (0.0, 0.0, a465.FOREARM_M / 2), fore, YELLOW),
        _link("wrist_roll", 0.8, ZERO, "", GRAY),
        _link("wrist_pitch", 0.8, ZERO, wrist, GRAY),
        _link("wrist_turn", 0.3, (0.0, 0.0, a465.FLANGE_M / 2), "", GRAY),
    ]
    return links + _arm_joints()


def _arm_joints() -> list[str]:
    names = ("base", "waist", "upper_arm", "forearm", "wrist_roll", "wrist_pitch", "wrist_turn")
    heights = (0.0, a465.BASE_M, a465.UPPER_ARM_M, a465.FOREARM_M, 0.0, 0.0)
    axes = ("0 0 1", "0 1 0", "0 1 0", "0 0 1", "0 1 0", "0 0 1")
    joints = [
        f'<joint name="{ARM_JOINTS[k]}" type="revolute"><parent link="{names[k]}"/>'
        f'<child link="{names[k + 1]}"/>{_origin((0.0, 0.0, heights[k]))}<axis xyz="{axes[k]}"/>'
        f'<limit lower="{-a465.LIMITS[k]:.9f}" upper="{a465.LIMITS[k]:.9f}" '
        f'velocity="{a465.SPEEDS[k]:.9f}" effort="400"/></joint>'
        for k in range(a465.JOINTS)
    ]
    flange = _origin((0.0, 0.0, a465.FLANGE_M), (0.0, -pi / 2, 0.0))
    joints.append(
        f'<joint name="to_flange" type="fixed"><parent link="wrist_turn"/>'
        f'<child link="{FLANGE_LINK}"/>{flange}</joint>'
    )
    return joints


def _gripper() -> list[str]:
    length, width, height = GRIPPER.palm_m
    middle = (length / 2, 0.0, 0.0)
    parts = [_link(FLANGE_LINK, 0.5, middle, _box(middle, (length, width, height)), DARK)]
    reach, thick, tall = GRIPPER.finger_m
    for name, link, side in zip(FINGER_JOINTS, PAD_LINKS, (1.0, -1.0), strict=True):
        middle = (length + reach / 2, side * thick / 2, 0.0)
        pad = _box(middle, (_rolled(reach, tall), thick, tall), (0.0, PAD_ROLL_RAD, 0.0))
        parts.append(_link(link, 0.1, middle, pad, GRAY))
        parts.append(
            f'<joint name="{name}" type="prismatic"><parent link="{FLANGE_LINK}"/>'
            f'<child link="{link}"/>{_origin(ZERO)}<axis xyz="0 {side:.0f} 0"/>'
            f'<limit lower="0" upper="{GRIPPER.open_m / 2:.6f}" '
            f'velocity="{GRIPPER.speed_m_s:.6f}" effort="60"/></joint>'
        )
    return parts


def _rolled(reach: float, tall: float) -> float:
    """Return the length of a rolled pad whose foremost edge is where that of an even one was.

    What is pushed with the fingertips meets that edge.
    """
    return (reach - tall * sin(PAD_ROLL_RAD)) / cos(PAD_ROLL_RAD)


def _link(name: str, mass: float, center: Triple, shape: str, color: str) -> str:
    # A solid ball of 6 cm keeps every link's inertia well conditioned for the solver.
    inertia = 0.4 * mass * 0.06**2
    diagonal = f'ixx="{inertia:.6g}" iyy="{inertia:.6g}" izz="{inertia:.6g}"'
    inertial = (
        f'<inertial>{_origin(center)}<mass value="{mass:g}"/>'
        f'<inertia {diagonal} ixy="0" ixz="0" iyz="0"/></inertial>'
    )
    if not shape:
        return f'<link name="{name}">{inertial}</link>'
    paint = f'<material name="{name}_paint"><color rgba="{color}"/></material>'
    body = f"<collision>{shape}</collision><visual>{shape}{paint}</visual>"
    return f'<link name="{name}">{inertial}{body}</link>'


def _capsule(bottom: float, top: float, radius: float) -> str:
    size = f'<capsule radius="{radius:.6f}" length="{top - bottom:.6f}"/>'
    return f"{_origin((0.0, 0.0, (bottom + top) / 2))}<geometry>{size}</geometry>"


def _cylinder(middle: float, radius: float) -> str:
    size = f'<cylinder radius="{radius:.6f}" length="{2 * middle:.6f}"/>'
    return f"{_origin((0.0, 0.0, middle))}<geometry>{size}</geometry>"


def _box(middle: Triple, size: Triple, rpy: Triple = ZERO) -> str:
    edges = " ".join(f"{edge:.6f}" for edge in size)
    return f'{_origin(middle, rpy)}<geometry><box size="{edges}"/></geometry>'


def _origin(xyz: Triple, rpy: Triple = ZERO) -> str:
    place = " ".join(f"{value:.9g}" for value in xyz)
    turn = " ".join(f"{value:.9g}" for value in rpy)
    return f'<origin xyz="{place}" rpy="{turn}"/>'
