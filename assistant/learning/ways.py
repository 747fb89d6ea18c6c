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
from assistant.learning.carrying import (
    ADDED,
    EVENED,
    OF_WAY,
    PRESSED,
    RIGID,
    Between,
    between,
    weights_of,
)
from assistant.learning.clearing import presses
from assistant.learning.evening import share_needed, third
from assistant.learning.rigid import Floats, Rows, matrix
from assistant.learning.turning import SUMMED, Turn, products, turned, turns
from assistant.model.settings import BlendingSettings

Span = tuple[int, int]


@dataclass(frozen=True, slots=True, eq=False)
class Ways:
    """A learned path prepared for blending.

    Parameters
    ----------
    path : array, shape (n, 7)
    held : tuple of (first, last)
        Stretches that keep their shape: the start, each station, perhaps the end.
    stretches : arrays of shape (4, m) and (4, m), for each
        Their xyz and 1, and their quaternions.
    middles : three floats a stretch
        A place within each, whose azimuth the hand's turning follows.
    polar : bool
        Whether the ways turn with the azimuth about the base and are kept clear of it.
    keep : float
        See `BlendingSettings.keep_out`.
    between : tuple of Between
        One fewer than `held`.
    quats : array, shape (4, l)
        Of all samples carried.
    at : array, shape (ways, 5, 22)
    rough : array, shape (ways, 22, 22)
        As in `Between`.
    most : float
        Sum of squared third differences allowed between the stretches.
    onward : frozenset of int
        See `turns`.
    """

    path: Array
    held: tuple[Span, ...]
    stretches: tuple[tuple[Array, Array], ...]
    middles: Rows
    polar: bool
    keep: float
    between: tuple[Between, ...]
    quats: Array
    at: Array
    rough: Array
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
    ways: list[Between] = []
    carried = 0
    for (_, first), (last, _) in itertools.pairwise(held):
        ways.append(between(path, polar, (first, last), carried, settings.even_m))
        carried = ways[-1].inside.stop
    columns = np.vstack([path[:, :3].T, np.ones(len(path)), path[:, 3:].T])
    parts = [columns[:, first : last + 1] for first, last in held]
    inside = [columns[4:, way.first + 1 : way.last] for way in ways]
    most = (settings.jerk_share * shown_jerk) ** 2 * max(len(path) - 3, 0)
    return Ways(
        path=path,
        held=held,
        stretches=tuple((part[:4].copy(), part[4:].copy()) for part in parts),
        middles=[path[last, :3].tolist() for _, last in held],
        polar=polar,
        keep=settings.keep_out,
        between=tuple(ways),
        quats=np.hstack([np.zeros((4, 0)), *inside]),
        at=np.array([way.at.T for way in ways]).reshape(-1, 5, OF_WAY),
        rough=np.array([way.rough for way in ways]).reshape(-1, OF_WAY, OF_WAY),
        most=most - _held_jerk(path, ways),
        onward=onward,
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
    columns = np.empty((7, len(ways.path)))
    turning = [matrix(move[3:]) for move in moves]
    by = turns(ways.middles, turning, moves, ways.polar, ways.onward)
    weights, of_ways, factors = weights_of(turning, moves, by)
    for k, (first, last) in enumerate(ways.held):
        places, quats = ways.stretches[k]
        np.matmul(weights[k, RIGID].T, places, out=columns[:3, first : last + 1])
        np.matmul(factors[k], quats, out=columns[3:, first : last + 1])
    if ways.quats.size:
        _press(ways, by, weights, of_ways)
        _even_out(ways, weights, of_ways)
        _carry(ways, turned(by), of_ways, columns)
    return columns.T


def _carry(ways: Ways, at_nodes: Array, of_ways: Array, columns: Array) -> None:
    """Carry all samples between stretches."""
    turning = np.empty(ways.quats.shape)
    for way, turn in zip(ways.between, at_nodes, strict=True):
        np.matmul(turn, way.nodes, out=turning[:, way.inside])
    terms = products(turning, ways.quats)
    for way, weights in zip(ways.between, of_ways, strict=True):
        np.matmul(weights.T, way.rows, out=columns[:3, way.first + 1 : way.last])
        np.matmul(SUMMED, terms[:, way.inside], out=columns[3:, way.first + 1 : way.last])


def _press(ways: Ways, by: Sequence[Turn], weights: Array, of_ways: Array) -> None:
    """Set the weights of the presses that keep the ways clear of the base."""
    if not ways.polar:
        return
    places: list[Rows] = np.matmul(ways.at, of_ways).tolist()
    for k, way in enumerate(ways.between):
        if way.clear is not None:
            found = presses(way.clear, places[k], (by[k], by[k + 1]), ways.keep)
            if found:
                weights[k, PRESSED, :2] = found


def _even_out(ways: Ways, weights: Array, of_ways: Array) -> None:
    """Set the share that is evened out, as much as keeps the ways from being too rough."""
    if ways.most == math.inf:
        return
    rough = np.matmul(ways.rough, of_ways)
    have = float(np.vdot(rough, of_ways))
    if have <= ways.most:
        return
    weights[:, EVENED] = weights[:, ADDED]
    slope = float(np.vdot(rough, of_ways)) - have
    whole = float(np.vdot(np.matmul(ways.rough, of_ways), of_ways))
    share = share_needed(have, slope, whole - have - 2.0 * slope, ways.most)
    weights[:, EVENED] *= share


def _held_jerk(path: Array, between: Sequence[Between]) -> float:
    """Return the sum of squared third differences that reach out of the ways."""
    squares = np.sum(third(path[:, :3].T) ** 2, axis=0)
    for way in between:
        squares[way.first + 1 : max(way.last - 3, way.first + 1)] = 0.0
    return float(np.sum(squares))
