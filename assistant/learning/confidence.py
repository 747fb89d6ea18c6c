"""Probabilities that mean what they say: how sure the robot is of a cut and of an assignment.

The decoder's own chances know only what it weighed. Whether a cut is right also depends on
what kind of evidence stands behind it; a logistic regression joins both.
"""

from __future__ import annotations

import math

import numpy as np

from assistant.geometry import Array
from assistant.learning.cue_lag import Lag
from assistant.learning.reading import Understood, local_scores
from assistant.model.settings import SegmentationSettings

FEATURES = (
    "odds",
    "timing",
    "gripper",
    "rest",
    "heard",
    "spoken",
    "off",
    "depth",
    "jolt",
    "alone",
    "unseen",
    "odds unseen",
)
"""What a cut's confidence is made of.

``odds``: log odds of the decoder; ``timing``: log of the chance that the instant, as well as
it is known, is no more than half a second off; ``gripper``, ``rest`` (in tenths of the mean
step), ``heard`` (proposed by a cue only), ``depth``, ``jolt``: the evidence at the cut;
``spoken``: a cue agrees; ``off``: by how many jitters the nearest cue misses; ``alone``: the
motion without cues is cut here too; ``unseen``: the gripper is not recorded.
"""

_WEIGHTS = np.array([0.26, 2.78, 2.81, 1.61, 0.72, -1.31, -0.57, 0.41, 0.43, 0.34, 0.44, -0.34])
_BIAS = 1.68
"""Fitted on made-up demonstrations of seeds that no benchmark uses, and on people's."""

_ALL_WEIGHTS = np.array([0.83, 0.27, -2.03, -0.28, -0.29, 0.46, -3.36])
_ALL_BIAS = -0.07
"""Of `all_right`; fitted on the same demonstrations."""

_NEAR_S = 0.25
_SAME_S = 0.4
_OFF_S = 0.5
_UNKNOWN_LAG = Lag(np.zeros(1), np.ones(1), 0.3)


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
    odds = _log_odds(_same_chance(understood, node))
    usual_s = float(np.ptp(understood.at_s)) / max(len(understood.order), 1)
    jitter_s = (understood.lag or _UNKNOWN_LAG).jitter_s
    away_s = float(np.min(np.abs(cues_s - at_s))) if len(cues_s) else math.inf
    spoken = away_s < _OFF_S
    return np.array(
        [
            odds,
            _log_timely(spot.blur_s, jitter_s, spoken=spoken, heard=spot.heard),
            float(spot.gripper),
            np.log1p(spot.rest_s / (0.1 * usual_s)),
            float(spot.heard),
            float(spoken),
            min(away_s / jitter_s, 5.0) if len(cues_s) else 0.0,
            min(spot.depth, 2.0),
            np.log1p(spot.jolt),
            float(_agrees(understood, at_s)),
            float(not seen),
            0.0 if seen else odds,
        ]
    )


def all_right(understood: Understood, confidences: Array, cues_s: Array, *, seen: bool) -> float:
    """Return the probability that all cuts are right and none is missing.

    Parameters
    ----------
    understood : Understood
    confidences : array, shape (k,)
        Of its cuts.
    cues_s : array, shape (c,)
        Cues without the teacher's lag.
    seen : bool
        Whether the gripper was recorded.
    """
    told = whole_features(understood, confidences, cues_s, seen=seen)
    return _sigmoid(float(told @ _ALL_WEIGHTS + _ALL_BIAS))


def whole_features(
    understood: Understood, confidences: Array, cues_s: Array, *, seen: bool
) -> Array:
    """Return what the confidence in all cuts together is made of, shape (7,).

    Log odds that all cuts are right if they were independent, and of the least sure one; the
    share of cuts no cue tells; cues no cut explains; cuts the motion alone does not show; log
    of the number of primitives; whether the gripper was not recorded.
    """
    cuts_s = understood.at_s[list(understood.reading.nodes[1:-1])]
    away_s = np.abs(cuts_s[:, None] - cues_s[None, :])
    silent = np.min(away_s, axis=1, initial=math.inf) >= _OFF_S
    idle = np.min(away_s, axis=0, initial=math.inf) >= _OFF_S
    alone = [_agrees(understood, float(at)) for at in cuts_s]
    return np.array(
        [
            _log_odds(float(np.prod(confidences)), 1e-4),
            _log_odds(float(np.min(confidences, initial=1.0))),
            float(np.mean(silent)) if len(silent) else 0.0,
            float(np.sum(idle)) if len(cuts_s) else 0.0,
            float(len(alone) - sum(alone)),
            math.log(max(len(understood.order), 1)),
            float(not seen),
        ]
    )


def _same_chance(understood: Understood, node: int) -> float:
    if not understood.cut_chances:
        return chance_near(understood, float(understood.at_s[node]))
    return understood.cut_chances[understood.reading.nodes.index(node) - 1]


def _agrees(understood: Understood, at_s: float) -> bool:
    return any(abs(alone_s - at_s) < _SAME_S for alone_s in understood.alone_s)


def _log_timely(blur_s: float, jitter_s: float, *, spoken: bool, heard: bool) -> float:
    """Return the log of the chance that an instant is no more than half a second off."""
    spread_s = math.hypot(blur_s, 0.05)
    if heard:
        spread_s = max(jitter_s, 0.3)
    elif spoken:
        spread_s *= jitter_s / math.hypot(spread_s, jitter_s)
    return math.log(max(math.erf(_OFF_S / (spread_s * math.sqrt(2.0))), 1e-6))


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


def _log_odds(chance: float, least: float = 1e-3) -> float:
    inside = min(max(chance, least), 1.0 - least)
    return float(np.log(inside / (1.0 - inside)))


def _sigmoid(odds: float) -> float:
    return float(1.0 / (1.0 + np.exp(-odds)))
