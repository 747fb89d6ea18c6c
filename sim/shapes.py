"""Boxes and segments in space, many at a time: how far apart they are.

Distances are signed bounds: positive where two things are apart (never more than the true
gap), zero or negative where they touch or overlap.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, compose, pose_from_mm_deg, quat_to_matrix
from assistant.model.scene import Body, Obstacle
from assistant.model.setup import Triple

_STEADY_M = 1e-9
"""A segment that goes no further along an axis passes no side of a box."""


@dataclass(frozen=True, slots=True, eq=False)
class Boxes:
    """A box at many places, or at one.

    Parameters
    ----------
    center : array, shape (m, 3) or (1, 3)
    turn : array, shape (m, 3, 3) or (1, 3, 3)
        Columns are the box's axes.
    half : array, shape (3,)
        Half of each edge.
    """

    center: Array
    turn: Array
    half: Array

    @property
    def radius(self) -> float:
        """The radius of the ball around it."""
        return float(np.sqrt(np.sum(self.half**2)))

    def at(self, chosen: np.ndarray[tuple[int], np.dtype[np.int64]]) -> Boxes:
        """Return only the chosen places; a box that stands still stays as it is."""
        if len(self.center) == 1:
            return self
        return Boxes(self.center[chosen], self.turn[chosen], self.half)


def box_at(poses: Array, middle: Triple | Array, size: Triple | Array) -> Boxes:
    """Return a box of a size whose middle is given in frames at `poses`, shape (m, 7)."""
    poses = np.atleast_2d(poses)
    turn = quat_to_matrix(poses[:, 3:])
    center = poses[:, :3] + turn @ np.asarray(middle, dtype=float)
    return Boxes(center, turn, np.asarray(size, dtype=float) / 2)


def body_box(body: Body, poses: Array) -> Boxes:
    """Return the box around a body whose base's middle is at `poses`, shape (m, 7) or (7,)."""
    size = np.array(body.size_mm) / 1000.0
    # A sphere's "base" is the point it rests on, so its middle is half its size up, too.
    return box_at(poses, np.array([0.0, 0.0, size[2] / 2]), size)


def obstacle_box(obstacle: Obstacle) -> Boxes:
    """Return the box of a table or obstacle."""
    size = np.array(obstacle.size_mm) / 1000.0
    pose = pose_from_mm_deg(obstacle.xyz_mm, obstacle.rpy_deg)
    return box_at(compose(pose, _raised(size[2] / 2)), (0.0, 0.0, 0.0), size)


def _raised(height: float) -> Array:
    return np.array([0.0, 0.0, height, 0.0, 0.0, 0.0, 1.0])


def boxes_apart(first: Boxes, second: Boxes) -> Array:
    """Return how far boxes are apart, shape (m,), by the axes that can separate them."""
    offset = np.einsum("...k,...kj->...j", first.center - second.center, second.turn)
    turn = np.swapaxes(second.turn, -1, -2) @ first.turn
    size = np.abs(turn)
    a, b = first.half, second.half
    faces = np.abs(offset) - b - size @ a
    along = np.einsum("...i,...ij->...j", offset, turn)
    others = np.abs(along) - a - np.einsum("...ij,i->...j", size, b)
    apart = np.maximum(faces.max(axis=-1), others.max(axis=-1))
    near = np.flatnonzero(apart < 0)
    if len(near):
        apart[near] = _edges_apart(offset[near], turn[near], size[near], a, b, apart[near])
    return np.asarray(apart)


def _edges_apart(offset: Array, turn: Array, size: Array, a: Array, b: Array, best: Array) -> Array:
    for i in range(3):
        k, m = (i + 1) % 3, (i + 2) % 3
        for j in range(3):
            n, o = (j + 1) % 3, (j + 2) % 3
            long = np.sqrt(np.maximum(1.0 - turn[:, i, j] ** 2, 0.0))
            gap = np.abs(offset[:, m] * turn[:, k, j] - offset[:, k] * turn[:, m, j])
            wide = b[k] * size[:, m, j] + b[m] * size[:, k, j]
            wide = wide + a[n] * size[:, i, o] + a[o] * size[:, i, n]
            # Parallel edges span no axis of their own: the faces decide.
            usable = long > 1e-6
            best = np.where(
                usable, np.maximum(best, (gap - wide) / np.where(usable, long, 1)), best
            )
    return best


def segment_apart(start: Array, end: Array, box: Boxes) -> Array:
    """Return the distance of segments, ends of shape (m, 3), to a box, shape (m,); 0 inside.

    Squared, it is convex along a segment, and a parabola from where one side of the box is
    passed to where the next is: so the least is where its slope, led straight between these
    places, comes through zero.
    """
    first = np.einsum("...k,...kj->...j", start - box.center, box.turn)
    span = np.einsum("...k,...kj->...j", end - start, box.turn)
    steady = np.where(np.abs(span) < _STEADY_M, _STEADY_M, span)
    passed = np.concatenate([box.half - first, -box.half - first], axis=1)
    share = np.zeros((len(first), 8))
    share[:, 1:7] = np.sort(np.clip(passed / np.tile(steady, 2), 0.0, 1.0), axis=1)
    share[:, 7] = 1.0
    points = first[:, None, :] + share[..., None] * span[:, None, :]
    outside = points - np.clip(points, -box.half, box.half)
    slope = np.einsum("...k,...k->...", outside, span[:, None, :])
    rows = np.arange(len(first))
    after = np.where(slope[:, 7] >= 0.0, np.argmax(slope >= 0.0, axis=1), 7)
    before = np.maximum(after - 1, 0)
    falls, rises = slope[rows, before], slope[rows, after]
    through = np.clip(-falls / np.maximum(rises - falls, _STEADY_M**2), 0.0, 1.0)
    at = share[rows, before] + through * (share[rows, after] - share[rows, before])
    nearest = first + at[:, None] * span
    return np.asarray(np.linalg.norm(nearest - np.clip(nearest, -box.half, box.half), axis=1))
