"""Rigid poses as arrays of seven numbers: xyz in metres, then a unit quaternion xyzw."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from assistant.geometry.quaternions import (
    Array,
    quat_blend,
    quat_from_rpy,
    quat_inverse,
    quat_multiply,
    quat_to_rotvec,
    quat_to_rpy,
)

IDENTITY: Array = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])
IDENTITY.setflags(write=False)


def rotate_vector(quats: ArrayLike, vectors: ArrayLike) -> Array:
    """Return vectors turned by unit quaternions xyzw; leading dimensions broadcast.

    Parameters
    ----------
    quats : array-like, shape (..., 4)
    vectors : array-like, shape (..., 3)

    Returns
    -------
    turned : array, shape (..., 3)
    """
    quats = np.asarray(quats, dtype=float)
    vectors = np.asarray(vectors, dtype=float)
    axis = quats[..., :3]
    twice = 2.0 * _cross(axis, vectors)
    return np.asarray(vectors + quats[..., 3:] * twice + _cross(axis, twice))


def compose(parent_to_world: ArrayLike, child_to_parent: ArrayLike) -> Array:
    """Return the pose of a child given in its parent, seen from the world.

    Parameters
    ----------
    parent_to_world, child_to_parent : array-like, shape (..., 7)

    Returns
    -------
    child_to_world : array, shape (..., 7)
    """
    parent = np.asarray(parent_to_world, dtype=float)
    child = np.asarray(child_to_parent, dtype=float)
    xyz = parent[..., :3] + rotate_vector(parent[..., 3:], child[..., :3])
    quats = quat_multiply(parent[..., 3:], child[..., 3:])
    return np.concatenate([xyz, quats], axis=-1)


def inverse(poses: ArrayLike) -> Array:
    """Return the inverse poses, shape (..., 7): ``compose(p, inverse(p))`` is the identity."""
    poses = np.asarray(poses, dtype=float)
    back = quat_inverse(poses[..., 3:])
    return np.concatenate([-rotate_vector(back, poses[..., :3]), back], axis=-1)


def relative(frame_to_world: ArrayLike, poses: ArrayLike) -> Array:
    """Return poses given in the world as seen from a frame, shape (..., 7)."""
    return compose(inverse(frame_to_world), poses)


def transform_points(pose: ArrayLike, points: ArrayLike) -> Array:
    """Return points given in a frame at a pose, shape (..., 7), as seen from its parent.

    Points have shape (..., 3), in the unit of the pose's place, and so has the result.
    """
    pose = np.asarray(pose, dtype=float)
    return np.asarray(pose[..., :3] + rotate_vector(pose[..., 3:], points))


def interpolate(first: ArrayLike, second: ArrayLike, weight: ArrayLike) -> Array:
    """Return poses between two: straight in place, slerp in rotation.

    Parameters
    ----------
    first, second : array, shape (..., 7)
    weight : float or array, shape (...)
        0 gives `first`, 1 gives `second`.

    Returns
    -------
    array, shape (..., 7)
    """
    first = np.asarray(first, dtype=float)
    second = np.asarray(second, dtype=float)
    share = np.asarray(weight, dtype=float)[..., None]
    xyz = (1.0 - share) * first[..., :3] + share * second[..., :3]
    return np.concatenate([xyz, quat_blend(first[..., 3:], second[..., 3:], weight)], axis=-1)


def distance_between(first: ArrayLike, second: ArrayLike) -> Array:
    """Return how far apart the places of two poses are, in m, shape (...)."""
    gap = np.asarray(first, dtype=float)[..., :3] - np.asarray(second, dtype=float)[..., :3]
    return np.asarray(np.sqrt(np.sum(gap * gap, axis=-1)))


def angle_between(first: ArrayLike, second: ArrayLike) -> Array:
    """Return the angle between the rotations of two poses, in rad within [0, pi], shape (...)."""
    first = np.asarray(first, dtype=float)
    second = np.asarray(second, dtype=float)
    turn = quat_to_rotvec(quat_multiply(quat_inverse(first[..., 3:]), second[..., 3:]))
    return np.asarray(np.sqrt(np.sum(turn * turn, axis=-1)))


def pose_from_mm_deg(xyz_mm: ArrayLike, rpy_deg: ArrayLike) -> Array:
    """Return the pose told in mm and in degrees about fixed x, then y, then z, shape (..., 7)."""
    xyz = np.asarray(xyz_mm, dtype=float) / 1000.0
    return np.concatenate([xyz, quat_from_rpy(np.deg2rad(np.asarray(rpy_deg)))], axis=-1)


def pose_to_mm_deg(pose: ArrayLike) -> tuple[Array, Array]:
    """Return place in mm and roll, pitch, yaw in degrees, each of shape (..., 3)."""
    pose = np.asarray(pose, dtype=float)
    return pose[..., :3] * 1000.0, np.rad2deg(quat_to_rpy(pose[..., 3:]))


def _cross(a: Array, b: Array) -> Array:
    # np.cross spends most of its time on axis bookkeeping for small arrays.
    return np.stack(
        [
            a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1],
            a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2],
            a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0],
        ],
        axis=-1,
    )
