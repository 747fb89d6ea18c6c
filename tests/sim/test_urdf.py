"""The generated URDF is the arm the kinematics compute."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest

from assistant.geometry import angle_between, quat_normalize
from sim import a465
from sim.kinematics import forward
from sim.urdf import ARM_JOINTS, FINGER_JOINTS, PAD_LINKS, arm_urdf, write_urdf


def test_it_carries_limits_and_speeds() -> None:
    robot = ElementTree.fromstring(arm_urdf())
    limits = {joint.get("name"): joint.find("limit") for joint in robot.iter("joint")}
    for name, limit, speed in zip(ARM_JOINTS, a465.LIMITS, a465.SPEEDS, strict=True):
        told = limits[name]
        assert told is not None
        assert float(told.get("upper", "nan")) == pytest.approx(limit)
        assert float(told.get("lower", "nan")) == pytest.approx(-limit)
        assert float(told.get("velocity", "nan")) == pytest.approx(speed)


def test_pybullet_puts_the_flange_where_we_do(tmp_path: Path) -> None:
    import pybullet

    client = pybullet.connect(pybullet.DIRECT)
    try:
        path = str(write_urdf(tmp_path))
        arm = pybullet.loadURDF(path, useFixedBase=True, physicsClientId=client)
        count = pybullet.getNumJoints(arm, physicsClientId=client)
        infos = [pybullet.getJointInfo(arm, k, physicsClientId=client) for k in range(count)]
        names = [info[1].decode() for info in infos]
        links = [info[12].decode() for info in infos]
        assert set(PAD_LINKS) <= set(links)
        assert set(FINGER_JOINTS) <= set(names)
        random = np.random.default_rng(1)
        for q in random.uniform(-1.0, 1.0, (20, 6)) * a465.LIMITS:
            for name, angle in zip(ARM_JOINTS, q, strict=True):
                pybullet.resetJointState(arm, names.index(name), angle, physicsClientId=client)
            state = pybullet.getLinkState(
                arm, links.index("flange"), computeForwardKinematics=True, physicsClientId=client
            )
            pose = forward(q)
            np.testing.assert_allclose(state[4], pose[:3], atol=1e-6)
            turned = np.concatenate([state[4], quat_normalize(state[5])])
            # PyBullet reads the frames of a URDF in single precision.
            assert float(angle_between(turned, pose)) < 1e-5
    finally:
        pybullet.disconnect(client)


def test_the_rolled_pads_end_where_the_fingers_do() -> None:
    robot = ElementTree.fromstring(arm_urdf())
    for name in PAD_LINKS:
        shape = robot.find(f"link[@name='{name}']/collision")
        assert shape is not None
        origin, box = shape.find("origin"), shape.find("geometry/box")
        assert origin is not None
        assert box is not None
        middle = [float(text) for text in str(origin.get("xyz")).split()]
        roll = float(str(origin.get("rpy")).split()[1])
        long, _, tall = (float(text) / 2.0 for text in str(box.get("size")).split())
        corners = [
            middle[0] + x * np.cos(roll) + z * np.sin(roll)
            for x in (-long, long)
            for z in (-tall, tall)
        ]
        reach = a465.GRIPPER.palm_m[0] + a465.GRIPPER.finger_m[0]
        assert max(corners) == pytest.approx(reach, abs=1e-6)
