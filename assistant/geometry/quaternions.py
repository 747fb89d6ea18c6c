"""Rotations as unit quaternions xyzw, batched over leading dimensions."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def quat_normalize(quats: ArrayLike) -> Array:
    """Return the quaternions scaled to length one.

    Parameters
    ----------
    quats : array-like, shape (..., 4)
        Quaternions xyzw, none of them zero.

    Returns
    -------
    unit : array, shape (..., 4)
    """
    quats = np.asarray(quats, dtype=float)
    return np.asarray(quats / np.sqrt(np.sum(quats * quats, axis=-1, keepdims=True)))


def quat_multiply(first: ArrayLike, second: ArrayLike) -> Array:
    """Return the product: turn by `second`, then by `first`.

    Parameters
    ----------
    first, second : array-like, shape (..., 4)
        Quaternions xyzw; leading dimensions broadcast.

    Returns
    -------
    product : array, shape (..., 4)
    """
    a, b = np.broadcast_arrays(np.asarray(first, dtype=float), np.asarray(second, dtype=float))
    ax, ay, az, aw = a[..., 0], a[..., 1], a[..., 2], a[..., 3]
    bx, by, bz, bw = b[..., 0], b[..., 1], b[..., 2], b[..., 3]
    out = np.empty(a.shape)
    out[..., 0] = aw * bx + ax * bw + ay * bz - az * by
    out[..., 1] = aw * by - ax * bz + ay * bw + az * bx
    out[..., 2] = aw * bz + ax * by - ay * bx + az * bw
    out[..., 3] = aw * bw - ax * bx - ay * by - az * bz
    return out


def quat_inverse(quats: ArrayLike) -> Array:
    """Return the inverse rotations of unit quaternions xyzw, shape (..., 4)."""
    return np.asarray(np.asarray(quats, dtype=float) * np.array([-1.0, -1.0, -1.0, 1.0]))


def quat_to_rotvec(quats: ArrayLike) -> Array:
    """Return rotation vectors in rad, shape (..., 3), of length at most pi.

    A half turn has two answers; the one returned has the sign of the quaternion's
    vector part as given when its scalar part is not negative.
    """
    quats = np.asarray(quats, dtype=float)
    quats = np.where(quats[..., 3:] < 0, -quats, quats)
    vector = quats[..., :3]
    sine = np.sqrt(np.sum(vector * vector, axis=-1, keepdims=True))
    angle = 2.0 * np.arctan2(sine, quats[..., 3:])
    small = sine < 1e-9
    return np.asarray(np.where(small, 2.0, angle / np.where(small, 1.0, sine)) * vector)


def quat_from_rotvec(rotvecs: ArrayLike) -> Array:
    """Return unit quaternions xyzw, shape (..., 4), of rotation vectors in rad, shape (..., 3)."""
    rotvecs = np.asarray(rotvecs, dtype=float)
    angle = np.sqrt(np.sum(rotvecs * rotvecs, axis=-1, keepdims=True))
    small = angle < 1e-9
    scale = np.where(small, 0.5, np.sin(angle / 2.0) / np.where(small, 1.0, angle))
    return np.concatenate([scale * rotvecs, np.cos(angle / 2.0)], axis=-1)


def quat_from_rpy(rpy: ArrayLike) -> Array:
    """Return unit quaternions xyzw of turns about fixed x, then y, then z.

    Parameters
    ----------
    rpy : array-like, shape (..., 3)
        Roll, pitch, yaw in rad.
    """
    half = np.asarray(rpy, dtype=float) / 2.0
    cr, cp, cy = (np.cos(half[..., k]) for k in range(3))
    sr, sp, sy = (np.sin(half[..., k]) for k in range(3))
    return np.stack(
        [
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
            cr * cp * cy + sr * sp * sy,
        ],
        axis=-1,
    )


def quat_to_rpy(quats: ArrayLike) -> Array:
    """Return roll, pitch, yaw in rad (turns about fixed x, y, z), shape (..., 3).

    Pitch lies in [-pi/2, pi/2]; at its ends roll is set to zero.
    """
    q = quat_normalize(quats)
    x, y, z, w = q[..., 0], q[..., 1], q[..., 2], q[..., 3]
    sine = np.clip(2.0 * (w * y - z * x), -1.0, 1.0)
    pole = np.abs(sine) > 1.0 - 1e-12
    roll = np.where(pole, 0.0, np.arctan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y)))
    yaw = np.where(
        pole,
        np.arctan2(-2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z)),
        np.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z)),
    )
    return np.stack([roll, np.arcsin(sine), yaw], axis=-1)


def quat_to_matrix(quats: ArrayLike) -> Array:
    """Return rotation matrices, shape (..., 3, 3), of unit quaternions xyzw."""
    q = np.asarray(quats, dtype=float)
    x, y, z, w = q[..., 0], q[..., 1], q[..., 2], q[..., 3]
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def quat_continuous(quats: ArrayLike) -> Array:
    """Return the same rotations with signs flipped so that neighbors lie close, shape (n, 4)."""
    quats = np.asarray(quats, dtype=float)
    dots = np.sum(quats[1:] * quats[:-1], axis=-1)
    signs = np.concatenate([[1.0], np.cumprod(np.where(dots < 0, -1.0, 1.0))])
    return np.asarray(quats * signs[:, None])


def quat_blend(first: ArrayLike, second: ArrayLike, weight: ArrayLike) -> Array:
    """Return rotations between two, along the shorter arc at constant rate (slerp).

    At a half turn the arc starts along the sign of `second` as given.

    Parameters
    ----------
    first, second : array-like, shape (..., 4)
        Unit quaternions xyzw.
    weight : array-like, shape (...)
        0 gives `first`, 1 gives `second`.
    """
    first = np.asarray(first, dtype=float)
    between = quat_to_rotvec(quat_multiply(quat_inverse(first), second))
    return quat_multiply(first, quat_from_rotvec(np.asarray(weight)[..., None] * between))
