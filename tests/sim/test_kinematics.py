"""Forward and inverse kinematics undo one another on every branch."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import Array, pose_from_mm_deg
from assistant.model.setup import READY
from sim import a465
from sim.kinematics import (
    BRANCHES,
    arm_points,
    branch_of,
    forward,
    inverse,
    inverse_all,
    limit_margin,
    within_limits,
    wrist_of,
)


def random_joints(count: int, seed: int = 465) -> Array:
    random = np.random.default_rng(seed)
    return np.asarray(random.uniform(-1.0, 1.0, (count, a465.JOINTS)) * a465.LIMITS)


def test_ready_holds_the_papers_robot_start_unturned() -> None:
    told = pose_from_mm_deg(READY.xyz_mm, READY.rpy_deg)
    np.testing.assert_allclose(forward(a465.READY), told, atol=1e-15)


def test_every_random_posture_comes_back_on_its_branch() -> None:
    q = random_joints(10_000)
    found = inverse_all(forward(q))[np.arange(len(q)), branch_of(q)]
    assert np.max(np.abs(found - q)) <= 1e-9


def test_all_eight_answers_hold_the_pose_and_lie_on_their_branches() -> None:
    poses = forward(random_joints(200))
    answers = inverse_all(poses)
    assert answers.shape == (200, BRANCHES, a465.JOINTS)
    held = forward(answers)
    np.testing.assert_allclose(held[..., :3], np.repeat(poses[:, None, :3], 8, 1), atol=1e-12)
    dots = np.abs(np.sum(held[..., 3:] * poses[:, None, 3:], axis=-1))
    np.testing.assert_allclose(dots, 1.0, atol=1e-12)
    assert np.array_equal(branch_of(answers), np.tile(np.arange(BRANCHES), (200, 1)))


def test_a_single_pose_has_the_same_answer_as_many() -> None:
    poses = forward(random_joints(50))
    many = inverse_all(poses)
    for pose, answers in zip(poses, many, strict=True):
        for branch in range(BRANCHES):
            one = inverse(pose.tolist(), branch)
            assert one is not None
            np.testing.assert_allclose(one, answers[branch], atol=1e-12)


def test_a_single_pose_may_be_given_as_an_array() -> None:
    q = inverse(forward(random_joints(1)[0]), 0)
    assert q is not None
    assert len(q) == a465.JOINTS


def test_out_of_reach_has_no_answer() -> None:
    far = pose_from_mm_deg((900.0, 0.0, 300.0), (0.0, 0.0, 0.0))
    assert inverse(far, 0) is None
    assert np.isnan(inverse_all(far[None])).any()
    assert not within_limits(inverse_all(far[None])).any()


@pytest.mark.parametrize("fourth", [-1.0, 0.0, 2.0])
def test_the_singular_wrist_keeps_the_joint_preferred(fourth: float) -> None:
    pose = pose_from_mm_deg(READY.xyz_mm, READY.rpy_deg)
    prefer = (0.0, 0.0, 0.0, fourth, 0.0, 0.0)
    q = inverse(pose, 0, prefer)
    assert q is not None
    assert q[3] == pytest.approx(fourth)
    np.testing.assert_allclose(forward(np.array(q)), pose, atol=1e-12)


def test_ready_is_found_with_the_wrist_straight() -> None:
    pose = pose_from_mm_deg(READY.xyz_mm, READY.rpy_deg)
    np.testing.assert_allclose(inverse_all(pose[None])[0, 0], a465.READY, atol=1e-12)


@settings(max_examples=40, deadline=None)
@given(st.lists(st.floats(-1.0, 1.0), min_size=6, max_size=6))
def test_links_keep_their_lengths(shares: list[float]) -> None:
    q = np.array(shares) * a465.LIMITS
    elbow, wrist = arm_points(q)
    shoulder = np.array([0.0, 0.0, a465.BASE_M])
    assert np.linalg.norm(elbow - shoulder) == pytest.approx(a465.UPPER_ARM_M)
    assert np.linalg.norm(wrist - elbow) == pytest.approx(a465.FOREARM_M)
    np.testing.assert_allclose(wrist_of(forward(q)), wrist, atol=1e-12)


def test_the_margin_is_negative_beyond_a_limit() -> None:
    q = np.array(a465.READY)
    q[4] = a465.LIMITS[4] + np.deg2rad(2.0)
    assert limit_margin(q) == pytest.approx(np.deg2rad(-2.0))
    assert not within_limits(q)
