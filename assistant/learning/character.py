"""The main motion of an episode in words of the robot's frame (paper III-A, III-B (a))."""

from __future__ import annotations

import numpy as np

from assistant.geometry import (
    Array,
    quat_inverse,
    quat_multiply,
    quat_to_rotvec,
)
from assistant.learning.smoothing import Smoothed
from assistant.model.directions import WAYS

_TURNS = ("left", "right", "up", "down")
_CLEAR = 0.6
_RAD_AS_M = 0.1


def character(smoothed: Smoothed, from_s: float, to_s: float) -> str:
    """Return the main motion between two instants: "down", "turn left", "rest", or empty."""
    way, turn = change(smoothed, from_s, to_s)
    far, turned = float(np.linalg.norm(way)), float(np.linalg.norm(turn))
    extent = float(np.linalg.norm(np.ptp(smoothed.path[:, :3], axis=0)))
    if far < 0.01 * extent and turned < 0.03:
        return "rest"
    if far >= _RAD_AS_M * turned:
        name, share = max(
            ((name, float(way @ np.array(axis)) / far) for name, axis in WAYS.items()),
            key=lambda told: told[1],
        )
        return name if share > _CLEAR else ""
    axes = {"left": (0, 0, 1), "right": (0, 0, -1), "up": (0, -1, 0), "down": (0, 1, 0)}
    name, share = max(
        ((name, float(turn @ np.array(axes[name], dtype=float)) / turned) for name in _TURNS),
        key=lambda told: told[1],
    )
    return f"turn {name}" if share > _CLEAR else ""


def change(smoothed: Smoothed, from_s: float, to_s: float) -> tuple[Array, Array]:
    """Return displacement in m and rotation vector in rad between two instants, base frame."""
    last = len(smoothed.t_s) - 1
    a, b = np.clip(np.searchsorted(smoothed.t_s, [from_s, to_s]), 0, last)
    start, stop = smoothed.path[a], smoothed.path[b]
    turn = quat_to_rotvec(quat_multiply(stop[3:], quat_inverse(start[3:])))
    return stop[:3] - start[:3], turn
