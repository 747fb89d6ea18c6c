"""All stretches of a demonstration between instants at which it may be cut."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, distance_between, quat_inverse, quat_multiply, quat_to_rotvec
from assistant.learning.candidates import Evidence
from assistant.model.motion import Indices

_SMALL = 0.02
"""Of the motion's extent: what is gone less far says little of the way's shape."""


@dataclass(frozen=True, slots=True, eq=False)
class Stretches:
    """All stretches between pairs of instants; arrays have shape (n, n, ...), from row to column.

    Parameters
    ----------
    at_s : array, shape (n,)
        Start, candidates, end.
    xyz : array, shape (n, 3)
    ways : array, shape (n, n, 3)
        Displacements in m.
    turns : array, shape (n, n, 3)
        Rotation vectors in the base frame, rad.
    lasting_s : array, shape (n, n)
    inside, at_end : mapping of event kind to array, shape (n, n)
        Gripper events strictly within a stretch, and at its end.
    held : array of bool, shape (n,)
        Whether the hand is closed from an instant on.
    longer : array, shape (n, n)
        How much longer the way gone is than the displacement, in log.
    extent_m : float
        Of the whole motion.
    """

    at_s: Array
    xyz: Array
    quats: Array
    ways: Array
    turns: Array
    lasting_s: Array
    inside: dict[str, Array]
    at_end: dict[str, Array]
    held: Array
    longer: Array
    extent_m: float


def stretches(at_s: Array, evidence: Evidence, near_s: float = 1e-6) -> Stretches:
    """Return all stretches between the given instants; events so near to one are at it."""
    t_s, path = evidence.smoothed.t_s, evidence.smoothed.path
    here = np.clip(np.searchsorted(t_s, at_s), 0, len(t_s) - 1)
    xyz, quats = path[here, :3], path[here, 3:]
    turned = quat_to_rotvec(quat_multiply(quats[None, :], quat_inverse(quats)[:, None]))
    inside: dict[str, Array] = {}
    at_end: dict[str, Array] = {}
    for kind in ("close", "open"):
        events = np.array([e.at_s for e in evidence.events if e.kind == kind])
        upto = np.searchsorted(events, at_s + near_s, side="right").astype(float)
        before = np.searchsorted(events, at_s - near_s, side="left").astype(float)
        inside[kind] = np.maximum(before[None, :] - upto[:, None], 0.0)
        at_end[kind] = np.broadcast_to((upto - before)[None, :], inside[kind].shape)
    ways = xyz[None, :] - xyz[:, None]
    extent_m = float(np.linalg.norm(np.ptp(path[:, :3], axis=0))) + 1e-6
    return Stretches(
        at_s=at_s,
        xyz=xyz,
        quats=quats,
        ways=ways,
        turns=turned,
        lasting_s=at_s[None, :] - at_s[:, None],
        inside=inside,
        at_end=at_end,
        held=_held(at_s, evidence, near_s),
        longer=_longer(path[:, :3], here, ways, extent_m),
        extent_m=extent_m,
    )


def _longer(xyz: Array, here: Indices, ways: Array, extent_m: float) -> Array:
    gone = np.concatenate([[0.0], np.cumsum(distance_between(xyz[1:], xyz[:-1]))])[here]
    small, far = _SMALL * extent_m, np.linalg.norm(ways, axis=-1)
    way = np.abs(gone[None, :] - gone[:, None])
    return np.asarray(np.maximum(np.log((way + small) / (far + small)), 0.0))


def _held(at_s: Array, evidence: Evidence, near_s: float) -> Array:
    if not evidence.events:
        return np.zeros(len(at_s), dtype=bool)
    first = evidence.events[0].kind
    closed = np.array([first == "open", *(event.kind == "close" for event in evidence.events)])
    done = np.searchsorted([event.at_s for event in evidence.events], at_s + near_s, side="right")
    return np.asarray(closed[done])
