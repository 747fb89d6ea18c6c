"""Forward and inverse kinematics of the A465 in closed form.

The wrist is spherical, so a flange pose has up to eight answers: shoulder ahead or behind,
elbow on either side, wrist straight or flipped. A branch is a number 0..7: bit 4 is set where
the arm reaches over its shoulder, bit 2 where the elbow (joint 3) is negative, bit 1 where
the wrist (joint 5) is negative. Angles are in rad, wrapped to within half a turn.

The flange is turned by Rz(q1) Ry(q2 + q3 - 90 deg) Rx(q4) Ry(q5) Rx(q6). As a quaternion the
last three are x = cos(q5/2) sin((q4+q6)/2), y = sin(q5/2) cos((q4-q6)/2),
z = sin(q5/2) sin((q4-q6)/2), w = cos(q5/2) cos((q4+q6)/2): three arctangents give them back,
exactly also near the wrist's singularity.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from assistant.geometry import Array
from sim.a465 import BASE_M, FLANGE_M, FOREARM_M, LIMITS, UPPER_ARM_M

BRANCHES = 8
OVER_SHOULDER, ELBOW_NEGATIVE, WRIST_NEGATIVE = 4, 2, 1
SINGULAR_SINE = 1e-9
"""Below this sine of half of joint 5 only the sum of joints 4 and 6 is determined."""

Flags = NDArray[np.bool_]
Joints = tuple[float, float, float, float, float, float]

_CHUNK = 1024
_SUM_SQUARES = UPPER_ARM_M**2 + FOREARM_M**2
_TWICE_PRODUCT = 2.0 * UPPER_ARM_M * FOREARM_M


def forward(q: ArrayLike) -> Array:
    """Return flange poses in the base frame.

    Parameters
    ----------
    q : array-like, shape (..., 6)

    Returns
    -------
    poses : array, shape (..., 7)
    """
    q = np.asarray(q, dtype=float)
    out = np.empty((*q.shape[:-1], 7))
    _, wrist = arm_points(q)
    x, y, z, w = _turn(q)
    out[..., 3], out[..., 4], out[..., 5], out[..., 6] = x, y, z, w
    out[..., 0] = wrist[..., 0] + FLANGE_M * (1.0 - 2.0 * (y * y + z * z))
    out[..., 1] = wrist[..., 1] + FLANGE_M * 2.0 * (x * y + w * z)
    out[..., 2] = wrist[..., 2] + FLANGE_M * 2.0 * (x * z - w * y)
    return out


def arm_points(q: ArrayLike) -> tuple[Array, Array]:
    """Return where elbow and middle of the wrist are, each of shape (..., 3)."""
    q = np.asarray(q, dtype=float)
    c1, s1 = np.cos(q[..., 0]), np.sin(q[..., 0])
    ahead, up = UPPER_ARM_M * np.sin(q[..., 1]), BASE_M + UPPER_ARM_M * np.cos(q[..., 1])
    elbow = np.stack([ahead * c1, ahead * s1, up], axis=-1)
    pitch = q[..., 1] + q[..., 2] - math.pi / 2
    ahead, up = ahead + FOREARM_M * np.cos(pitch), up - FOREARM_M * np.sin(pitch)
    return elbow, np.stack([ahead * c1, ahead * s1, up], axis=-1)


def _turn(q: Array) -> tuple[Array, Array, Array, Array]:
    yaw, pitch = q[..., 0] / 2, (q[..., 1] + q[..., 2] - math.pi / 2) / 2
    cz, sz, cy, sy = np.cos(yaw), np.sin(yaw), np.cos(pitch), np.sin(pitch)
    ax, ay, az, aw = -sz * sy, cz * sy, sz * cy, cz * cy
    total, gap, bend = (q[..., 3] + q[..., 5]) / 2, (q[..., 3] - q[..., 5]) / 2, q[..., 4] / 2
    cb, sb = np.cos(bend), np.sin(bend)
    bx, by, bz, bw = cb * np.sin(total), sb * np.cos(gap), sb * np.sin(gap), cb * np.cos(total)
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def wrist_of(poses: ArrayLike) -> Array:
    """Return the middle of the wrist, shape (..., 3), for flange poses, shape (..., 7)."""
    p = np.asarray(poses, dtype=float)
    x, y, z, w = p[..., 3], p[..., 4], p[..., 5], p[..., 6]
    approach = [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)]
    return np.asarray(p[..., :3] - FLANGE_M * np.stack(approach, axis=-1))


def branch_of(q: ArrayLike) -> NDArray[np.int64]:
    """Return the branch, 0..7, that joint angles of shape (..., 6) are on."""
    q = np.asarray(q, dtype=float)
    ahead = UPPER_ARM_M * np.sin(q[..., 1]) + FOREARM_M * np.sin(q[..., 1] + q[..., 2])
    flags = (OVER_SHOULDER, ahead), (ELBOW_NEGATIVE, q[..., 2]), (WRIST_NEGATIVE, q[..., 4])
    return np.asarray(sum(bit * (value < 0) for bit, value in flags), dtype=np.int64)


def within_limits(q: ArrayLike) -> Flags:
    """Return for joint angles, shape (..., 6), whether every joint is within its limits."""
    return np.asarray(np.all(np.abs(q) <= LIMITS, axis=-1))


def limit_margin(q: ArrayLike) -> Array:
    """Return the distance to the nearest joint limit in rad, negative beyond, shape (...)."""
    return np.asarray(np.min(LIMITS - np.abs(q), axis=-1))


def inverse_all(poses: ArrayLike) -> Array:
    """Return the answers on all eight branches.

    Parameters
    ----------
    poses : array-like, shape (n, 7)

    Returns
    -------
    q : array, shape (n, 8, 6)
        Not checked against the limits; NaN where the pose is out of reach. Where the wrist
        is singular joints 4 and 6 share their turn evenly.
    """
    poses = np.asarray(poses, dtype=float)
    out = np.empty((BRANCHES, 6, len(poses)))
    for first in range(0, len(poses), _CHUNK):
        part = slice(first, first + _CHUNK)
        _solve(np.ascontiguousarray(poses[part].T), out[:, :, part])
    return out.transpose(2, 0, 1)


def _solve(poses: Array, out: Array) -> None:
    x, y, z, w = poses[3], poses[4], poses[5], poses[6]
    wx = poses[0] - FLANGE_M * (1.0 - 2.0 * (y * y + z * z))
    wy = poses[1] - FLANGE_M * 2.0 * (x * y + w * z)
    up = poses[2] - FLANGE_M * 2.0 * (x * z - w * y) - BASE_M
    square = wx * wx + wy * wy
    cosine = (square + up * up - _SUM_SQUARES) / _TWICE_PRODUCT
    cosine[np.abs(cosine) > 1.0] = np.nan
    sine = np.sqrt(1.0 - cosine * cosine)
    elbow = np.arctan2(sine, cosine)
    to_wrist = np.arctan2(np.sqrt(square), up)
    inside = np.arctan2(FOREARM_M * sine, UPPER_ARM_M + FOREARM_M * cosine)
    yaw = np.arctan2(wy, wx)
    behind = yaw - np.copysign(math.pi, yaw)
    first, second = to_wrist - inside, to_wrist + inside
    for number, q1, q2, q3 in (
        (0, yaw, first, elbow),
        (ELBOW_NEGATIVE, yaw, second, -elbow),
        (OVER_SHOULDER, behind, -second, elbow),
        (OVER_SHOULDER + ELBOW_NEGATIVE, behind, -first, -elbow),
    ):
        out[number, 0], out[number, 1], out[number, 2] = q1, q2, q3
        out[number + 1, :3] = out[number, :3]
        _solve_wrist(poses, q1, q2 + q3 - math.pi / 2, out[number], out[number + 1])


def _solve_wrist(poses: Array, q1: Array, pitch: Array, out: Array, flipped: Array) -> None:
    cz, sz, cy, sy = np.cos(q1 / 2), np.sin(q1 / 2), np.cos(pitch / 2), np.sin(pitch / 2)
    ax, ay, az, aw = sz * sy, -cz * sy, -sz * cy, cz * cy
    bx, by, bz, bw = poses[3], poses[4], poses[5], poses[6]
    x = aw * bx + ax * bw + ay * bz - az * by
    y = aw * by - ax * bz + ay * bw + az * bx
    z = aw * bz + ax * by - ay * bx + az * bw
    w = aw * bw - ax * bx - ay * by - az * bz
    bend = np.sqrt(y * y + z * z)
    half_sum, half_gap = np.arctan2(x, w), np.arctan2(z, y)
    half_gap[bend < SINGULAR_SINE] = 0.0
    out[3], out[5] = _wrapped(half_sum + half_gap), _wrapped(half_sum - half_gap)
    out[4] = 2.0 * np.arctan2(bend, np.sqrt(x * x + w * w))
    flipped[3], flipped[5] = _half_turned(out[3]), _half_turned(out[5])
    flipped[4] = -out[4]


def _wrapped(angle: Array) -> Array:
    return np.asarray(angle - 2.0 * math.pi * np.rint(angle / (2.0 * math.pi)))


def _half_turned(angle: Array) -> Array:
    return np.asarray(angle - np.copysign(math.pi, angle))


def inverse(
    pose: Sequence[float] | Array, branch: int, prefer: Sequence[float] | None = None
) -> Joints | None:
    """Return the answer for a single pose on one branch, fast; None if out of reach.

    Limits are not checked. In the wrist's singularity joint 4 is taken from `prefer`, six
    joint angles, else joints 4 and 6 share their turn evenly.
    """
    px, py, pz, x, y, z, w = pose.tolist() if isinstance(pose, np.ndarray) else pose
    wx = px - FLANGE_M * (1.0 - 2.0 * (y * y + z * z))
    wy = py - FLANGE_M * 2.0 * (x * y + w * z)
    up = pz - FLANGE_M * 2.0 * (x * z - w * y) - BASE_M
    square = wx * wx + wy * wy
    cosine = (square + up * up - _SUM_SQUARES) / _TWICE_PRODUCT
    if not -1.0 <= cosine <= 1.0:
        return None
    q1, ahead = math.atan2(wy, wx), math.sqrt(square)
    if branch & OVER_SHOULDER:
        q1, ahead = q1 - math.copysign(math.pi, q1), -ahead
    sine = math.sqrt(1.0 - cosine * cosine)
    if branch & ELBOW_NEGATIVE:
        sine = -sine
    inside = math.atan2(FOREARM_M * sine, UPPER_ARM_M + FOREARM_M * cosine)
    q2, q3 = math.atan2(ahead, up) - inside, math.atan2(sine, cosine)
    q4, q5, q6 = _wrist(x, y, z, w, q1, q2 + q3 - math.pi / 2, prefer)
    if branch & WRIST_NEGATIVE:
        q4, q5, q6 = q4 - math.copysign(math.pi, q4), -q5, q6 - math.copysign(math.pi, q6)
    return q1, q2, q3, q4, q5, q6


def _wrist(
    bx: float,
    by: float,
    bz: float,
    bw: float,
    q1: float,
    pitch: float,
    prefer: Sequence[float] | None,
) -> tuple[float, float, float]:
    cz, sz = math.cos(q1 / 2), math.sin(q1 / 2)
    cy, sy = math.cos(pitch / 2), math.sin(pitch / 2)
    ax, ay, az, aw = sz * sy, -cz * sy, -sz * cy, cz * cy
    x = aw * bx + ax * bw + ay * bz - az * by
    y = aw * by - ax * bz + ay * bw + az * bx
    z = aw * bz + ax * by - ay * bx + az * bw
    w = aw * bw - ax * bx - ay * by - az * bz
    bend = math.sqrt(y * y + z * z)
    half_sum, half_gap = math.atan2(x, w), math.atan2(z, y)
    if bend < SINGULAR_SINE:
        half_gap = 0.0 if prefer is None else prefer[3] - half_sum
    q4, q6 = half_sum + half_gap, half_sum - half_gap
    turn = 2.0 * math.pi
    q4, q6 = q4 - turn * round(q4 / turn), q6 - turn * round(q6 / turn)
    return q4, 2.0 * math.atan2(bend, math.sqrt(x * x + w * w)), q6
