"""Searches a way between two postures among random joint angles: two trees that meet.

Used where no simple detour is free. The generator is seeded, so the same task always goes the
same way. Source: RRT-Connect (Kuffner and LaValle, 2000).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from assistant.geometry import Array
from sim import a465

STEP_RAD = 0.06
"""Between samples that are checked."""
REACH_RAD = 0.9
"""The longest branch grown at once."""
TRIES = 220
SHORTCUTS = 40
ROUND = 0.06
"""Share of the way over which its corners are rounded."""

Gap = Callable[[Array], Array]


def searched(start: Array, end: Array, gap: Gap, samples: int) -> Array | None:
    """Return a free way of joints, shape (samples, 6), or None if none was found."""
    random = np.random.default_rng(465)
    if not _free(np.stack([start, end]), gap):
        return None
    corners = _connected(start, end, gap, random)
    if corners is None:
        return None
    corners = _shortened(corners, gap, random)
    for share in (ROUND, ROUND / 3):
        way = _rounded(corners, samples, share)
        if _free(filled(way), gap):
            return way
    return None


def filled(q: Array) -> Array:
    """Return joints, shape (m, 6), with more between them where they are far apart.

    What is carried out goes through them as a spline does, so that is looked at.
    """
    from scipy.interpolate import CubicSpline

    steps = np.abs(np.diff(q, axis=0)).max(axis=1, initial=0.0)
    counts = np.maximum(np.ceil(steps / STEP_RAD), 1.0)
    if not np.any(counts > 1.0):
        return q
    index = np.concatenate([[0.0], np.cumsum(counts)])
    at = np.interp(np.arange(index[-1] + 1.0), index, np.arange(len(q)))
    return np.asarray(CubicSpline(np.arange(len(q)), q)(at))


def _free(q: Array, gap: Gap) -> bool:
    return bool(np.all(np.abs(q) <= a465.LIMITS)) and bool(gap(q).min() >= 0.0)


def _line(first: Array, second: Array) -> Array:
    count = max(int(np.ceil(np.abs(second - first).max() / STEP_RAD)), 1) + 1
    return np.linspace(first, second, count)


def _connected(
    start: Array, end: Array, gap: Gap, random: np.random.Generator
) -> list[Array] | None:
    trees = ([start], [end])
    parents: tuple[list[int], list[int]] = ([-1], [-1])
    side = 0
    for turn in range(TRIES):
        other = 1 - side
        aim = trees[other][0] if turn < 2 else random.uniform(-1.0, 1.0, a465.JOINTS) * a465.LIMITS
        node = _grown(trees[side], parents[side], aim, gap)
        if node is not None:
            met = _reached(trees[other], parents[other], trees[side][node], gap)
            if met is not None:
                ways = (
                    _back(trees[side], parents[side], node),
                    _back(trees[other], parents[other], met),
                )
                first, second = ways if side == 0 else ways[::-1]
                return first[::-1] + second[1:]
        side = other
    return None


def _nearest(tree: list[Array], aim: Array) -> int:
    return int(np.argmin(np.sum(np.square(np.array(tree) - aim), axis=1)))


def _grown(tree: list[Array], parents: list[int], aim: Array, gap: Gap) -> int | None:
    near = _nearest(tree, aim)
    step = aim - tree[near]
    step = step * min(1.0, REACH_RAD / max(float(np.abs(step).max()), 1e-9))
    if not _free(_line(tree[near], tree[near] + step), gap):
        return None
    tree.append(tree[near] + step)
    parents.append(near)
    return len(tree) - 1


def _reached(tree: list[Array], parents: list[int], aim: Array, gap: Gap) -> int | None:
    while (node := _grown(tree, parents, aim, gap)) is not None:
        if np.abs(tree[node] - aim).max() < 1e-9:
            return node
    return None


def _back(tree: list[Array], parents: list[int], node: int) -> list[Array]:
    way = [tree[node]]
    while (node := parents[node]) >= 0:
        way.append(tree[node])
    return way


def _shortened(corners: list[Array], gap: Gap, random: np.random.Generator) -> list[Array]:
    for _ in range(SHORTCUTS):
        if len(corners) < 3:
            break
        first, second = sorted(random.choice(len(corners), 2, replace=False).tolist())
        if second - first > 1 and _free(_line(corners[first], corners[second]), gap):
            corners = corners[: first + 1] + corners[second:]
    return corners


def _rounded(corners: list[Array], samples: int, share: float) -> Array:
    from scipy.ndimage import uniform_filter1d

    points = np.array(corners)
    lengths = np.max(np.abs(np.diff(points, axis=0)) / a465.SPEEDS, axis=1)
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    s = np.linspace(0.0, 1.0, samples)
    eased = s**3 * (10.0 - 15.0 * s + 6.0 * s * s) * along[-1]
    way = np.stack([np.interp(eased, along, points[:, k]) for k in range(6)], axis=1)
    width = max(int(share * samples), 1)
    for _ in range(2):
        way = uniform_filter1d(way, width, axis=0, mode="nearest")
    way[0], way[-1] = points[0], points[-1]
    return np.asarray(way)
