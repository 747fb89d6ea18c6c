"""What each key asks of a driven hand."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from assistant.geometry import Array, quat_from_rotvec, quat_multiply

MOVES: Mapping[str, tuple[float, float, float]] = {
    "w": (1.0, 0.0, 0.0),
    "s": (-1.0, 0.0, 0.0),
    "a": (0.0, 1.0, 0.0),
    "d": (0.0, -1.0, 0.0),
    "r": (0.0, 0.0, 1.0),
    "f": (0.0, 0.0, -1.0),
}
TURNS: Mapping[str, tuple[float, float, float]] = {
    "q": (0.0, 0.0, 1.0),
    "e": (0.0, 0.0, -1.0),
    "t": (0.0, -1.0, 0.0),
    "g": (0.0, 1.0, 0.0),
    "z": (-1.0, 0.0, 0.0),
    "x": (1.0, 0.0, 0.0),
}
OPEN, CLOSE, FASTER, SLOWER, CLUTCH = "o", "c", "+", "-", " "


def directions(keys: Iterable[str]) -> tuple[Array, Array]:
    """Return the unit directions, shape (3,) each, that keys move and turn in together."""
    move = sum((np.array(MOVES[k]) for k in keys if k in MOVES), np.zeros(3))
    turn = sum((np.array(TURNS[k]) for k in keys if k in TURNS), np.zeros(3))
    return unit(move), unit(turn)


def stepped(tip: Array, move: Array, turn: Array) -> Array:
    """Return a pose moved along the base's axes and turned about them, shape (7,)."""
    return np.concatenate([tip[:3] + move, quat_multiply(quat_from_rotvec(turn), tip[3:])])


def unit(vector: Array) -> Array:
    """Return the direction of a vector, shape (3,); nothing of nothing."""
    length = float(np.linalg.norm(vector))
    return np.array(vector / length, dtype=float) if length > 0 else np.zeros(3)
