"""The demonstration's time, with a rest wherever the hand acts.

A person may close the hand while it still moves; a robot's hand rests while its gripper acts.
Where the demonstration rests too briefly, time is inserted, and where it does not rest at all,
the motion is braked and set off again without a kink.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from assistant.geometry import Array


@dataclass(frozen=True, slots=True)
class Halt:
    """A rest to be made.

    Parameters
    ----------
    at_s : float
        On the demonstration's clock.
    brake_s, away_s : float
        Stretches of demonstrated motion before and after that are eased; 0 if it rests anyway.
    stay_s : float
        Time inserted.
    """

    at_s: float
    brake_s: float
    away_s: float
    stay_s: float


def braked(share: Array) -> Array:
    """Return the way made by a share of the time: from full speed to rest, in twice the time.

    Speed falls from 2 to 0, acceleration is 0 at both ends.
    """
    return np.asarray(share * (2.0 + share * share * (share - 2.0)))


def longer_clock(halts: Sequence[Halt], begin_s: float, end_s: float) -> tuple[Array, Array, Array]:
    """Return the pieces of the new clock.

    Returns
    -------
    lengths_s : array, shape (k,)
        On the new clock; negative for a piece that sets off from a halt.
    from_s, to_s : array, shape (k,)
        On the demonstration's clock. A piece keeps time if both lengths are alike, stays if
        `from_s` is `to_s`, and else eases.
    """
    marks: list[tuple[float, float, float]] = []
    now = begin_s
    latest = [(a.at_s + b.at_s) / 2.0 for a, b in pairwise(halts)] + [end_s]
    for halt, last in zip(halts, latest, strict=False):
        brake_from = max(halt.at_s - halt.brake_s, now)
        marks.append((brake_from - now, now, brake_from))
        marks.append((2.0 * (halt.at_s - brake_from), brake_from, halt.at_s))
        marks.append((halt.stay_s, halt.at_s, halt.at_s))
        now = min(halt.at_s + halt.away_s, last)
        marks.append((-2.0 * (now - halt.at_s), halt.at_s, now))
    marks.append((end_s - now, now, end_s))
    pieces = np.array([mark for mark in marks if abs(mark[0]) > 1e-9])
    return pieces[:, 0], pieces[:, 1], pieces[:, 2]


def demonstrated_times(halts: Sequence[Halt], begin_s: float, end_s: float, new_s: Array) -> Array:
    """Return, for instants of the new clock, the instants of the demonstration.

    Parameters
    ----------
    halts : sequence of Halt
        In order of time.
    begin_s, end_s : float
        Of the demonstration.
    new_s : array, shape (n,)
        From 0; later than the end stays at the end.
    """
    lengths, from_s, to_s = longer_clock(halts, begin_s, end_s)
    starts = np.concatenate([[0.0], np.cumsum(np.abs(lengths))])
    piece = np.clip(np.searchsorted(starts, new_s, side="right") - 1, 0, len(lengths) - 1)
    share = np.clip((new_s - starts[piece]) / np.abs(lengths[piece]), 0.0, 1.0)
    way = to_s[piece] - from_s[piece]
    eased = np.abs(np.abs(lengths[piece]) - way) > 1e-9
    ahead = np.where(lengths[piece] > 0.0, braked(share), 1.0 - braked(1.0 - share))
    return np.asarray(from_s[piece] + way * np.where(eased, ahead, share))


def new_instant(halts: Sequence[Halt], begin_s: float, end_s: float, at: int) -> float:
    """Return when, on the new clock, the middle of the rest of halt number `at` comes."""
    lengths, from_s, to_s = longer_clock(halts, begin_s, end_s)
    starts = np.concatenate([[0.0], np.cumsum(np.abs(lengths))])
    reached = np.flatnonzero((from_s < to_s) & (to_s <= halts[at].at_s + 1e-12))
    done = float(starts[reached[-1] + 1]) if len(reached) else 0.0
    return done + halts[at].stay_s / 2.0
