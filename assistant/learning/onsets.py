"""When the hand came to rest and when it left again, told by the whole beginning of a motion.

A reach sets off with its jerk bounded: its way grows with the cube of time. One sample near a
rest says little of the instant, as the hand has hardly moved; the way's first part together
says it well, even where samples lie half a second apart.
Source: T. Flash, N. Hogan, J. Neurosci. 5 (1985): reaches of least jerk; the fit is ours.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from assistant.geometry import Array, quat_inverse, quat_multiply, quat_to_rotvec
from assistant.learning.signals import Minimum
from assistant.learning.smoothing import Smoothed
from assistant.model.settings import SignalSettings

_FEWEST, _MOST = 5, 100
"""Samples of a way's first part that a fit takes."""
_INSTANTS = 60
"""So many are compared."""


def centered(
    minima: Sequence[Minimum], smoothed: Smoothed, settings: SignalSettings
) -> tuple[Minimum, ...]:
    """Return minima with their instants half way between the hand's coming and its leaving.

    How long a rest lasted stays as it was told. Where samples lie close together they show the
    rest itself, and nothing is changed.

    Parameters
    ----------
    minima : sequence of Minimum
    smoothed : Smoothed
    settings : SignalSettings
    """
    t_s = smoothed.t_s
    if float(np.median(np.diff(t_s))) < settings.onset_step_s:
        return tuple(minima)
    rows = _coordinates(smoothed, settings.turn_weight_m)
    noise_m = settings.onset_noise * float(np.linalg.norm(np.ptp(rows, axis=0))) + 1e-9
    spots = sorted(minima, key=lambda spot: spot.at_s)
    edges = [float(t_s[0]), *(spot.at_s for spot in spots), float(t_s[-1])]
    found = []
    for spot, (before_s, _), (_, after_s) in zip(
        spots, pairwise(edges[:-1]), pairwise(edges[1:]), strict=True
    ):
        came = onset(-t_s[::-1], rows[::-1], -spot.at_s, -before_s, noise_m, settings)
        left = onset(t_s, rows, spot.at_s, after_s, noise_m, settings)
        if came is not None and left is not None:
            spot = replace(spot, at_s=0.5 * (left - came))
        found.append(spot)
    return tuple(found)


def onset(
    t_s: Array, rows: Array, from_s: float, to_s: float, noise_m: float, settings: SignalSettings
) -> float | None:
    """Return when a motion set in, between an instant of rest and the next one.

    The mean over all instants, each as likely as the way's first part grows from it with the
    cube of time.

    Parameters
    ----------
    t_s : array, shape (n,)
    rows : array, shape (n, m)
        Coordinates in m.
    from_s, to_s : float
    noise_m : float
        Of a coordinate at rest.
    settings : SignalSettings

    Returns
    -------
    onset_s : float or None
        None where there are too few samples between.
    """
    first, last = np.searchsorted(t_s, (from_s - 1e-9, to_s + 1e-9))
    if last - first < _FEWEST:
        return None
    away = np.linalg.norm(rows[first:last] - rows[first], axis=1)
    begun = int(np.argmax(away >= settings.onset_share * np.max(away)))
    stop = max(begun + 1, _FEWEST)
    stride = -(-stop // _MOST)
    times, way = t_s[first : first + stop : stride], rows[first : first + stop : stride]
    off_m = np.hypot(noise_m, settings.onset_off * away[:stop:stride])
    trust = 1.0 / off_m**2
    instants = np.linspace(times[0], times[-2], _INSTANTS)
    since = np.maximum(times - instants[:, None], 0.0) / (times[-1] - times[0])
    grown = since * since * since
    grown = grown - (grown @ trust / np.sum(trust))[:, None]
    way = way - trust @ way / np.sum(trust)
    told = np.sum(((grown * trust) @ way) ** 2, axis=1) / ((grown * grown) @ trust + 1e-12)
    chances = np.exp(0.5 * (told - np.max(told)))
    return float(chances @ instants / np.sum(chances))


def _coordinates(smoothed: Smoothed, turn_weight_m: float) -> Array:
    """Return places and the running sum of turns, both in m, shape (n, 6)."""
    quats = smoothed.path[:, 3:]
    turns = quat_to_rotvec(quat_multiply(quat_inverse(quats[:-1]), quats[1:]))
    turned = np.vstack([np.zeros((1, 3)), np.cumsum(turns, axis=0)])
    return np.hstack([smoothed.path[:, :3], turn_weight_m * turned])
