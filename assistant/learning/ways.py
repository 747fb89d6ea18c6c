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
_UNPRESSED = [[0.0, 0.0]] * 3


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
        columns[:3, first : last + 1] = weights[k, RIGID].T.dot(places)
        columns[3:, first : last + 1] = factors[k].dot(quats)
    if ways.quats.size:
        _press(ways, by, weights, of_ways)
        _even_out(ways, weights, of_ways)
        _carry(ways, turned(by), of_ways, columns)
    return columns.T


def _carry(ways: Ways, at_nodes: Array, of_ways: Array, columns: Array) -> None:
    """Carry all samples between stretches."""
    turning = np.empty(ways.quats.shape)
    for way, turn in zip(ways.between, at_nodes, strict=True):
        turning[:, way.inside] = turn.dot(way.nodes)
    quats = SUMMED.dot(products(turning, ways.quats))
    for way, weights in zip(ways.between, of_ways, strict=True):
        carried = slice(way.first + 1, way.last)
        columns[:3, carried] = weights.T.dot(way.rows)
        columns[3:, carried] = quats[:, way.inside]


def _press(ways: Ways, by: Sequence[Turn], weights: Array, of_ways: Array) -> None:
    """Set the weights of the presses that keep the ways clear of the base."""
    if not ways.polar:
        return
    places: list[Rows] = np.matmul(ways.at, of_ways).tolist()
    found = [
        presses(way.clear, there, ends, ways.keep) if way.clear is not None else []
        for way, there, ends in zip(ways.between, places, itertools.pairwise(by), strict=True)
    ]
    if any(found):
        weights[:-1, PRESSED, :2] = [one or _UNPRESSED for one in found]


def _even_out(ways: Ways, weights: Array, of_ways: Array) -> None:
    """Set the share that is evened out, as much as keeps the ways from being too rough."""
    if ways.most == math.inf:
        return
    flat = of_ways.flatten()
    rough = np.matmul(ways.rough, of_ways).ravel()
    have = float(rough.dot(flat))
    if have <= ways.most:
        return
    weights[:, EVENED] = weights[:, ADDED]
    change = of_ways.flatten() - flat
    slope = float(rough.dot(change))
    bend = float(np.matmul(ways.rough, change.reshape(of_ways.shape)).ravel().dot(change))
    weights[:, EVENED] *= share_needed(have, slope, bend, ways.most)


def _held_jerk(path: Array, between: Sequence[Between]) -> float:
    """Return the sum of squared third differences that reach out of the ways."""
    squares = np.sum(third(path[:, :3].T) ** 2, axis=0)
    for way in between:
        squares[way.first + 1 : max(way.last - 3, way.first + 1)] = 0.0
    return float(np.sum(squares))
