"""How late the hand follows the teacher who leads it, told by cues against what the hand does.

Led by keys, a hand stops a while after its teacher meant it to; opening and closing are not so
late. Who speaks at the cuts tells both lags: where cues come later after the gripper acts than
after the hand stops, the hand had stopped late. That is looked for in a hand that is jogged only:
it goes at one speed, where a free hand's speed rises and falls.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from assistant.geometry import Array
from assistant.learning.cue_lag import Lag
from assistant.model.demonstration import Recording
from assistant.model.settings import CueSettings

_NEAR_S = 0.5
_LEAST_BLUR_S = 0.05
_JOGGED = 0.45
"""Of the samples in motion: so many at one speed are those of a jogged hand, not of a free one."""


@dataclass(frozen=True, slots=True, eq=False)
class Following:
    """How late the hand follows, and the teacher speaks.

    Parameters
    ----------
    late_s : float
        From what the teacher meant to what the hand does.
    lag : Lag
        Of the cues after what the teacher meant.
    """

    late_s: float
    lag: Lag


def jogged(recording: Recording) -> bool:
    """Tell whether the hand was led at one speed: in equal steps, or as fast as the arm goes."""
    if len(recording.t_s) < 3:
        return False
    steps_s = np.maximum(np.diff(recording.t_s), 1e-3)
    speeds = np.abs(np.diff(recording.path[:, :3], axis=0)) / steps_s[:, None]
    moving = speeds[speeds > 0.2 * np.quantile(speeds, 0.99)]
    if len(moving) == 0:
        return False
    usual = float(np.quantile(moving, 0.8))
    fast = moving[moving > 0.3 * usual]
    return bool(np.mean(np.abs(fast / usual - 1.0) < 0.15) > _JOGGED)


def following(
    cues_s: Array,
    at_s: Array,
    blur_s: Array,
    acted: NDArray[np.bool_],
    end_s: float,
    lag: Lag,
    given: CueSettings,
) -> Following:
    """Return how late the hand follows: not at all, unless the cues tell otherwise.

    Parameters
    ----------
    cues_s : array, shape (c,)
    at_s, blur_s : array, shape (k,)
        Cuts as the motion and the gripper show them, and how well they do.
    acted : array of bool, shape (k,)
        Whether the gripper acted there.
    end_s : float
        Length of the demonstration.
    lag : Lag
        Of the cues after what the hand does.
    given : CueSettings
    """
    if len(cues_s) == 0 or not np.any(acted) or np.all(acted):
        return Following(0.0, lag)
    lags = np.maximum(lag.best_s + np.arange(-_NEAR_S, _NEAR_S + 1e-9, given.step_s), 0.0)
    lates = np.array([0.0, *given.lates_s])
    each = given.late_share / len(given.lates_s)
    usual = np.log([1.0 - given.late_share, *([each] * len(given.lates_s))])
    told = np.array(
        [
            [
                _told(
                    cues_s, np.where(acted, at_s, at_s - late), blur_s, jitter, lags, end_s, given
                )
                for jitter in given.jitters_s
            ]
            for late in lates
        ]
    )
    told += (
        usual[:, None, None] - 0.5 * ((lags - given.usual_lag_s) / given.usual_lag_spread_s) ** 2
    )
    chances = np.exp(told - np.max(told))
    chances /= np.sum(chances)
    late_s = float(np.sum(chances, axis=(1, 2)) @ lates)
    jitter_s = float(np.sum(chances, axis=(0, 2)) @ np.array(given.jitters_s))
    return Following(late_s, Lag(lags, np.sum(chances, axis=(0, 1)), jitter_s))


def _told(
    cues_s: Array,
    at_s: Array,
    blur_s: Array,
    jitter_s: float,
    lags: Array,
    end_s: float,
    given: CueSettings,
) -> Array:
    """Return the log of how likely the cues are with each lag, shape (len(lags),)."""
    spread = np.hypot(jitter_s, np.hypot(blur_s, _LEAST_BLUR_S))
    late = (cues_s[None, :, None] - at_s - lags[:, None, None]) / spread
    near = np.sum(np.exp(-0.5 * late**2) / (spread * np.sqrt(2.0 * np.pi)), axis=2)
    false_rate = max(len(cues_s) * given.false_share, 0.3) / end_s
    return np.asarray(np.sum(np.log(false_rate + near), axis=1))
