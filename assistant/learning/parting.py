"""A hand that only leaves: what follows the last release, when all is done, is no step."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assistant.geometry import Array, distance_between
from assistant.learning.candidates import Evidence
from assistant.model.lesson import Episode, SegmentationPoint

_SOON_S = 0.5
"""The hand opens within this time of where it begins to leave."""
_FAR_M = 0.2
"""Who goes farther than that with an empty hand goes to do something."""
_STRAIGHT = 0.8
_TOLD_S = 1.0
"""A cue, its lag taken off, from this long before the hand leaves says that it is a step."""


def only_leaves(evidence: Evidence, from_s: float, to_s: float, cues_s: Array) -> bool:
    """Tell whether the hand does nothing else than leave what it has let go of.

    Parameters
    ----------
    evidence : Evidence
    from_s, to_s : float
        A part of the demonstration, in s.
    cues_s : array, shape (c,)
        Instants of the cues, already without the teacher's lag, in s.

    Returns
    -------
    leaves : bool
        The part is the last, the hand opened where it begins and goes a short way straight off,
        and no cue tells of it.
    """
    t_s, path = evidence.smoothed.t_s, evidence.smoothed.path
    events = evidence.events
    if to_s < float(t_s[-1]) or not events or events[-1].kind != "open":
        return False
    if events[-1].at_s > from_s + _SOON_S or bool(np.any(cues_s > from_s - _TOLD_S)):
        return False
    way = path[t_s >= max(from_s, events[-1].at_s)]
    if len(way) == 0:
        return False
    length = float(np.sum(distance_between(way[:-1], way[1:])))
    return length <= _FAR_M and float(distance_between(way[0], way[-1])) >= _STRAIGHT * length


def with_leaving(
    evidence: Evidence,
    points: tuple[SegmentationPoint, ...],
    parts: tuple[Episode, ...],
    cues_s: Array,
) -> tuple[tuple[SegmentationPoint, ...], tuple[Episode, ...]]:
    """Return points and episodes with an unnamed leaving as part of the last step.

    The cut before it stays as a point within that step. Parameters are as in `only_leaves`.
    """
    if len(parts) < 2 or parts[-1].primitive is not None or parts[-2].primitive is None:
        return points, parts
    last, gone = parts[-2:]
    if not only_leaves(evidence, gone.from_s, gone.to_s, cues_s):
        return points, parts
    marked = tuple(
        replace(point, internal=True) if point.kept and point.at_s == gone.from_s else point
        for point in points
    )
    return marked, (*parts[:-2], replace(last, to_s=gone.to_s))
