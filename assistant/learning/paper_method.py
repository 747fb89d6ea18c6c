"""The method as printed: votes, false episodes, argmax of the joint probability (eqs. 1 to 4)."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from assistant.geometry import Array
from assistant.learning.candidates import Candidate, Evidence
from assistant.learning.decoding import Reading
from assistant.learning.fit import fits
from assistant.learning.points import signal_votes
from assistant.learning.reading import Understood
from assistant.learning.stretches import stretches
from assistant.learning.validity import validity
from assistant.learning.votes import overall, peaks
from assistant.model.demonstration import Demonstration
from assistant.model.motion import Indices
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Task, primitives

_LOWERED = (1.0, 0.75, 0.5, 0.25)
"""Shares of the mean vote tried in turn while a primitive stays empty (paper III-B)."""


def read_as_printed(
    demonstration: Demonstration, task: Task, evidence: Evidence, settings: SegmentationSettings
) -> Understood:
    """Return the paper's reading; cues count where they were spoken, without a lag.

    Source: paper III-A, III-B. An episode belongs to the primitive of the highest joint
    probability, and neighbors of one primitive are one, their border an internal point. Where
    a primitive stays empty, the threshold is lowered below the mean vote.
    """
    cues_s = np.array([cue.at_s for cue in demonstration.cues])
    leaves = primitives(task.tree)
    votes = signal_votes(evidence, cues_s, len(leaves) - 1, settings)
    total = overall(votes, settings.votes.weights)
    tries: list[tuple[int, int, Array, Array, Indices]] = []
    for share in _LOWERED:
        nodes = _survivors(evidence, total, share * float(np.mean(total)), settings)
        joint = joint_probabilities(nodes, task, demonstration, evidence, settings)
        best = np.argmax(joint, axis=1)
        tries.append((len(set(best.tolist())), -len(tries), nodes, joint, best))
        if tries[-1][0] == len(leaves):
            break
    _, _, nodes, joint, best = max(tries, key=lambda told: told[:2])
    chances = np.interp(nodes, evidence.smoothed.t_s, total) / sum(settings.votes.weights.values())
    return _as_reading(nodes, joint, best, chances)


def joint_probabilities(
    nodes: Array,
    task: Task,
    demonstration: Demonstration,
    evidence: Evidence,
    settings: SegmentationSettings,
) -> Array:
    """Return P(E, S) = P(S|E) P(E), eq. (3), shape (episodes, leaves)."""
    odds = fits(task, demonstration, evidence, stretches(nodes, evidence), settings)
    rows = np.arange(len(nodes) - 1)
    told = np.exp(odds[rows, rows + 1] - np.max(odds[rows, rows + 1], axis=1, keepdims=True))
    given = told / np.sum(told, axis=1, keepdims=True)
    valid = [validity(evidence, a, b, settings) for a, b in pairwise(nodes)]
    return np.asarray(given * np.array(valid)[:, None])


def _survivors(
    evidence: Evidence, total: Array, threshold: float, settings: SegmentationSettings
) -> Array:
    """Return start, surviving points and end: false episodes join their likelier neighbor."""
    t_s = evidence.smoothed.t_s
    nodes = [float(t_s[0]), *(float(at) for at in peaks(t_s, total, threshold)), float(t_s[-1])]
    while len(nodes) > 2:
        valid = [validity(evidence, a, b, settings) for a, b in pairwise(nodes)]
        worst = int(np.argmin(valid))
        if valid[worst] >= settings.validity.false_below:
            break
        left = valid[worst - 1] if worst > 0 else -1.0
        right = valid[worst + 1] if worst + 1 < len(valid) else -1.0
        del nodes[worst if left >= right else worst + 1]
    return np.array(nodes)


def _as_reading(nodes: Array, joint: Array, best: Indices, chances: Array) -> Understood:
    ends = [k + 1 for k in range(len(best)) if k + 1 == len(best) or best[k + 1] != best[k]]
    steps = np.zeros((len(nodes), joint.shape[1]))
    share = joint / np.maximum(np.sum(joint, axis=1, keepdims=True), 1e-12)
    for end in ends:
        steps[end, best[end - 1]] = share[end - 1, best[end - 1]]
    reading = Reading(
        score=float(np.sum(np.log(np.maximum(np.max(joint, axis=1), 1e-12)))),
        evidence=0.0,
        nodes=(0, *ends),
        taken=tuple(int(best[end - 1]) for end in ends),
        cut_chances=np.minimum(chances, 1.0),
        step_chances=steps,
    )
    spots = tuple(Candidate(float(at)) for at in nodes[1:-1])
    return Understood(nodes, spots, reading, tuple(range(joint.shape[1])), None)
