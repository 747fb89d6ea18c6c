"""Short motions of a driven arm: on their line, within limits, always ending at rest."""

from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import (
    Array,
    compose,
    quat_from_rotvec,
    quat_inverse,
    quat_multiply,
    quat_to_rotvec,
)
from assistant.model.motion import Refusal
from sim import a465
from sim.driving import GAIN_M_S2, TIP, Driven, Pace, driven, stepped
from sim.jogging import LEAVES_RAD, Jog, Jogger, joint_path
from sim.kinematic_arm import KinematicArm
from sim.kinematics import forward
from sim.world import CONTROL_S
from tests.sim.placing import lesson

SPEED = {
    "ahead": np.array([0.1, 0.0, 0.0, 0.0, 0.0, 0.0]),
    "left": np.array([0.0, 0.1, 0.0, 0.0, 0.0, 0.0]),
    "up": np.array([0.0, 0.0, 0.1, 0.0, 0.0, 0.0]),
    "turning": np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.5]),
}


@pytest.fixture(scope="module")
def jogger() -> Jogger:
    _, scene, setup = lesson()
    arm = KinematicArm()
    arm.arrange(scene, setup)
    return Jogger(scene, setup, arm.look())


def ready(joint4_deg: float) -> Driven:
    """Return the arm at READY, its wrist split some way."""
    q = np.array(a465.READY)
    q[3] = np.deg2rad(joint4_deg)
    q[5] = -q[3]
    return Driven.resting(q)


def gone(jogger: Jogger, now: Driven, speed: Array, times: int) -> list[Jog]:
    jogs = []
    for _ in range(times):
        jog = jogger.towards(now, speed)
        assert isinstance(jog, Jog)
        jogs.append(jog)
        now = jog.at(5)
    return jogs


@pytest.mark.parametrize("name", SPEED)
@pytest.mark.parametrize("joint4_deg", [-90.0, -45.0, 0.0, 30.0, 90.0])
def test_whatever_the_wrist_stands_like_the_hand_goes_on_within_its_bound(
    jogger: Jogger, name: str, joint4_deg: float
) -> None:
    jogs = gone(jogger, ready(joint4_deg), SPEED[name], 10)
    for jog in jogs:
        assert jog.off_rad.max() <= LEAVES_RAD
        hand = forward(jog.q)
        assert compose(hand, TIP)[:, :3] == pytest.approx(jog.tips[:, :3], abs=5e-4)
        off = quat_to_rotvec(quat_multiply(jog.tips[:, 3:], quat_inverse(hand[:, 3:])))
        assert np.max(np.linalg.norm(off, axis=1)) == pytest.approx(jog.off_rad.max(), abs=1e-4)
        # Wherever it is left off, the hand rests where and as it was asked to.
        assert np.array_equal(jog.speeds[-1], np.zeros(6))
        assert forward(jog.q[-1]) == pytest.approx(
            compose(jog.tips[-1], compose_inverse()), abs=2e-4
        )
    # After a second full speed is reached from any split of the wrist.
    asked = float(np.linalg.norm(jogs[-1].at(5).speed))
    assert asked == pytest.approx(np.linalg.norm(SPEED[name]))


def compose_inverse() -> Array:
    return np.array([-a465.TCP_M, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])


def test_motions_follow_one_another_without_a_jump(jogger: Jogger) -> None:
    jogs = gone(jogger, ready(0.0), SPEED["left"], 12)
    q = np.concatenate([jog.q[:5] for jog in jogs])
    speeds = np.diff(q, axis=0) / 0.02
    assert np.all(np.abs(speeds) <= a465.SPEEDS)
    assert np.all(np.abs(np.diff(speeds, axis=0)) / 0.02 <= a465.ACCELERATIONS)


@pytest.mark.parametrize("pace", [Pace(1.0, 1.0, 15), Pace(0.4, 0.2, 5)])
def test_a_speed_is_taken_up_and_given_up_evenly(pace: Pace) -> None:
    _, speeds = driven(ready(0.0), SPEED["ahead"], pace)
    changes = np.diff(speeds, axis=0) / 0.02
    assert np.max(np.abs(changes)) <= GAIN_M_S2 + 1e-9
    assert np.max(speeds[:, 0]) <= 0.1 * pace.speed + 1e-9
    assert not speeds[-1].any()


def test_a_step_ends_exactly_where_it_was_asked_to() -> None:
    now = ready(0.0)
    goal = np.array(now.tip)
    goal[:3] += (0.004, -0.011, 0.002)
    tips, speeds = stepped(now, goal, (0.1, 0.5), Pace(1.0, 1.0, 15))
    assert tips[-1] == pytest.approx(goal, abs=1e-9)
    assert not speeds[-1].any()
    assert np.max(np.linalg.norm(speeds[:, :3], axis=1)) <= 0.1
    # Begun in motion, it turns round and comes to rest in the same place.
    moving = Driven(now.q, now.q_speed, now.tip, -SPEED["ahead"])
    assert stepped(moving, goal, (0.1, 0.5), Pace(1.0, 1.0, 15))[0][-1] == pytest.approx(goal)


def test_what_is_out_of_reach_in_the_way_or_beyond_a_joint_is_refused(jogger: Jogger) -> None:
    now = ready(0.0)
    found = {}
    for name, away in (("far", (0.6, 0.0, 0.0)), ("under", (0.1, 0.2, -0.5))):
        goal = np.array(now.tip)
        goal[:3] += away
        found[name] = jogger.to(now, goal, (0.1, 0.5))
    assert isinstance(found["far"], Refusal)
    assert found["far"].reason == "reach"
    assert isinstance(found["under"], Refusal)
    assert found["under"].reason in ("joint_limit", "collision")
    assert found["under"].what


def test_a_jog_is_a_motion_for_an_arm(jogger: Jogger) -> None:
    (jog,) = gone(jogger, ready(0.0), SPEED["ahead"], 1)
    motion = joint_path(jog, 0.05)
    assert np.array_equal(motion.q, jog.q)
    assert motion.t_s[-1] == pytest.approx(0.02 * (len(jog.q) - 1))
    assert motion.peak_hand_speed_m_s == pytest.approx(0.1, rel=1e-3)
    assert motion.joint_margin_deg > 0.0


@pytest.mark.parametrize("turn_deg", [2.0, 1.3, 0.5])
def test_a_step_with_the_elbow_nearly_straight_is_made_gently(
    jogger: Jogger, turn_deg: float
) -> None:
    # High above the target of the demonstration, almost as far out as the arm goes.
    now = Driven.resting(np.deg2rad([-24.6, 55.5, 23.2, 82.9, 58.3, -76.7]))
    turn = quat_from_rotvec(np.array([0.0, 0.0, np.deg2rad(turn_deg)]))
    goal = np.concatenate([now.tip[:3], quat_multiply(turn, now.tip[3:])])
    jog = jogger.to(now, goal, (0.1, 0.5))
    assert isinstance(jog, Jog)
    assert jog.tips[-1] == pytest.approx(goal, abs=1e-9)
    assert len(jog.q) * CONTROL_S < 2.0
