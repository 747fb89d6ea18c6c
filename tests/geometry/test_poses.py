"""Poses behave as rigid motions; quaternions agree with an independent library."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

from assistant.geometry import (
    IDENTITY,
    Array,
    angle_between,
    compose,
    distance_between,
    interpolate,
    inverse,
    pose_from_mm_deg,
    pose_to_mm_deg,
    quat_blend,
    quat_continuous,
    quat_from_rotvec,
    quat_from_rpy,
    quat_multiply,
    quat_normalize,
    quat_to_matrix,
    quat_to_rotvec,
    quat_to_rpy,
    relative,
    rotate_vector,
    transform_points,
)

numbers = st.floats(-1.0, 1.0)
rotvecs = arrays(float, 3, elements=st.floats(-1.7, 1.7))
vectors = arrays(float, 3, elements=numbers)


@st.composite
def poses(draw: st.DrawFn) -> Array:
    return np.concatenate([draw(vectors), quat_from_rotvec(draw(rotvecs))])


def same(first: Array, second: Array, error: float = 1e-12) -> bool:
    return bool(
        np.all(distance_between(first, second) < error)
        and np.all(angle_between(first, second) < 10 * error)
    )


@given(poses(), poses(), poses())
def test_composition_is_associative(a: Array, b: Array, c: Array) -> None:
    assert same(compose(compose(a, b), c), compose(a, compose(b, c)))


@given(poses(), poses())
def test_relative_undoes_compose(frame: Array, pose: Array) -> None:
    assert same(compose(frame, relative(frame, pose)), pose)
    assert same(compose(pose, inverse(pose)), IDENTITY)


@given(poses(), poses())
def test_points_move_with_the_frame(frame: Array, pose: Array) -> None:
    point = pose[:3]
    assert np.allclose(transform_points(frame, point), compose(frame, pose)[:3], atol=1e-12)


@given(rotvecs, vectors)
def test_quaternions_agree_with_scipy(rotvec: Array, vector: Array) -> None:
    quat = quat_from_rotvec(rotvec)
    theirs = Rotation.from_rotvec(rotvec)
    assert np.allclose(quat_to_matrix(quat), theirs.as_matrix(), atol=1e-12)
    assert np.allclose(rotate_vector(quat, vector), theirs.apply(vector), atol=1e-12)
    assert np.allclose(quat_to_rotvec(quat), theirs.as_rotvec(), atol=1e-9)


@given(rotvecs, rotvecs)
def test_product_turns_by_the_second_first(first: Array, second: Array) -> None:
    ours = quat_multiply(quat_from_rotvec(first), quat_from_rotvec(second))
    theirs = Rotation.from_rotvec(first) * Rotation.from_rotvec(second)
    assert np.allclose(quat_to_matrix(ours), theirs.as_matrix(), atol=1e-12)


@given(arrays(float, 3, elements=st.floats(-1.5, 1.5)))
def test_roll_pitch_yaw_round_trip(rpy: Array) -> None:
    quat = quat_from_rpy(rpy)
    assert np.allclose(quat_to_matrix(quat), Rotation.from_euler("xyz", rpy).as_matrix())
    assert np.allclose(quat_to_rpy(quat), rpy, atol=1e-7)


def test_roll_pitch_yaw_at_the_pole_gives_the_same_rotation() -> None:
    for pitch in (np.pi / 2, -np.pi / 2):
        quat = quat_from_rpy([0.3, pitch, -0.8])
        again = quat_from_rpy(quat_to_rpy(quat))
        assert np.allclose(quat_to_matrix(quat), quat_to_matrix(again), atol=1e-7)


@given(poses(), poses(), st.floats(0, 1))
def test_interpolation_meets_both_ends_at_constant_rate(a: Array, b: Array, share: float) -> None:
    assert same(interpolate(a, b, 0.0), a)
    assert same(interpolate(a, b, 1.0), b, 1e-9)
    between = interpolate(a, b, share)
    assert np.isclose(distance_between(a, between), share * distance_between(a, b), atol=1e-9)
    assert np.isclose(angle_between(a, between), share * angle_between(a, b), atol=1e-6)


def test_a_half_turn_has_a_stated_answer() -> None:
    half = np.array([0.0, 0.0, 1.0, 0.0])
    quarter = quat_blend(IDENTITY[3:], half, 0.5)
    assert np.allclose(quarter, [0, 0, np.sqrt(0.5), np.sqrt(0.5)])
    assert np.allclose(quat_blend(IDENTITY[3:], -half, 0.5), [0, 0, -np.sqrt(0.5), np.sqrt(0.5)])


def test_continuous_quaternions_never_jump_in_sign() -> None:
    turning = quat_from_rotvec(np.linspace(0, 6, 50)[:, None] * np.array([0.0, 0.0, 1.0]))
    flipped = turning * np.where(np.arange(50) % 3 == 0, -1.0, 1.0)[:, None]
    smooth = quat_continuous(flipped)
    assert np.all(np.sum(smooth[1:] * smooth[:-1], axis=1) > 0)
    assert np.allclose(quat_to_matrix(smooth), quat_to_matrix(turning))


def test_told_places_are_read_in_mm_and_degrees() -> None:
    pose = pose_from_mm_deg([533.0, 270.0, 300.0], [0.0, 0.0, -15.0])
    assert np.allclose(pose[:3], [0.533, 0.27, 0.3])
    xyz_mm, rpy_deg = pose_to_mm_deg(pose)
    assert np.allclose(xyz_mm, [533.0, 270.0, 300.0])
    assert np.allclose(rpy_deg, [0.0, 0.0, -15.0])
    assert np.isclose(np.linalg.norm(quat_normalize([0.0, 0.0, 3.0, 4.0])), 1.0)
