"""Probabilities that mean what they say: how sure the robot is of a cut and of an assignment.

The decoder's own chances know only what it weighed. Whether a cut is right also depends on
what kind of evidence stands behind it; a logistic regression joins both.
"""

from __future__ import annotations

import numpy as np

from assistant.geometry import Array
from assistant.learning.reading import Understood, local_scores
from assistant.model.settings import SegmentationSettings

FEATURES = ("odds", "gripper", "rest", "heard", "blur", "spoken", "unseen", "odds unseen")
"""What a cut's confidence is made of.

``odds``: log odds of the decoder; ``gripper``, ``rest`` (in tenths of the mean step), ``heard``
(proposed by a cue only): the evidence at the cut; ``blur``: how well its instant is known, in s;
``spoken``: a cue agrees; ``unseen``: the gripper is not recorded.
"""

_WEIGHTS = np.array([0.61, 1.14, 0.73, 0.07, -1.56, 0.37, 0.84, -0.34])
_BIAS = 0.09
"""Fitted on made-up demonstrations of seeds that no benchmark uses, and on people's."""

_NEAR_S = 0.25


def cut_confidence(understood: Understood, node: int, cues_s: Array, *, seen: bool) -> float:
    """Return the probability that a cut belongs at a node of the reading.

    Parameters
    ----------
    understood : Understood
    node : int
        Index into its instants.
    cues_s : array, shape (c,)
        Cues without the teacher's lag.
    seen : bool
        Whether the gripper was recorded.
    """
    return _sigmoid(float(features(understood, node, cues_s, seen=seen) @ _WEIGHTS + _BIAS))


def features(understood: Understood, node: int, cues_s: Array, *, seen: bool) -> Array:
    """Return the values of `FEATURES` for a node."""
    spot = understood.candidates[node - 1]
    at_s = float(understood.at_s[node])
    odds = _log_odds(chance_near(understood, at_s))
    usual_s = float(np.ptp(understood.at_s)) / max(len(understood.order), 1)
    spoken = bool(len(cues_s)) and float(np.min(np.abs(cues_s - at_s))) < 2.0 * _NEAR_S
    return np.array(
        [
            odds,
            float(spot.gripper),
            np.log1p(spot.rest_s / (0.1 * usual_s)),
            float(spot.heard),
            min(spot.blur_s, 1.0),
            float(spoken),
            float(not seen),
            0.0 if seen else odds,
        ]
    )


def chance_near(understood: Understood, at_s: float) -> float:
    """Return the decoder's probability of a cut near an instant."""
    near = np.abs(understood.at_s - at_s) < _NEAR_S
    near[0] = near[-1] = False
    return float(min(np.sum(understood.reading.cut_chances[near]), 1.0))


def surely_moved(understood: Understood, at_s: float, settings: SegmentationSettings) -> float:
    """Return how surely something ends and begins at an instant, be it within a primitive.

    The decoder's chance of a cut between primitives there, or what the motion alone says if
    that is more.
    """
    usual_s = float(np.ptp(understood.at_s)) / max(len(understood.order), 1)
    near = [spot for spot in understood.candidates if abs(spot.at_s - at_s) < _NEAR_S]
    odds = local_scores(near, usual_s, settings.decoding)
    alone = _sigmoid(float(np.max(odds))) if near else 0.0
    return max(alone, chance_near(understood, at_s))


def step_confidence(understood: Understood, first: int, last: int, position: int | None) -> float:
    """Return the probability that a stretch belongs to a primitive: it ends there as such."""
    if position is None:
        return 0.5
    chances, at_s = understood.reading.step_chances, understood.at_s
    ends = float(np.sum(chances[np.abs(at_s - at_s[last]) < _NEAR_S, position]))
    if first == 0:
        return min(ends, 1.0)
    before = chances[np.abs(at_s - at_s[first]) < _NEAR_S]
    return float(min(ends, np.sum(before[:, : position + 1]), 1.0))


def _log_odds(chance: float) -> float:
    inside = min(max(chance, 1e-3), 1.0 - 1e-3)
    return float(np.log(inside / (1.0 - inside)))


def _sigmoid(odds: float) -> float:
    return float(1.0 / (1.0 + np.exp(-odds)))
