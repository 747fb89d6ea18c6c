"""Read a demonstration: weigh signals, cues and introduction, and decode cuts and assignment."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from assistant.geometry import Array
from assistant.learning.candidates import Candidate, Evidence
from assistant.learning.cue_lag import SAME_LAG_S, Lag, estimate, modes, refined, support
from assistant.learning.decoding import Lattice, Reading, decode
from assistant.learning.fit import fits, stretches
from assistant.learning.introduction import orders, other_orders
from assistant.learning.posterior import cut_shares, whole_evidence
from assistant.model.demonstration import Demonstration
from assistant.model.settings import DecodingSettings, SegmentationSettings
from assistant.model.task import Task, primitives

_NEVER = -1e6
_TOLD_CUTS_FACTOR = 4.0
_SAME_CUT_S = 0.4
"""Cuts so near to each other are one and the same."""
_AT_TOLD_CUT_S = 0.25
"""A gripper event so near to a cut that was told belongs to that cut."""


@dataclass(frozen=True, slots=True, eq=False)
class Understood:
    """A demonstration as read.

    Parameters
    ----------
    at_s : array, shape (n,)
        Start, candidates, end.
    candidates : tuple of Candidate
        Without start and end.
    reading : Reading
        Over `at_s`; positions are those of `order`.
    order : tuple of int
        Leaves in the order in which they were shown.
    lag : Lag or None
        None without cues.
    lattice : Lattice or None
        What was decoded; None where nothing was.
    cut_chances : tuple of float
        For each cut, how likely the same primitive ends there, whatever the lag; empty where
        the cuts were told.
    whole_chance : float
        How likely it is that all of this is right, as far as the decoder can tell.
    order_chance : float
        How likely the parts were shown in this order.
    alone_s : tuple of float
        The cuts as read without the cues.
    """

    at_s: Array
    candidates: tuple[Candidate, ...]
    reading: Reading
    order: tuple[int, ...]
    lag: Lag | None
    lattice: Lattice | None = None
    cut_chances: tuple[float, ...] = ()
    whole_chance: float = 1.0
    order_chance: float = 1.0
    alone_s: tuple[float, ...] = ()

    def leaf(self, position: int | None) -> int | None:
        """Return which leaf of the tree a position of the reading is."""
        return None if position is None else self.order[position]


def read(
    demonstration: Demonstration,
    task: Task,
    evidence: Evidence,
    settings: SegmentationSettings,
) -> Understood:
    """Return the best reading; the teacher's lag and the cuts sharpen each other."""
    cues_s = np.array([cue.at_s for cue in demonstration.cues])
    end_s = float(evidence.smoothed.t_s[-1])
    understood = _read(demonstration, task, evidence, settings, evidence.candidates, cues_s, None)
    alone_s = tuple(understood.at_s[list(understood.reading.nodes[1:-1])].tolist())
    if len(cues_s) == 0:
        return replace(_sure(understood, [understood], np.ones(1)), alone_s=alone_s)
    chances = understood.reading.cut_chances[1:-1]
    blur_s = np.array([spot.blur_s for spot in understood.candidates])
    lag = estimate(cues_s, understood.at_s[1:-1], blur_s, chances, end_s, settings.cues)
    found = modes(lag)
    lags = [way for way, _ in found]
    ways = _with_lags(demonstration, task, evidence, settings, cues_s, lags)
    for _ in range(settings.cues.rounds):
        lags = [
            _sharpened(way, lag, cues_s, end_s, settings)
            for way, lag in zip(ways, lags, strict=True)
        ]
        ways = _with_lags(demonstration, task, evidence, settings, cues_s, lags)
    best = max(ways, key=lambda way: way.reading.evidence + _usual(way, settings))
    best = _sure(best, ways, np.array([share for _, share in found]))
    return replace(best, at_s=_refined(best, cues_s), alone_s=alone_s)


