"""Probabilities that mean what they say: how sure the robot is of a cut and of an assignment.

The decoder's share of all readings that cut here is the ground. It knows only what it weighed,
and believes the signals to be independent; a logistic regression on few features corrects it.
Its weights come from `tests.benchmarks.bench_confidence`, which prints them.
"""

from __future__ import annotations

import math

import numpy as np

from assistant.geometry import Array
from assistant.learning.cue_lag import Lag
from assistant.learning.reading import Understood
from assistant.learning.scoring import local_scores
from assistant.model.settings import SegmentationSettings

FEATURES = (
    "right",
    "timely",
    "gripper",
    "heard",
    "alone",
    "near",
    "silent",
    "vague",
    "veer",
)
"""What a cut's confidence is made of.

``right``: log odds that the same primitive ends here, to half a second; ``timely``: of the
half second alone; ``gripper``: it acted here; ``heard``: proposed by a cue only; ``alone``: the
motion without cues is cut here too; ``near``: log odds that anything is cut near; ``silent``:
neither a cue nor the gripper tells it; ``vague``: how badly the instant is known where that is so,
in log tenths of a second; ``veer``: how much the way turns here.
"""

WEIGHTS = np.array([0.17, 0.15, 1.11, 0.64, 0.85, 0.15, -1.28, -0.26, 0.57])
BIAS = 0.18
"""Source: `python -m tests.benchmarks.bench_confidence --fit`."""

WHOLE_FEATURES = ("product", "whole", "timely", "silent", "orphans", "moved", "unlike")
"""What the confidence in all cuts together is made of.

``product``: log odds that all are right if they were independent; ``whole``: of the decoder's
share of readings with just these cuts and primitives; ``timely``: that all are within half a
second; ``silent``: cuts that neither a cue nor the gripper tells; ``orphans``: cues that tell no
cut; ``moved``: cuts that the motion without cues does not have; ``unlike``: primitives left empty
and steps nobody introduced.
"""

WHOLE_WEIGHTS = np.array([0.79, 0.11, 0.13, -0.03, -0.32, 0.02, -2.75])
WHOLE_BIAS = -0.11
"""Source: as above."""

_NEAR_S = 0.25
_SAME_S = 0.4
_OFF_S = 0.5
_HEARD_S = 0.3
_LEAST = 1e-3
_UNKNOWN_LAG = Lag(np.zeros(1), np.ones(1), 0.3)


def cut_confidence(understood: Understood, node: int, cues_s: Array) -> float:
    """Return the probability that a cut belongs at a node of the reading.

    Parameters
    ----------
    understood : Understood
    node : int
        Index into its instants.
    cues_s : array, shape (c,)
        Cues without the teacher's lag.
    """
    return _sigmoid(float(features(understood, node, cues_s) @ WEIGHTS + BIAS))


def features(understood: Understood, node: int, cues_s: Array) -> Array:
    """Return the values of `FEATURES` for a node, shape (9,)."""
    spot = understood.candidates[node - 1]
    at_s = float(understood.at_s[node])
    same, timely = _same_chance(understood, node), _timely(understood, node, cues_s)
    silent = float(not (spot.gripper or _spoken(at_s, cues_s)))
    return np.array(
        [
            _log_odds(same * timely),
            _log_odds(timely),
            float(spot.gripper),
            float(spot.heard),
            float(_agrees(understood, at_s)),
            _log_odds(chance_near(understood, at_s, _OFF_S)),
            silent,
            silent * math.log(math.hypot(spot.blur_s, 0.03) / 0.1),
            spot.veer,
        ]
    )


def all_right(understood: Understood, confidences: Array, cues_s: Array) -> float:
    """Return the probability that all cuts are right and none is missing.

    Parameters
    ----------
    understood : Understood
    confidences : array, shape (k,)
        Of its cuts.
    cues_s : array, shape (c,)
        Cues without the teacher's lag.
    """
    told = whole_features(understood, confidences, cues_s)
    return _sigmoid(float(told @ WHOLE_WEIGHTS + WHOLE_BIAS))


def whole_features(understood: Understood, confidences: Array, cues_s: Array) -> Array:
    """Return the values of `WHOLE_FEATURES`, shape (7,)."""
    taken, nodes = understood.reading.taken, understood.reading.nodes[1:-1]
    cuts_s = understood.at_s[list(nodes)]
    silent = [
        not (_spoken(at_s, cues_s) or understood.candidates[node - 1].gripper)
        for node, at_s in zip(nodes, cuts_s.tolist(), strict=True)
    ]
    unnamed = sum(position is None for position in taken)
    return np.array(
        [
            _log_odds(float(np.prod(confidences))),
            _log_odds(understood.whole_chance),
            _log_odds(math.prod(_timely(understood, node, cues_s) for node in nodes)),
            float(sum(silent)),
            float(sum(not _spoken(at_s, cuts_s) for at_s in cues_s.tolist())),
            float(sum(not _agrees(understood, at_s) for at_s in cuts_s.tolist())),
            float(unnamed + len(understood.order) - (len(taken) - unnamed)),
        ]
    )


def _same_chance(understood: Understood, node: int) -> float:
    if not understood.cut_chances:
        return chance_near(understood, float(understood.at_s[node]))
    return understood.cut_chances[understood.reading.nodes.index(node) - 1]


def _agrees(understood: Understood, at_s: float) -> bool:
    return any(abs(alone_s - at_s) < _SAME_S for alone_s in understood.alone_s)


def _spoken(at_s: float, cues_s: Array) -> bool:
    return bool(np.min(np.abs(cues_s - at_s), initial=math.inf) < _OFF_S)


def _timely(understood: Understood, node: int, cues_s: Array) -> float:
    """Return the chance that an instant, if it is the right one, is less than half a second off."""
    spot = understood.candidates[node - 1]
    # The lag itself is known to a tenth of a second.
    jitter_s = math.hypot((understood.lag or _UNKNOWN_LAG).jitter_s, 0.1)
    spread_s = math.hypot(spot.blur_s, 0.05)
    if spot.heard:
        spread_s = max(jitter_s, _HEARD_S)
    elif _spoken(float(understood.at_s[node]), cues_s):
        spread_s *= jitter_s / math.hypot(spread_s, jitter_s)
    return math.erf(_OFF_S / (spread_s * math.sqrt(2.0)))


def chance_near(understood: Understood, at_s: float, within_s: float = _NEAR_S) -> float:
    """Return the decoder's probability of a cut near an instant."""
    near = np.abs(understood.at_s - at_s) < within_s
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
    inside = min(max(chance, _LEAST), 1.0 - _LEAST)
    return float(np.log(inside / (1.0 - inside)))


def _sigmoid(odds: float) -> float:
    return float(1.0 / (1.0 + np.exp(-odds)))
