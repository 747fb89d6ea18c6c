"""How late this teacher speaks: estimated from the demonstration, not assumed (design).

Each cue is false, or follows a cut by the teacher's lag with jitter. Against the chances
that cuts lie at the candidates this gives a distribution of the lag, and the lag one of how
much each cue says for each instant.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array
from assistant.model.settings import CueSettings

SAME_LAG_S = 0.3
"""Lags so near to each other explain the same cues."""


@dataclass(frozen=True, slots=True, eq=False)
class Lag:
    """Distribution of a teacher's lag.

    Parameters
    ----------
    lags_s : array, shape (m,)
    chances : array, shape (m,)
        Sum to 1.
    jitter_s : float
        Of single cues about the lag.
    """

    lags_s: Array
    chances: Array
    jitter_s: float

    @property
    def best_s(self) -> float:
        """The mean lag around the likeliest one."""
        peak = self.lags_s[int(np.argmax(self.chances))]
        near = self.chances * (np.abs(self.lags_s - peak) < SAME_LAG_S)
        return float(np.sum(near * self.lags_s) / np.sum(near))


def estimate(
    cues_s: Array, at_s: Array, blur_s: Array, chances: Array, end_s: float, given: CueSettings
) -> Lag:
    """Return the distribution of the lag; the jitter is the likeliest of those given.

    Parameters
    ----------
    cues_s : array, shape (c,)
    at_s, blur_s, chances : array, shape (k,)
        Candidates, how well they are known, and the probability that a cut lies there.
    end_s : float
        Length of the demonstration.
    given : CueSettings
    """
    lags = np.arange(0.0, given.most_lag_s + 1e-9, given.step_s)
    usual = np.exp(-0.5 * ((lags - given.usual_lag_s) / given.usual_lag_spread_s) ** 2)
    if len(cues_s) == 0 or len(at_s) == 0:
        return Lag(lags, usual / np.sum(usual), given.jitters_s[len(given.jitters_s) // 2])
    likely = chances > 0.02
    late = cues_s[None, :, None] - at_s[None, None, likely] - lags[:, None, None]
    share = chances[likely] / max(float(np.sum(chances)), 1e-9)
    false = given.false_share / max(end_s, 1e-9)
    told = np.array(
        [
            np.sum(
                np.log(
                    false
                    + (1.0 - given.false_share)
                    * (_bell(late, np.hypot(jitter, blur_s[likely])) @ share)
                ),
                axis=1,
            )
            for jitter in given.jitters_s
        ]
    )
    score = np.exp(told - np.max(told)) * usual
    steady = int(np.argmax(np.sum(score, axis=1)))
    return Lag(lags, score[steady] / np.sum(score[steady]), given.jitters_s[steady])


def modes(lag: Lag, most: int = 3) -> tuple[tuple[Lag, float], ...]:
    """Return the likely lags apart from each other, likeliest first, each with its share.

    Cuts that follow each other at like distances make several lags explain the same cues; only
    the whole reading tells which one is right.
    """
    left = lag.chances.copy()
    found: list[tuple[Lag, float]] = []
    while len(found) < most:
        peak = lag.lags_s[int(np.argmax(left))]
        near = np.abs(lag.lags_s - peak) < SAME_LAG_S
        share = float(np.sum(left[near]))
        if found and share < 0.03:
            break
        chances = np.where(near, lag.chances, 0.0)
        found.append((Lag(lag.lags_s, chances / np.sum(chances), lag.jitter_s), share))
        left[near] = 0.0
        if not np.any(left > 0.0):
            break
    return tuple(found)


def support(
    cues_s: Array, at_s: Array, blur_s: Array, lag: Lag, missing: float, false_rate: float
) -> tuple[Array, Array]:
    """Return what the cues say for cuts, in log odds.

    Returns
    -------
    alone : array, shape (k,)
        For a cut at each instant: one with no cue near loses log(missing), one with a cue at
        the teacher's lag gains.
    shared : array, shape (k, k)
        What two cuts gained from the same cue, which can be the reason of one cut only.
    """
    if len(cues_s) == 0:
        return np.zeros(len(at_s)), np.zeros((len(at_s), len(at_s)))
    late = cues_s[None, :, None] - at_s[:, None, None] - lag.lags_s
    heard = _bell(late, np.hypot(lag.jitter_s, blur_s)[:, None, None]) @ lag.chances
    gain = np.log1p((1.0 - missing) * heard / (missing * false_rate))
    shared = np.max(np.minimum(gain[:, None, :], gain[None, :, :]), axis=2)
    return np.log(missing) + np.max(gain, axis=1), shared


def refined(cues_s: Array, at_s: Array, blur_s: Array, lag: Lag) -> Array:
    """Return instants of cuts, moved towards what the cues say where that is known better.

    A long rest, or a slow recording, knows its middle less well than a steady teacher's cue.
    """
    if len(cues_s) == 0 or len(at_s) == 0:
        return at_s
    told = cues_s[None, :] - lag.best_s - at_s[:, None]
    nearest = told[np.arange(len(at_s)), np.argmin(np.abs(told), axis=1)]
    both = np.hypot(lag.jitter_s, blur_s)
    trust = np.where(np.abs(nearest) < 2.5 * both, (blur_s / both) ** 2, 0.0)
    return np.asarray(at_s + trust * nearest)


def _bell(values: Array, spread: Array) -> Array:
    return np.asarray(np.exp(-0.5 * (values / spread) ** 2) / (spread * np.sqrt(2.0 * np.pi)))