def _usual(way: Understood, settings: SegmentationSettings) -> float:
    """Return how usual a teacher's lag is, in log odds."""
    given = settings.cues
    lag_s = way.lag.best_s if way.lag is not None else given.usual_lag_s
    return -0.5 * ((lag_s - given.usual_lag_s) / given.usual_lag_spread_s) ** 2


def _with_lags(
    demonstration: Demonstration,
    task: Task,
    evidence: Evidence,
    settings: SegmentationSettings,
    cues_s: Array,
    lags: Sequence[Lag],
) -> list[Understood]:
    """Return the readings with each of several lags."""
    found = []
    for lag in lags:
        candidates = _with_heard(evidence, cues_s, lag)
        found.append(_read(demonstration, task, evidence, settings, candidates, cues_s, lag))
    return found


def _sharpened(
    way: Understood, lag: Lag, cues_s: Array, end_s: float, settings: SegmentationSettings
) -> Lag:
    """Return the teacher's lag, told anew by the cuts that it helped to find."""
    blur_s = np.array([spot.blur_s for spot in way.candidates])
    chances = way.reading.cut_chances[1:-1]
    told = estimate(cues_s, way.at_s[1:-1], blur_s, chances, end_s, settings.cues)
    kept = np.where(np.abs(told.lags_s - lag.best_s) < SAME_LAG_S, told.chances, 0.0)
    total = float(np.sum(kept))
    return replace(told, chances=kept / total) if total > 1e-9 else lag


def _sure(best: Understood, ways: Sequence[Understood], shares: Array) -> Understood:
    """Return the best reading with its chances among all readings with all lags."""
    cuts_s = best.at_s[list(best.reading.nodes[1:-1])]
    odds = np.log(shares) + np.array([way.reading.evidence for way in ways])
    weights = np.exp(odds - np.max(odds))
    each, whole = np.zeros(len(cuts_s)), 0.0
    for way, weight in zip(ways, weights / np.sum(weights), strict=True):
        same = way.order == best.order
        taken = best.reading.taken if same else (None,) * len(best.reading.taken)
        each += weight * cut_shares(way.reading, way.at_s, cuts_s, taken, _SAME_CUT_S)
        if same and way.lattice is not None:
            told = whole_evidence(way.lattice, way.at_s, cuts_s, taken, _SAME_CUT_S)
            whole += float(weight * way.order_chance * np.exp(told - way.reading.evidence))
    return replace(best, cut_chances=tuple(each.tolist()), whole_chance=min(whole, 1.0))


def _refined(understood: Understood, cues_s: Array) -> Array:
    """Return the instants with those of the cuts refined by the cues; their order is kept."""
    at_s = understood.at_s.copy()
    inner = np.array(understood.reading.nodes[1:-1], dtype=np.int64)
    if understood.lag is None or len(inner) == 0:
        return at_s
    blur_s = np.array([understood.candidates[k - 1].blur_s for k in inner])
    moved = refined(cues_s, at_s[inner], blur_s, understood.lag)
    kept = at_s.copy()
    kept[inner] = moved
    nodes = kept[list(understood.reading.nodes)]
    return kept if bool(np.all(np.diff(nodes) > 0.0)) else at_s


def read_cuts(
    demonstration: Demonstration,
    task: Task,
    evidence: Evidence,
    settings: SegmentationSettings,
    cuts_s: Sequence[float],
) -> Understood:
    """Return the best assignment where the cuts are told."""
    told = tuple(Candidate(float(at)) for at in sorted(cuts_s))
    return _read(demonstration, task, evidence, settings, told, np.zeros(0), None, fixed=True)


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
            + given.depth * min(spot.depth, given.deepest)
            + given.rest * np.log1p(spot.rest_s / (0.1 * usual_s))
            + given.bend * spot.bend
            + given.gripper * spot.gripper
            + given.jolt * np.log1p(spot.jolt)
            - given.part * spot.part
            - given.heard * spot.heard
            - given.settling * spot.settling
            for spot in candidates
        ]
    ).reshape(len(candidates))


