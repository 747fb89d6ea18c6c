"""What each key asks of a driven hand."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from assistant.geometry import Array, quat_from_rotvec, quat_inverse, quat_multiply, quat_to_rotvec

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
ABREAST = 1e-4
"""A place less far off than this, in m or rad, is reached."""
OPEN, CLOSE, LARGER, FINER, CLUTCH, POSTURE, BACK = "o", "c", "+", "-", " ", "h", "u"


def directions(keys: Iterable[str]) -> tuple[Array, Array]:
    """Return the unit directions, shape (3,) each, that keys move and turn in together."""
    move = sum((np.array(MOVES[k]) for k in keys if k in MOVES), np.zeros(3))
    turn = sum((np.array(TURNS[k]) for k in keys if k in TURNS), np.zeros(3))
    return unit(move), unit(turn)


def stepped(tip: Array, move: Array, turn: Array) -> Array:
    """Return a pose moved along the base's axes and turned about them, shape (7,)."""
    return np.concatenate([tip[:3] + move, quat_multiply(quat_from_rotvec(turn), tip[3:])])


def tapped(
    key: str, size: tuple[float, float], tip: Array, places: Iterable[Array]
) -> tuple[Array, Array]:
    """Return the step of a key, which ends abreast of a place it would pass.

    Parameters
    ----------
    key : str
    size : tuple of 2 floats
        Of a whole step, m and rad.
    tip : array, shape (7,)
        Where the fingers are.
    places : iterable of array, shape (7,)
        Where they are when a thing is grasped or let go.

    Returns
    -------
    move, turn : array, shape (3,) each
    """
    move, turn = directions((key,))
    left = [_between(tip, place) for place in places]
    move *= _shortened(size[0], [float(away @ move) for away, _ in left])
    turn *= _shortened(size[1], [float(angle @ turn) for _, angle in left])
    return move, turn


def _between(tip: Array, place: Array) -> tuple[Array, Array]:
    angle = quat_to_rotvec(quat_multiply(place[3:], quat_inverse(tip[3:])))
    return place[:3] - tip[:3], angle


def _shortened(step: float, left: Sequence[float]) -> float:
    return min((one for one in left if ABREAST < one < step), default=step)


def unit(vector: Array) -> Array:
    """Return the direction of a vector, shape (3,); nothing of nothing."""
    length = float(np.linalg.norm(vector))
    return np.array(vector / length, dtype=float) if length > 0 else np.zeros(3)
