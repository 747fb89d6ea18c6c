"""A demonstration without the time its teacher spent thinking.

Who leads the hand by keys stops between any two of them. How long the hand stood still says
nothing of the task beyond a moment: what is longer is left out of the motion to be carried out.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from assistant.geometry import Array, quat_inverse, quat_multiply, quat_to_rotvec
from assistant.learning.smoothing import Smoothed
from assistant.model.settings import GeneralizationSettings


@dataclass(frozen=True, slots=True, eq=False)
class Clock:
    """Which instants of a shortened demonstration are which of the one that was shown.

    Parameters
    ----------
    t_s, shown_s : array, shape (k,)
        Both increasing; between them time runs evenly.
    """

    t_s: Array
    shown_s: Array

    def shown(self, t_s: Array) -> Array:
        """Return instants of the demonstration, same shape."""
        return np.asarray(np.interp(t_s, self.t_s, self.shown_s))

    def shortened(self, shown_s: Array) -> Array:
        """Return instants of the shortened demonstration, same shape; inverse of `shown`."""
        return np.asarray(np.interp(shown_s, self.shown_s, self.t_s))


def without_waits(
    smoothed: Smoothed, acts_s: Sequence[float], given: GeneralizationSettings
) -> tuple[Smoothed, Clock]:
    """Return the motion with every rest cut to its longest, and the clocks of both.

    A rest in which the hand acts is two: one before and one after.

    Parameters
    ----------
    smoothed : Smoothed
    acts_s : sequence of float
        When the hand closed, opened or touched, in order.
    given : GeneralizationSettings

    Returns
    -------
    shortened : Smoothed
        The middles of long rests have no samples; elsewhere it is the same motion.
    clock : Clock
    """
    t_s = smoothed.t_s
    kept, knots = np.ones(len(t_s), dtype=bool), [(float(t_s[0]), 0.0)]
    gone_s = 0.0
    for first, last in _waits(smoothed, acts_s, given):
        kept[first + 1 : last] = False
        knots.append((float(t_s[first]), gone_s))
        gone_s += float(t_s[last] - t_s[first]) - given.longest_rest_s / 3.0
        knots.append((float(t_s[last]), gone_s))
    knots.append((float(t_s[-1]), gone_s))
    shown_s, gone = np.unique(np.array(knots), axis=0).T
    clock = Clock(shown_s - gone, shown_s)
    if kept.all():
        return smoothed, clock
    opening = smoothed.gripper_m
    shortened = replace(
        smoothed,
        t_s=clock.shortened(t_s[kept]),
        path=smoothed.path[kept],
        velocity=smoothed.velocity[kept],
        acceleration=smoothed.acceleration[kept],
        turn_rate=smoothed.turn_rate[kept],
        gripper_m=None if opening is None else opening[kept],
        gaps_s=(),
    )
    return shortened, clock


def _waits(
    smoothed: Smoothed, acts_s: Sequence[float], given: GeneralizationSettings
) -> list[tuple[int, int]]:
    """Return the first and last sample of each stretch to be left out, in order."""
    t_s, aside_s = smoothed.t_s, given.longest_rest_s / 3.0
    turning = np.linalg.norm(smoothed.turn_rate, axis=1)
    still = (smoothed.speed <= given.rest_m_s) & (turning <= given.rest_rad_s)
    out = []
    edges = np.flatnonzero(np.diff(np.concatenate([[False], still, [False]]).astype(int)))
    for begin, end in edges.reshape(-1, 2):
        from_s, to_s = float(t_s[begin]), float(t_s[end - 1])
        between = [at_s for at_s in acts_s if from_s < at_s < to_s]
        for a_s, b_s in itertools.pairwise([from_s, *between, to_s]):
            first = int(np.searchsorted(t_s, a_s + aside_s))
            last = int(np.searchsorted(t_s, b_s - aside_s, side="right")) - 1
            longer = b_s - a_s > given.longest_rest_s
            if longer and last - first > 1 and _stays(smoothed.path[first : last + 1], given):
                out.append((first, last))
    return out


def _stays(path: Array, given: GeneralizationSettings) -> bool:
    """Return whether a hand that hardly moves does not creep away all the same."""
    strayed = np.linalg.norm(path[:, :3] - path[0, :3], axis=1)
    turned = quat_to_rotvec(quat_multiply(path[:, 3:], quat_inverse(path[:1, 3:])))
    return bool(
        np.max(strayed) <= given.rest_within_m
        and np.max(np.linalg.norm(turned, axis=1)) <= given.rest_within_rad
    )