def _with_heard(evidence: Evidence, cues_s: Array, lag: Lag) -> tuple[Candidate, ...]:
    """Add an instant for each cue where no signal proposes one."""
    begin_s, end_s = float(evidence.smoothed.t_s[0]), float(evidence.smoothed.t_s[-1])
    known = np.array([spot.at_s for spot in evidence.candidates])
    blur = np.array([max(0.3, 1.5 * spot.blur_s) for spot in evidence.candidates])
    heard = [
        Candidate(float(at), heard=True)
        for at in np.unique(cues_s - lag.best_s)
        if begin_s + 0.2 < at < end_s - 0.2 and not np.any(np.abs(known - at) < blur)
    ]
    return tuple(sorted([*evidence.candidates, *heard], key=lambda spot: spot.at_s))


def _read(
    demonstration: Demonstration,
    task: Task,
    evidence: Evidence,
    settings: SegmentationSettings,
    candidates: tuple[Candidate, ...],
    cues_s: Array,
    lag: Lag | None,
    *,
    fixed: bool = False,
) -> Understood:
    t_s = evidence.smoothed.t_s
    leaves = primitives(task.tree)
    given = settings.decoding
    # Where the teacher cut, there is a step: leaving one out or naming none takes more.
    rare = _TOLD_CUTS_FACTOR if fixed else 1.0
    at_s = np.array([t_s[0], *(spot.at_s for spot in candidates), t_s[-1]])
    between = stretches(at_s, evidence, _AT_TOLD_CUT_S if fixed else 1e-6)
    steps = fits(task, demonstration, evidence, between, settings)
    unnamed = -rare * given.insert + np.where(
        between.lasting_s < settings.validity.least_s, -3.0, 0.0
    )
    cuts = np.zeros(len(at_s))
    cuts[1:-1] = local_scores(candidates, float(np.ptp(t_s)) / max(len(leaves), 1), given)
    if lag is not None:
        blur_s = np.array([spot.blur_s for spot in candidates])
        alone, shared = _heard(cues_s, at_s, blur_s, lag, len(leaves), settings)
        cuts[1:-1] += alone
        steps[1:-1, 1:-1] -= shared[:, :, None]
        unnamed[1:-1, 1:-1] -= shared
    if fixed:
        apart = np.triu(np.full(unnamed.shape, _NEVER), 2)
        steps, unnamed, cuts = steps + apart[:, :, None], unnamed + apart, np.zeros(len(at_s))
    skips = -rare * np.array(
        [given.skip_optional if leaf.optional else given.skip for leaf in leaves]
    )
    told = [(order, 0.0) for order in orders(task)]
    if not fixed:
        told += [(order, given.reorder) for order in other_orders(task)]
    lattices = [
        Lattice(cuts, steps[:, :, list(order)], unnamed, skips[list(order)]) for order, _ in told
    ]
    ways = [decode(each) for each in lattices]
    odds = np.array([way.evidence - cost for way, (_, cost) in zip(ways, told, strict=True)])
    best = int(np.argmax(odds))
    share = float(1.0 / np.sum(np.exp(odds - odds[best])))
    order = told[best][0]
    return Understood(at_s, candidates, ways[best], order, lag, lattices[best], order_chance=share)


def _heard(
    cues_s: Array,
    at_s: Array,
    blur_s: Array,
    lag: Lag,
    leaves: int,
    settings: SegmentationSettings,
) -> tuple[Array, Array]:
    given = settings.cues
    missing = float(np.clip(1.0 - len(cues_s) / max(leaves - 1, 1), given.least_missing, 0.9))
    false_rate = max(len(cues_s) * given.false_share, 0.3) / float(np.ptp(at_s))
    return support(cues_s, at_s[1:-1], blur_s, lag, missing, false_rate)
