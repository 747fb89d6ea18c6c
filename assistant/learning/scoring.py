"""What speaks for each cut and each stretch, in log odds: motion, events, places, and cues.

Source: paper III-A and III-B; deciding cuts and assignment together is ours.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from assistant.geometry import Array
from assistant.learning.candidates import Candidate, Evidence
from assistant.learning.cue_lag import Lag, support
from assistant.learning.decoding import Lattice
from assistant.learning.fit import fits
from assistant.learning.handling import acted, untold
from assistant.learning.leading import unled
from assistant.learning.stretches import Stretches, stretches
from assistant.model.demonstration import Demonstration
from assistant.model.settings import DecodingSettings, SegmentationSettings
from assistant.model.task import Task, primitives

_NEVER = -1e6
_TOLD_CUTS_FACTOR = 4.0
"""Where the teacher cut, there is a step: leaving one out or naming none takes more."""
_AT_TOLD_CUT_S = 0.25
"""A gripper event so near to a cut that was told belongs to that cut."""
_AT_CUT_S = 1e-6
_BRIEF = -3.0


def motion_lattice(
    demonstration: Demonstration,
    task: Task,
    evidence: Evidence,
    candidates: Sequence[Candidate],
    settings: SegmentationSettings,
) -> Lattice:
    """Return what the motion says, with the leaves in the tree's order."""
    t_s = evidence.smoothed.t_s
    at_s = np.array([t_s[0], *(spot.at_s for spot in candidates), t_s[-1]])
    lattice = _stretches(demonstration, task, evidence, at_s, settings)
    usual_s = float(np.ptp(t_s)) / max(len(primitives(task.tree)), 1)
    inner = local_scores(candidates, usual_s, settings.decoding)
    return replace(lattice, cuts=np.concatenate([[0.0], inner, [0.0]]))


def told_lattice(
    demonstration: Demonstration,
    task: Task,
    evidence: Evidence,
    at_s: Array,
    settings: SegmentationSettings,
) -> Lattice:
    """Return what the motion says where the cuts are told: no stretch passes over one."""
    lattice = _stretches(
        demonstration, task, evidence, at_s, settings, _TOLD_CUTS_FACTOR, _AT_TOLD_CUT_S
    )
    apart = np.triu(np.full(lattice.unnamed.shape, _NEVER), 2)
    return replace(
        lattice, steps=lattice.steps + apart[:, :, None], unnamed=lattice.unnamed + apart
    )


def heard_lattice(
    lattice: Lattice,
    at_s: Array,
    cues_s: Array,
    blur_s: Array,
    lag: Lag,
    settings: SegmentationSettings,
) -> Lattice:
    """Return a lattice with what the cues say added, for one lag of the teacher."""
    given, leaves = settings.cues, len(lattice.skips)
    missing = float(np.clip(1.0 - len(cues_s) / max(leaves - 1, 1), given.least_missing, 0.9))
    false_rate = max(len(cues_s) * given.false_share, 0.3) / float(np.ptp(at_s))
    alone, shared = support(cues_s, at_s[1:-1], blur_s, lag, missing, false_rate)
    twice = np.pad(shared, 1)
    return replace(
        lattice,
        cuts=lattice.cuts + np.pad(alone, 1),
        steps=lattice.steps - twice[:, :, None],
        unnamed=lattice.unnamed - twice,
    )


def reordered(lattice: Lattice, order: Sequence[int]) -> Lattice:
    """Return a lattice with its leaves in another order."""
    leaves = list(order)
    # What led to a step does so only where it comes right before it.
    follows = np.diff(leaves, prepend=leaves[0]) == 1
    return replace(
        lattice,
        steps=lattice.steps[:, :, leaves],
        skips=lattice.skips[leaves],
        unled=np.where(follows, lattice.unled[:, :, leaves], 0.0),
    )


def local_scores(candidates: Sequence[Candidate], usual_s: float, given: DecodingSettings) -> Array:
    """Return what the motion itself says for a cut at each candidate, in log odds, shape (k,).

    Parameters
    ----------
    candidates : sequence of Candidate
    usual_s : float
        Mean time from one introduced cut to the next: rests are long or short against it.
    given : DecodingSettings
    """
    return np.array(
        [
            given.bias
            + given.slow * spot.slow
            + given.rest * np.log1p(spot.rest_s / (0.1 * usual_s))
            + given.bend * spot.bend
            + given.veer * spot.veer
            + given.gripper * spot.gripper
            + given.jolt * np.log1p(spot.jolt)
            - given.part * spot.part
            - given.heard * spot.heard
            - given.settling * spot.settling
            for spot in candidates
        ]
    ).reshape(len(candidates))


def _stretches(
    demonstration: Demonstration,
    task: Task,
    evidence: Evidence,
    at_s: Array,
    settings: SegmentationSettings,
    rare: float = 1.0,
    near_s: float = _AT_CUT_S,
) -> Lattice:
    """Return what motion, events and places say of each stretch; nothing yet of the cuts."""
    given = settings.decoding
    between = stretches(at_s, evidence, near_s)
    brief = np.where(between.lasting_s < settings.validity.least_s, _BRIEF, 0.0)
    leaves = primitives(task.tree)
    free = -rare * given.insert + brief - given.nothing * _nothing(between)
    if demonstration.recording.gripper_m is not None:
        free = free + rare * given.untold * untold(leaves, task, between)
        free = free + 0.5 * given.event * acted(leaves, between)
    skips = [given.skip_optional if leaf.optional else given.skip for leaf in leaves]
    return Lattice(
        cuts=np.zeros(len(at_s)),
        steps=fits(task, demonstration, evidence, between, settings),
        unnamed=free,
        skips=-rare * np.array(skips),
        unled=unled(leaves, between, settings),
    )


def _nothing(between: Stretches) -> Array:
    """Return where the hand neither goes nor turns, in [0, 1]: a step nobody told does so."""
    share = np.linalg.norm(between.ways, axis=-1) / between.extent_m
    turned = np.linalg.norm(between.turns, axis=-1) / 0.2
    return np.asarray(np.exp(-share / 0.03 - turned))
