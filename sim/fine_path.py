"""A path of the hand on a grid fine enough to be checked and timed sample by sample."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from assistant.geometry import (
    Array,
    angle_between,
    distance_between,
    interpolate,
    quat_continuous,
    quat_normalize,
)
from assistant.model.motion import HandPath, HandStop, Indices
from sim.a465 import CONTROL_HZ

STEP_S = 1.0 / CONTROL_HZ
FREE_SAMPLES = 64
"""A free stretch has at least so many samples, so that a detour has room."""
JOIN_M_S, JOIN_RAD_S = 0.12, 0.6
"""Mean speeds of the straight motion from where the arm is to where the path begins."""
DEPART_M = 1e-5
"""A hand further from its stop has departed."""
AT_START_M, AT_START_RAD = 5e-4, 3e-3

Flags = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class FinePath:
    """A `HandPath` with samples at most one control tick apart; all its samples are kept.

    Parameters
    ----------
    u_s : array, shape (g,)
        The hand's own time.
    poses : array, shape (g, 7)
    gripper_m : array, shape (g,)
    primitive_at : array of int, shape (g,)
    stops : tuple of HandStop
        With samples of this grid.
    """

    u_s: Array
    poses: Array
    gripper_m: Array
    primitive_at: Indices
    stops: tuple[HandStop, ...]

    @property
    def constrained(self) -> Flags:
        """The samples, shape (g,), within the stretches around stops."""
        flags = np.zeros(len(self.u_s), dtype=bool)
        for stop in self.stops:
            flags[stop.docking_at : stop.left_at + 1] = True
        return flags

    def openings(self) -> Array:
        """Return how wide the hand counts as at the samples, shape (g,): its widest where free."""
        widest = np.array(self.gripper_m)
        for first, last in self.free_stretches():
            widest[first : last + 1] = np.max(self.gripper_m[first : last + 1])
        return widest

    def free_stretches(self) -> list[tuple[int, int]]:
        """Return first and last sample of each free stretch, its fixed ends included."""
        edges = np.diff(np.concatenate([[1], self.constrained.astype(int), [1]]))
        begins, ends = np.flatnonzero(edges < 0), np.flatnonzero(edges > 0)
        last = len(self.u_s) - 1
        pairs = zip(begins.tolist(), ends.tolist(), strict=True)
        return [(max(first - 1, 0), min(end, last)) for first, end in pairs]


def relaxed(fine: FinePath, kinds: Collection[str]) -> FinePath:
    """Return the path with stops of some kinds kept exact, but not the departures from them."""
    stops = []
    for stop in fine.stops:
        if stop.kind not in kinds:
            stops.append(stop)
            continue
        away = distance_between(fine.poses[stop.at : stop.left_at + 1], fine.poses[stop.at])
        gone = np.flatnonzero(away > DEPART_M)
        left = stop.at + max(int(gone[0]) - 1, 0) if len(gone) else stop.left_at
        stops.append(replace(stop, left_at=left))
    return replace(fine, stops=tuple(stops))


def refine(path: HandPath) -> FinePath:
    """Return the path with enough samples between its own, monotone between them."""
    t_s = np.asarray(path.t_s)
    pieces = np.maximum(np.ceil(np.diff(t_s) / STEP_S - 1e-6), _pieces_where_free(path)).astype(int)
    index = np.concatenate([[0], np.cumsum(pieces)])
    u_s = np.interp(np.arange(index[-1] + 1), index, t_s)
    owner = np.minimum(np.searchsorted(index, np.arange(len(u_s)), side="right") - 1, len(t_s) - 1)
    return FinePath(
        u_s,
        _between(t_s, np.asarray(path.path), u_s),
        np.interp(u_s, t_s, path.gripper_m),
        np.asarray(path.primitive_at)[owner],
        tuple(moved(stop, index) for stop in path.stops),
    )


def moved(stop: HandStop, index: Sequence[int] | NDArray[np.int64]) -> HandStop:
    """Return a stop with its samples looked up in `index`."""
    # What is left of a task may begin within a stretch: its docking then lies before it.
    last = len(index) - 1
    wanted = (stop.docking_at, stop.at, stop.left_at)
    docking, at, left = (int(index[min(max(k, 0), last)]) for k in wanted)
    return replace(stop, docking_at=docking, at=at, left_at=left)


def _pieces_where_free(path: HandPath) -> Array:
    pieces = np.ones(len(path.t_s) - 1)
    edges = [0, *(k for stop in path.stops for k in (stop.docking_at, stop.left_at))]
    edges.append(len(path.t_s) - 1)
    for first, last in zip(edges[::2], edges[1::2], strict=True):
        if last > first:
            pieces[first:last] = np.ceil(FREE_SAMPLES / (last - first))
    return pieces


def _between(t_s: Array, path: Array, u_s: Array) -> Array:
    if len(u_s) == len(t_s):
        return path
    from scipy.interpolate import PchipInterpolator

    # Monotone between samples: a hand that rests goes on resting exactly.
    smooth = np.concatenate([path[:, :3], quat_continuous(path[:, 3:])], axis=1)
    dense = PchipInterpolator(t_s, smooth)(u_s)
    return np.concatenate([dense[:, :3], quat_normalize(dense[:, 3:])], axis=1)


def joined(fine: FinePath, hand: Array) -> FinePath:
    """Return the path led up to from where the hand is; as it is where it begins there."""
    gap, turn = distance_between(hand, fine.poses[0]), angle_between(hand, fine.poses[0])
    if gap < AT_START_M and turn < AT_START_RAD:
        return fine
    lasts_s = max(float(gap) / JOIN_M_S, float(turn) / JOIN_RAD_S, 0.5)
    count = max(int(np.ceil(lasts_s / STEP_S)), FREE_SAMPLES)
    s = np.linspace(0.0, 1.0, count, endpoint=False)
    lead = interpolate(hand, fine.poses[0], s**3 * (10.0 - 15.0 * s + 6.0 * s * s))
    return FinePath(
        np.concatenate([fine.u_s[0] + s * lasts_s, fine.u_s + lasts_s]),
        np.concatenate([lead, fine.poses]),
        np.concatenate([np.full(count, fine.gripper_m[0]), fine.gripper_m]),
        np.concatenate([np.full(count, fine.primitive_at[0]), fine.primitive_at]),
        tuple(moved(stop, np.arange(count, count + len(fine.u_s))) for stop in fine.stops),
    )
