"""How one teacher moves and speaks: numbers drawn with a seed, so that teachers differ."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, slots=True)
class Habits:
    """Habits of a teacher's hand and voice.

    Parameters
    ----------
    peak_speed_m_s, careful_speed_m_s : float
        Greatest speed in free motion, and within a docking stretch.
    rest_s : float
        Typical rest before and after the gripper acts.
    hesitation : float
        Probability of a short halt on a free reach.
    undershoot : float
        Share of a reach left to a corrective submovement.
    tremor_m, drift_m : float
        Of the free hand; both fade where the hand steadies itself at a station.
    gripper_s : float
        Duration of opening or closing.
    retreat_m : float
        How far the hand backs off after opening.
    cue_lag_s, cue_jitter_s : float
        How late cues are, and how much that varies.
    cue_missing, cue_false : float
        Probabilities, for each transition.
    key_states : float
        Probability that a key state change is pointed out.
    """

    peak_speed_m_s: float = 0.20
    careful_speed_m_s: float = 0.07
    rest_s: float = 0.40
    hesitation: float = 0.15
    undershoot: float = 0.06
    tremor_m: float = 0.00012
    drift_m: float = 0.0008
    gripper_s: float = 0.5
    retreat_m: float = 0.07
    cue_lag_s: float = 0.35
    cue_jitter_s: float = 0.08
    cue_missing: float = 0.05
    cue_false: float = 0.0
    key_states: float = 0.5

    @classmethod
    def of_seed(cls, seed: int) -> Habits:
        """Return the habits of a teacher drawn with a seed."""
        random = np.random.default_rng([seed, 1])
        return cls(
            peak_speed_m_s=float(random.uniform(0.15, 0.23)),
            careful_speed_m_s=float(random.uniform(0.05, 0.09)),
            rest_s=float(random.uniform(0.25, 0.6)),
            undershoot=float(random.uniform(0.03, 0.10)),
            tremor_m=float(random.uniform(0.00005, 0.0002)),
            drift_m=float(random.uniform(0.0003, 0.0015)),
            gripper_s=float(random.uniform(0.4, 0.7)),
            retreat_m=float(random.uniform(0.06, 0.09)),
            cue_lag_s=float(random.uniform(0.1, 0.8)),
            cue_jitter_s=float(random.uniform(0.03, 0.12)),
        )
