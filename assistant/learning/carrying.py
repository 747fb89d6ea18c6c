"""What a way between two stretches is the weighted sum of, prepared once for a lesson.

Wherever the stretches at its ends are moved to, a way's places are rows known from the lesson
times weights that are the stretches' own: their turns and places, the turns of what the learned
way adds, the share of it that is evened out, and the presses outward. So a setup costs few
products of matrices, and squared jerk is a product of the weights alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array
from assistant.learning.clearing import Clearance, prepared
from assistant.learning.evening import even, third
from assistant.learning.rigid import Floats, Rows, left_factor
from assistant.learning.turning import Turn, nodes_between
from assistant.learning.weights import least_jerk, quintic

RIGID = slice(0, 4)
ADDED, EVENED, PRESSED = slice(4, 7), slice(7, 10), slice(10, 13)
OF_STRETCH, OF_WAY = 13, 22
"""Weights, each of xyz, that belong to a stretch; a way's are its first one's, then the next's."""
_LATER = [0.0] * 3 * (OF_STRETCH - 7)


@dataclass(frozen=True, slots=True, eq=False)
class Between:
    """The way from one stretch to the next, prepared once.

    Parameters
    ----------
    first, last : int
        Last sample of the one stretch, first of the other; those between are carried.
    inside : slice
        Where those stand among all that are carried.
    rows : array, shape (22, m)
        What the places of the samples carried are sums of, with weights as in `weights_of`.
    nodes : array, shape (nodes, m)
        See `nodes_between`.
    clear : Clearance or None
    at : array, shape (22, 5)
        The rows where the way begins, at the instants of `clear`, and where it ends.
    rough : array, shape (22, 22)
        Products of the rows' third differences.
    """

    first: int
    last: int
    inside: slice
    rows: Array
    nodes: Array
    clear: Clearance | None
    at: Array
    rough: Array


def between(
    path: Array, polar: bool, span: tuple[int, int], carried: int, most_m: float
) -> Between:
    """Return the way between two stretches.

    Parameters
    ----------
    path : array, shape (n, 7)
    polar : bool
        Whether the way is kept clear of the base's axis.
    span : (first, last)
        As in `Between`.
    carried : int
        Number of samples of the ways before.
    most_m : float
        See `even`.
    """
    first, last = span
    length = max(last - first, 1)
    share = np.arange(1, length) / length
    joining, ends = quintic(share, length), (_end(path, first), _end(path, last))
    added = path[first + 1 : first + length, :3] - joining @ np.vstack(ends)
    cleared = prepared(path[first : last + 1, :2], share) if polar else None
    rows = np.zeros((OF_WAY, length - 1))
    made = least_jerk(share)
    for part, end, weights in ((0, ends[0], joining[:, :3]), (1, ends[1], joining[:, 3:])):
        rows[OF_STRETCH * part :][RIGID] = np.vstack([(weights @ end).T, weights[:, 0]])
    _add(rows, ADDED, added, made)
    _add(rows, EVENED, even(added, share, most_m) - added, made)
    if cleared is not None:
        rows[PRESSED] = cleared[1].T
    rough = third(rows)
    return Between(
        first,
        last,
        slice(carried, carried + length - 1),
        rows,
        nodes_between(made),
        cleared[0] if cleared is not None else None,
        _places(rows, ends, cleared[0].at if cleared is not None else [-1] * 3),
        rough @ rough.T,
    )


def weights_of(
    turning: Sequence[Rows], moves: Sequence[Floats], by: Sequence[Turn]
) -> tuple[Array, Array, Array]:
    """Return the weights of each stretch's rows, of each way's, and each stretch's turn.

    Returns
    -------
    of_stretches : array, shape (stretches, 13, 3)
        The columns of its turn and its shift; the turns of x, y and z of what the learned way
        adds; then, all zero here, the same times the share evened out; and the three presses.
    of_ways : array, shape (stretches - 1, 22, 3)
        The same memory.
    factors : array, shape (stretches, 4, 4)
        What turns a quaternion with the stretch.
    """
    flat: list[float] = []
    factors: list[float] = []
    for ((a, b, c), (d, e, f), (g, h, i)), move, turn in zip(turning, moves, by, strict=True):
        cos, sin = turn.cos, turn.sin
        flat += a, d, g, b, e, h, c, f, i, *move[:3]
        flat += cos, sin, 0.0, -sin, cos, 0.0, 0.0, 0.0, 1.0, *_LATER
        factors += left_factor(move[3:])
    rows = np.fromiter(flat, float).reshape(-1, OF_STRETCH, 3)
    of_ways = np.ndarray((len(by) - 1, OF_WAY, 3), rows.dtype, rows, 0, rows.strides)
    return rows, of_ways, np.fromiter(factors, float).reshape(-1, 4, 4)


def _add(rows: Array, here: slice, added: Array, made: Array) -> None:
    """Set the rows of what turns from the first stretch's turn to the next one's."""
    x, y, z = added.T
    rows[here] = (1.0 - made) * x, (1.0 - made) * y, z
    there = slice(OF_STRETCH + here.start, OF_STRETCH + here.start + 2)
    rows[there] = made * x, made * y


def _end(path: Array, end: int) -> Array:
    """Return value, slope and curvature at a sample, one row each, a sample's step being 1."""
    # They are taken from its two neighbors; at the path's own ends the sample itself stands in
    # for the missing one.
    before, here, after = path[np.clip([end - 1, end, end + 1], 0, len(path) - 1), :3]
    return np.stack([here, (after - before) / 2.0, before - 2.0 * here + after])


def _places(rows: Array, ends: tuple[Array, Array], at: Sequence[int]) -> Array:
    """Return the rows at a way's beginning, at three samples, and at its end."""
    found = np.zeros((OF_WAY, 5))
    found[RIGID, 0] = *ends[0][0], 1.0
    found[OF_STRETCH:, 4][RIGID] = *ends[1][0], 1.0
    if rows.shape[1]:
        found[:, 1:4] = rows[:, at]
    return found
