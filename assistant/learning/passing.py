"""How the motion passes an instant at which it may be cut: how slowly, and how sharply it turns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from assistant.geometry import Array
from assistant.learning.candidates import Candidate, Evidence
from assistant.learning.smoothing import Smoothed

_SLOWEST = 0.03
"""Of the mean speed: slower is a rest."""
_AROUND = 1.0 / 6.0
"""Of the usual time between two cuts: over so long the ways to and from an instant are compared."""
_SMALL = 0.02
"""Of the motion's extent: a way as short as that has no direction of its own."""


def passed(
    candidates: Sequence[Candidate], evidence: Evidence, usual_s: float
) -> tuple[Candidate, ...]:
    """Return candidates with how the motion passes them.

    Parameters
    ----------
    candidates : sequence of Candidate
    evidence : Evidence
    usual_s : float
        Mean time from one introduced cut to the next.
    """
    if not candidates:
        return ()
    at_s = np.array([spot.at_s for spot in candidates])
    half_s = np.array([0.5 * spot.rest_s for spot in candidates])
    told = zip(
        candidates,
        slowness(at_s, evidence).tolist(),
        bends(at_s, evidence.smoothed).tolist(),
        veers(at_s, half_s, _AROUND * usual_s, evidence.smoothed).tolist(),
        strict=True,
    )
    return tuple(replace(c, slow=slow, bend=bend, veer=veer) for c, slow, bend, veer in told)


def slowness(at_s: Array, evidence: Evidence) -> Array:
    """Return how slow the hand is at instants, in log below its mean speed, shape (k,)."""
    pace = np.interp(at_s, evidence.smoothed.t_s, evidence.pace)
    return np.asarray(-np.log(np.maximum(pace / np.mean(evidence.pace), _SLOWEST)))


def veers(at_s: Array, half_s: Array, around_s: float, smoothed: Smoothed) -> Array:
    """Return how much the way turns at rests, over a while before and after, in [0, 1].

    1 - cos of the angle between both displacements, over 2.

    Parameters
    ----------
    at_s, half_s : array, shape (k,)
        Middles of rests, and half of how long they last.
    around_s : float
    smoothed : Smoothed
    """
    xyz, t_s = smoothed.path[:, :3], smoothed.t_s

    def at(when_s: Array) -> Array:
        return np.stack([np.interp(when_s, t_s, column) for column in xyz.T], axis=-1)

    way_in = at(at_s - half_s) - at(at_s - half_s - around_s)
    way_out = at(at_s + half_s + around_s) - at(at_s + half_s)
    small = _SMALL * float(np.linalg.norm(np.ptp(xyz, axis=0))) + 1e-6
    lengths = [np.linalg.norm(way, axis=-1) + small for way in (way_in, way_out)]
    return np.asarray(0.5 * (1.0 - np.sum(way_in * way_out, axis=-1) / (lengths[0] * lengths[1])))


def bends(at_s: Array, smoothed: Smoothed) -> Array:
    """Return the same at instants, over a tenth of the motion's extent, shape (k,)."""
    if len(at_s) == 0:
        return np.zeros(0)
    xyz, t_s = smoothed.path[:, :3], smoothed.t_s
    stride = max(len(t_s) // 1500, 1)
    xyz, t_s = xyz[::stride], t_s[::stride]
    reach = 0.1 * float(np.linalg.norm(np.ptp(xyz, axis=0))) + 1e-6
    bends = np.zeros(len(at_s))
    for k, at in enumerate(at_s):
        here = int(np.clip(np.searchsorted(t_s, at), 0, len(t_s) - 1))
        away = xyz - xyz[here]
        far = np.linalg.norm(away, axis=1) > reach
        before, after = np.flatnonzero(far[:here]), np.flatnonzero(far[here:])
        if len(before) and len(after):
            way_in, way_out = -away[before[-1]], away[here + after[0]]
            cos = way_in @ way_out / (np.linalg.norm(way_in) * np.linalg.norm(way_out))
            bends[k] = 0.5 * (1.0 - cos)
    return bends
