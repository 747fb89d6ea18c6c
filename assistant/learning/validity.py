"""P(E): the probability that an episode is a valid segment (paper III-A)."""

from __future__ import annotations

import numpy as np

from assistant.learning.candidates import Evidence
from assistant.learning.character import change
from assistant.model.settings import SegmentationSettings


def validity(
    evidence: Evidence, from_s: float, to_s: float, settings: SegmentationSettings
) -> float:
    """Return P(E) in [0, 1] of the stretch between two instants.

    The factors are the paper's: long enough in space and in time; with a clear character
    (motion or turning mainly along one axis) or very fast. The paper names no numbers.
    """
    given, smoothed = settings.validity, evidence.smoothed
    t_s = smoothed.t_s
    a, b = np.clip(np.searchsorted(t_s, [from_s, to_s]), 0, len(t_s) - 1)
    if b <= a:
        return 0.0
    steps = 0.5 * (evidence.pace[1:] + evidence.pace[:-1]) * np.diff(t_s)
    length, whole = float(np.sum(steps[a:b])), float(np.sum(steps)) + 1e-12
    long = _rises((to_s - from_s) / given.least_s) * _rises(length / whole / given.least_share)
    way, turn = change(smoothed, from_s, to_s)
    weighed = np.concatenate([way, settings.signals.turn_weight_m * turn])
    clear = float(np.max(np.abs(weighed)) / (np.linalg.norm(weighed) + 1e-12))
    fast = length / (to_s - from_s) / (whole / float(t_s[-1] - t_s[0]))
    marked = max(_rises(clear / given.dominant), _rises(fast / given.fast))
    return float(long * marked)


def _rises(ratio: float) -> float:
    """Return 0 at 0, 1/2 at 1, towards 1 beyond."""
    return ratio**3 / (1.0 + ratio**3)
