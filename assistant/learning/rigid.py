"""Rigid motions on plain floats: for single poses many times quicker than small arrays.

Poses are tuples of seven floats, xyz in m and quaternion xyzw, as in `assistant.geometry`,
which does the same for arrays and is what these are tested against.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

Floats = Sequence[float]
Rows = list[list[float]]
_HALF_RAD = math.pi / 360.0


def multiply(a: Floats, b: Floats) -> list[float]:
    """Return the product of two quaternions xyzw: turn by `b`, then by `a`."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return [
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    ]


def matrix(quat: Floats) -> Rows:
    """Return the rotation matrix, row by row, of a unit quaternion xyzw."""
    x, y, z, w = quat
    return [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]


def left_factor(quat: Floats) -> list[float]:
    """Return the 4 by 4 matrix, row by row, that multiplies a quaternion from the left."""
    x, y, z, w = quat
    return [w, -z, y, x, z, w, -x, y, -y, x, w, z, -x, -y, -z, w]


def turned(quat: Floats, vector: Floats) -> list[float]:
    """Return a vector turned by a unit quaternion xyzw."""
    x, y, z, w = quat
    vx, vy, vz = vector
    tx, ty, tz = 2.0 * (y * vz - z * vy), 2.0 * (z * vx - x * vz), 2.0 * (x * vy - y * vx)
    return [
        vx + w * tx + y * tz - z * ty,
        vy + w * ty + z * tx - x * tz,
        vz + w * tz + x * ty - y * tx,
    ]


def composed(parent: Floats, child: Floats) -> list[float]:
    """Return the pose of a child given in its parent, seen from the world."""
    px, py, pz, ax, ay, az, aw = parent
    vx, vy, vz, bx, by, bz, bw = child
    tx, ty, tz = 2.0 * (ay * vz - az * vy), 2.0 * (az * vx - ax * vz), 2.0 * (ax * vy - ay * vx)
    return [
        px + vx + aw * tx + ay * tz - az * ty,
        py + vy + aw * ty + az * tx - ax * tz,
        pz + vz + aw * tz + ax * ty - ay * tx,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    ]


def inverted(pose: Floats) -> list[float]:
    """Return the inverse pose."""
    back = [-pose[3], -pose[4], -pose[5], pose[6]]
    x, y, z = turned(back, pose[:3])
    return [-x, -y, -z, *back]


def placed(xyz_mm: Floats, rpy_deg: Floats) -> list[float]:
    """Return the pose told in mm and in degrees about fixed x, then y, then z."""
    x_mm, y_mm, z_mm = xyz_mm
    roll, pitch, yaw = rpy_deg
    roll, pitch, yaw = _HALF_RAD * roll, _HALF_RAD * pitch, _HALF_RAD * yaw
    cr, cp, cy = math.cos(roll), math.cos(pitch), math.cos(yaw)
    sr, sp, sy = math.sin(roll), math.sin(pitch), math.sin(yaw)
    return [
        x_mm / 1000.0,
        y_mm / 1000.0,
        z_mm / 1000.0,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    ]


def arc(quat: Floats) -> tuple[list[float], float]:
    """Return axis and angle, in rad within [0, pi], of the shorter way a quaternion turns.

    A half turn is made to the left, counterclockwise about an axis with z above zero. Without
    a turn the axis is zero.
    """
    x, y, z, w = quat if quat[3] >= 0.0 else [-one for one in quat]
    sine = math.sqrt(x * x + y * y + z * z)
    if sine < 1e-15:
        return [0.0, 0.0, 0.0], 0.0
    angle = 2.0 * math.atan2(sine, w)
    sign = -1.0 if angle > math.pi - 1e-9 and z < 0.0 else 1.0
    return [sign * x / sine, sign * y / sine, sign * z / sine], angle
