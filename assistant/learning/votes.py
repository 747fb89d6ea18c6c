"""Votes of the signals for cutting the demonstration: eqs. (1), (2) of paper III-A."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.signal import find_peaks

from assistant.geometry import Array, angle_between, distance_between, interpolate
from assistant.model.settings import VoteSettings

_TREMBLE = 0.02


def vote(t_s: Array, path: Array, at_s: Array, sharpness: float, turn_weight_m: float) -> Array:
    """Return the vote of one signal at every sample, eq. (1).

    Parameters
    ----------
    t_s : array, shape (n,)
    path : array, shape (n, 7)
        Poses X(t).
    at_s : array, shape (k,)
        Candidates of the signal.
    sharpness : float
        The paper's c, in 1/m^2.
    turn_weight_m : float
        Metres that count like one radian in the distance of poses.

    Returns
    -------
    vote : array, shape (n,)
        In [0, 1]; each candidate reaches to the midpoints between its neighbors only.

    Notes
    -----
    Source: paper III-A, eq. (1).
    """
    if len(at_s) == 0:
        return np.zeros(len(t_s))
    at_s = np.sort(at_s)
    nearest = np.searchsorted(0.5 * (at_s[1:] + at_s[:-1]), t_s, side="right")
    poses = poses_at(t_s, path, at_s)[nearest]
    square = distance_between(path, poses) ** 2
    square = square + (turn_weight_m * angle_between(path, poses)) ** 2
    return np.asarray(np.exp(-sharpness * square))


def poses_at(t_s: Array, path: Array, at_s: Array) -> Array:
    """Return the poses at instants between samples, shape (k, 7)."""
    after = np.clip(np.searchsorted(t_s, at_s), 1, len(t_s) - 1)
    share = (at_s - t_s[after - 1]) / (t_s[after] - t_s[after - 1])
    return interpolate(path[after - 1], path[after], np.clip(share, 0.0, 1.0))


def sharpness(signal: str, t_s: Array, path: Array, cuts: int, settings: VoteSettings) -> float:
    """Return the paper's c of a signal in 1/m^2.

    As printed, c = 1/(spread V^2) with V the mean speed in m/s, read per second. Otherwise the
    spread is a share of the mean way from one cut to the next.

    Notes
    -----
    Source: paper IV-B. Differs: the relative spread, see design "Votes".
    """
    length = float(np.sum(distance_between(path[1:], path[:-1]))) + 1e-9
    spread = settings.spreads[signal]
    if settings.paper_spread:
        mean_speed = length / float(t_s[-1] - t_s[0])
        return 1.0 / (spread * mean_speed**2)
    reach = spread * length / max(cuts + 1, 2)
    return 1.0 / (2.0 * reach**2)


def overall(votes: Mapping[str, Array], weights: Mapping[str, float]) -> Array:
    """Return the weighted sum of votes, eq. (2)."""
    return np.asarray(sum(weights.get(signal, 0.0) * told for signal, told in votes.items()))


def peaks(t_s: Array, total: Array, threshold: float) -> Array:
    """Return the instants of local maxima above a threshold, one for each plateau.

    Source: paper III-A. A hand that rests gives equal votes over the whole rest: the middle
    of the plateau stands for it. Start and end are no cuts.
    """
    if len(total) < 3 or float(np.max(total)) <= 0.0:
        return np.zeros(0)
    # A resting hand trembles a little, and the votes over its rest with it: still one maximum.
    found, given = find_peaks(
        total, height=threshold, prominence=_TREMBLE * float(np.max(total)), plateau_size=1
    )
    return np.asarray(0.5 * (t_s[given["left_edges"]] + t_s[given["right_edges"]]))[: len(found)]
