"""The default blending: stretches kept rigid, the ways between carried with least jerk.

Around each station the path is moved rigidly with its object or target. Between two stations
goes the curve of least jerk that joins both ends with their speed and acceleration, the
quintic. What the learned way adds to the quintic between its own ends is added to it, turned with
the stretches. Where a way would cut across the base it is pressed outward, and where a far
setup costs jerk, what was added is evened out as far as needed.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array
from assistant.learning.clearing import Clearance, prepared, presses
from assistant.learning.evening import even, share_needed, third
from assistant.learning.rigid import Floats, Rows, carrier, matrix, moved
from assistant.learning.turning import Turn, summed, turned, turns
from assistant.learning.weights import least_jerk, quintic
from assistant.model.settings import BlendingSettings

Span = tuple[int, int]


@dataclass(frozen=True, slots=True, eq=False)
class Between:
    """The way from one stretch to the next, prepared once.

    Parameters
    ----------
    first, last : int
        Last sample of the one stretch, first of the other; those between are carried.
    inside : slice
        Where those stand among all that are carried.
    curves : array, shape (11 or 14, m)
        Weights of value, slope and curvature (a sample's step being 1) at both ends; what the
        learned way adds, as rows of `_by_turn`; weights of the three presses outward.
    evening : array, shape (5, m)
        What evens out that which the learned way adds, as rows of `_by_turn`.
    share : array, shape (2, m)
        Share of the turn made, and 1.
    quats : array, shape (4, m)
    ends : two times three rows of three floats
        xyz of the sample at either end, between its two neighbors.
    clear : Clearance or None
    """

    first: int
    last: int
    inside: slice
    curves: Array
    evening: Array
    share: Array
    quats: Array
    ends: tuple[Rows, Rows]
    clear: Clearance | None


@dataclass(frozen=True, slots=True, eq=False)
class Ways:
    """A learned path prepared for blending.

    Parameters
    ----------
    path : array, shape (n, 7)
    held : tuple of (first, last)
        Stretches that keep their shape: the start, each station, perhaps the end.
    stretches : array, shape (m, 8), for each
        Their xyz, 1 and quaternion.
    middles : three floats a stretch
        A place within each, whose azimuth the hand's turning follows.
    polar : bool
        Whether the ways turn with the azimuth about the base and are kept clear of it.
    keep : float
        See `BlendingSettings.keep_out`.
    between : tuple of Between
        One fewer than `held`.
    carried : int
        Number of all samples between stretches.
    most : float
        Sum of squared third differences allowed there.
    onward : frozenset of int
        See `turns`.
    """

    path: Array
    held: tuple[Span, ...]
    stretches: tuple[Array, ...]
    middles: Rows
    polar: bool
    keep: float
    between: tuple[Between, ...]
    carried: int
    most: float
    onward: frozenset[int] = frozenset()


def prepare(
    path: Array,
    held: tuple[Span, ...],
    settings: BlendingSettings,
    shown_jerk: float = math.inf,
    onward: frozenset[int] = frozenset(),
) -> Ways:
    """Return what `smooth_way` needs and does not depend on a setup.

    Parameters
    ----------
    path : array, shape (n, 7)
    held : tuple of (first, last)
        In order; the first begins at sample 0, the last ends at n - 1.
    settings : BlendingSettings
    shown_jerk : float
        Root mean square of the demonstration's jerk in m, a sample's step being 1; without it
        nothing is evened out.
    onward : frozenset of int
        See `turns`.
    """
    polar = bool(np.min(np.hypot(path[:, 0], path[:, 1])) >= settings.least_radius_m)
    between: list[Between] = []
    carried = 0
    for (_, first), (last, _) in itertools.pairwise(held):
        between.append(_between(path, polar, (first, last), carried, settings.even_m))
        carried = between[-1].inside.stop
    rows = np.hstack([path[:, :3], np.ones((len(path), 1)), path[:, 3:]])
    most = (settings.jerk_share * shown_jerk) ** 2 * max(len(path) - 3, 0)
    return Ways(
        path,
        held,
        tuple(rows[first : last + 1].copy() for first, last in held),
        [path[last, :3].tolist() for _, last in held],
        polar,
        settings.keep_out,
        tuple(between),
        carried,
        most - _held_jerk(path, between),
        onward,
    )


def smooth_way(ways: Ways, moves: Sequence[Floats]) -> Array:
    """Return the path with each held stretch moved rigidly and the ways between carried.

    Parameters
    ----------
    ways : Ways
    moves : seven floats a stretch
        How each stretch moves, in the world.

    Returns
    -------
    path : array, shape (n, 7)
        Exact on the held stretches. The hand turns with the azimuth of its surroundings, and
        relative to it along the shorter arc; a half turn relative to it is made to the left
        (counterclockwise seen from above).
    """
    out = np.empty_like(ways.path)
    turning = [matrix(move[3:]) for move in moves]
    for k, (first, last) in enumerate(ways.held):
        rigid = np.array(carrier(turning[k], moves[k])).reshape(8, 7)
        np.matmul(ways.stretches[k], rigid, out=out[first : last + 1])
    if ways.carried:
        _carry(ways, turning, moves, out)
    return out


def _between(path: Array, polar: bool, span: Span, carried: int, most_m: float) -> Between:
    first, last = span
    length = max(last - first, 1)
    share = np.arange(1, length) / length
    inside = slice(first + 1, first + length)
    ends = _about(path, first), _about(path, last)
    joining = quintic(share, length)
    details = path[inside, :3] - joining @ np.array([*_end(ends[0]), *_end(ends[1])])
    cleared = prepared(path[first : last + 1, :2], joining, details, share) if polar else None
    made = least_jerk(share)
    bumps = [] if cleared is None else [cleared[1].T]
    return Between(
        first,
        last,
        slice(carried, carried + length - 1),
        np.vstack([joining.T, _by_turn(details, made), *bumps]),
        _by_turn(even(details, share, most_m) - details, made),
        np.stack([made, np.ones(len(share))]),
        np.ascontiguousarray(path[inside, 3:].T),
        ends,
        cleared[0] if cleared is not None else None,
    )


def _by_turn(details: Array, made: Array) -> Array:
    """Return rows, shape (5, m), that weights as in `_turned_details` turn and sum up."""
    x, y, z = details.T
    return np.stack([(1.0 - made) * x, (1.0 - made) * y, made * x, made * y, z])


def _turned_details(here: Turn, there: Turn) -> Rows:
    """Return the weights of the rows of `_by_turn`, each in x, y and z."""
    return [
        [here.cos, here.sin, 0.0],
        [-here.sin, here.cos, 0.0],
        [there.cos, there.sin, 0.0],
        [-there.sin, there.cos, 0.0],
        [0.0, 0.0, 1.0],
    ]


def _held_jerk(path: Array, between: Sequence[Between]) -> float:
    """Return the sum of squared third differences that reach out of the ways."""
    squares = np.sum(third(path[:, :3].T) ** 2, axis=0)
    for way in between:
        squares[way.first + 1 : max(way.last - 3, way.first + 1)] = 0.0
    return float(np.sum(squares))


def _about(path: Array, end: int) -> Rows:
    # Slope and curvature at an end are taken from its two neighbors; at the path's own ends
    # the sample itself stands in for the missing one.
    samples = np.clip([end - 1, end, end + 1], 0, len(path) - 1)
    rows: Rows = path[samples, :3].tolist()
    return rows


def _end(about: Rows) -> Rows:
    """Return value, slope and curvature at the middle one of three samples, one row each."""
    (xa, ya, za), (x, y, z), (xb, yb, zb) = about
    return [
        [x, y, z],
        [(xb - xa) / 2.0, (yb - ya) / 2.0, (zb - za) / 2.0],
        [xa - 2.0 * x + xb, ya - 2.0 * y + yb, za - 2.0 * z + zb],
    ]


def _carry(ways: Ways, turning: Sequence[Rows], moves: Sequence[Floats], out: Array) -> None:
    """Carry all samples between stretches at once: small arrays cost more than long ones."""
    carried, halves, terms = (np.empty((rows, ways.carried)) for rows in (3, 2, 16))
    by = turns(ways.middles, turning, moves, ways.polar, ways.onward)
    for k, way in enumerate(ways.between):
        here, there = by[k], by[k + 1]
        rows = _end(moved(way.ends[0], turning[k], moves[k]))
        rows += _end(moved(way.ends[1], turning[k + 1], moves[k + 1]))
        outward = presses(way.clear, rows, (here, there), ways.keep) if way.clear else []
        rows += _turned_details(here, there) + outward
        np.matmul(np.array(rows).T, way.curves, out=carried[:, way.inside])
        angles, factors = turned(here, there)
        np.matmul(np.array(angles), way.share, out=halves[:, way.inside])
        np.matmul(np.array(factors), way.quats, out=terms[:, way.inside])
    rough = _third(ways, carried)
    if np.vdot(rough, rough) > ways.most:
        carried += _evened(ways, by, rough)
    quats = summed(halves, terms.reshape(4, 4, ways.carried))
    for way in ways.between:
        free = out[way.first + 1 : way.last]
        free[:, :3], free[:, 3:] = carried[:, way.inside].T, quats[:, way.inside].T


def _evened(ways: Ways, by: Sequence[Turn], rough: Array) -> Array:
    """Return what to add to the ways so that they are not rougher than allowed, shape (3, l)."""
    change = np.empty((3, ways.carried))
    for k, way in enumerate(ways.between):
        rows = np.array(_turned_details(by[k], by[k + 1]))
        np.matmul(rows.T, way.evening, out=change[:, way.inside])
    return share_needed(rough, _third(ways, change), ways.most) * change


def _third(ways: Ways, rows: Array) -> Array:
    """Return third differences within the ways; those that span two count as nothing."""
    found = third(rows)
    for way in ways.between[:-1]:
        found[:, max(way.inside.stop - 3, 0) : way.inside.stop] = 0.0
    return found
