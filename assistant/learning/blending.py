"""Blending of the learned path in several frames, as the paper prints it and close to it.

The default scheme is `assistant.learning.ways`; these are kept to compare with and to choose.
Source: paper III-D a, eq. (6).
"""

from __future__ import annotations

import numpy as np

from assistant.geometry import Array, compose, interpolate
from assistant.learning.ways import Span
from assistant.learning.weights import FrameWeights, least_jerk


def eq6_way(world: Array, seen: Array, moves: Array, start: Array, weights: FrameWeights) -> Array:
    """Return the path blended as in eq. (6), with quaternions.

    Parameters
    ----------
    world : array, shape (n, 7)
        X_i, the term of the world frame.
    seen : array, shape (n, 7)
        The learned path that each station's move is applied to.
    moves : array, shape (stations, 7)
        How each station has moved, in the world.
    start : array, shape (7,)
        Y, latched when motion starts.
    weights : FrameWeights

    Notes
    -----
    A half turn follows the sign of the second quaternion as it is given.
    """
    near = compose(moves[weights.near], seen)
    behind = compose(moves[np.maximum(weights.left, 0)], seen)
    behind = np.where(weights.left[:, None] < 0, start, behind)
    return interpolate(interpolate(world, behind, weights.lambda2), near, weights.lambda1)


def two_frame_way(path: Array, moves: Array, held: tuple[Span, ...]) -> Array:
    """Return the path blended from each stretch's frame straight into the next one's.

    Parameters
    ----------
    path : array, shape (n, 7)
    moves : array, shape (len(held), 7)
    held : tuple of (first, last)
    """
    first, share = _positions(len(path), held)
    here = compose(moves[first], path)
    there = compose(moves[np.minimum(first + 1, len(held) - 1)], path)
    return interpolate(here, there, share)


def azimuth_turned(path: Array, moves: Array, held: tuple[Span, ...]) -> Array:
    """Return the world path turned about the base with the azimuth of start and stations."""
    middles = path[[last for _, last in held]]
    after = compose(moves, middles)
    angles = np.arctan2(after[:, 1], after[:, 0]) - np.arctan2(middles[:, 1], middles[:, 0])
    first, share = _positions(len(path), held)
    following = angles[np.minimum(first + 1, len(held) - 1)]
    half = (angles[first] + (following - angles[first]) * share) / 2.0
    pivots = np.zeros((len(path), 7))
    pivots[:, 5], pivots[:, 6] = np.sin(half), np.cos(half)
    return compose(pivots, path)


def _positions(
    samples: int, held: tuple[Span, ...]
) -> tuple[np.ndarray[tuple[int], np.dtype[np.int64]], Array]:
    """Return, for each sample, the stretch left behind and the share of the way to the next."""
    first = np.zeros(samples, dtype=np.int64)
    share = np.zeros(samples)
    for k, (_, last) in enumerate(held):
        first[last:] = k
        if k + 1 < len(held):
            following = held[k + 1][0]
            way = np.arange(last, following + 1)
            share[way] = least_jerk((way - last) / max(following - last, 1))
            first[following:] = k + 1
            share[following:] = 0.0
    return first, share
