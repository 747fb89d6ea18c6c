"""Read a demonstration: weigh signals, cues and introduction, and decode cuts and assignment."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from assistant.geometry import Array
from assistant.learning.candidates import Candidate, Evidence
from assistant.learning.cue_lag import SAME_LAG_S, Lag, estimate, modes, refined
from assistant.learning.decoding import Lattice, Reading, decode
from assistant.learning.following import Following, following, jogged
from assistant.learning.introduction import orders, other_orders
from assistant.learning.passing import passed
from assistant.learning.posterior import cut_shares, unnamed_places, whole_evidence
from assistant.learning.scoring import heard_lattice, motion_lattice, reordered, told_lattice
from assistant.model.demonstration import Demonstration
from assistant.model.settings import CueSettings, SegmentationSettings
from assistant.model.task import Task, primitives

_SAME_CUT_S = 0.4
"""Cuts so near to each other are one and the same."""
_AT_THE_END = 1.0 / 6.0
"""Of the chance of an untold step at the end: a hand that only leaves is asked about if it is about
as likely a step of its own as not.
"""


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

    def left_out(self) -> dict[int, float]:
        """Return how likely each leaf of the tree was never shown, where that was decoded."""
        if self.lattice is None:
            return {}
        shown = np.sum(self.reading.step_chances, axis=0)
        return {
            leaf: float(np.clip(1.0 - chance, 0.0, 1.0))
            for leaf, chance in zip(self.order, shown, strict=True)
        }

    def unheard(self) -> tuple[tuple[float, float, float], ...]:
        """Return from when to when steps nobody introduced may lie, and how likely they do.

        In seconds, the likeliest first; nothing where nothing was decoded. A hand that leaves at
        the end, when all is done, is seldom a step that somebody should have told.
        """
        if self.lattice is None:
            return ()
        end_s = float(self.at_s[-1])
        told = [
            (from_s, to_s, chance * (_AT_THE_END if to_s == end_s else 1.0))
            for from_s, to_s, chance in unnamed_places(self.lattice, self.at_s)
        ]
        return tuple(sorted(told, key=lambda place: -place[2]))


def read(
    demonstration: Demonstration,
    task: Task,
    evidence: Evidence,
    settings: SegmentationSettings,
) -> Understood:
    """Return the best reading; the teacher's lag and the cuts sharpen each other."""
    cues_s = np.array([cue.at_s for cue in demonstration.cues])
    end_s = float(evidence.smoothed.t_s[-1])
    usual_s = _usual_s(task, evidence)
    evidence = replace(evidence, candidates=passed(evidence.candidates, evidence, usual_s))
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
    jogs = jogged(demonstration.recording)
    return replace(_refined(best, cues_s, settings.cues, jogs), alone_s=alone_s)


def _usual_s(task: Task, evidence: Evidence) -> float:
    """Return the mean time from one introduced cut to the next."""
    return float(np.ptp(evidence.smoothed.t_s)) / max(len(primitives(task.tree)), 1)


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
    usual_s = _usual_s(task, evidence)
    for lag in lags:
        candidates = _with_heard(evidence, cues_s, lag, usual_s)
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


def _refined(understood: Understood, cues_s: Array, given: CueSettings, jogs: bool) -> Understood:
    """Return the reading with the cuts' instants refined by the cues; their order is kept."""
    inner = np.array(understood.reading.nodes[1:-1], dtype=np.int64)
    if understood.lag is None or len(inner) == 0:
        return understood
    spots = [understood.candidates[k - 1] for k in inner]
    blur_s = np.array([spot.blur_s for spot in spots])
    acted = np.array([spot.gripper for spot in spots])
    heard = np.array([spot.heard for spot in spots])
    shown_s, end_s = understood.at_s[inner], float(np.ptp(understood.at_s))
    seen_s, seen_blur_s, seen_acted = shown_s[~heard], blur_s[~heard], acted[~heard]
    led = Following(0.0, understood.lag)
    if jogs:
        led = following(cues_s, seen_s, seen_blur_s, seen_acted, end_s, understood.lag, given)
    late_s = np.where(heard, led.lag.best_s - understood.lag.best_s, np.where(acted, 0, led.late_s))
    at_s = understood.at_s.copy()
    at_s[inner] = refined(cues_s, shown_s - late_s, blur_s, led.lag)
    in_order = bool(np.all(np.diff(at_s[list(understood.reading.nodes)]) > 0.0))
    return replace(understood, at_s=at_s, lag=led.lag) if in_order else understood


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


def _with_heard(
    evidence: Evidence, cues_s: Array, lag: Lag, usual_s: float
) -> tuple[Candidate, ...]:
    """Add an instant for each cue where no signal proposes one."""
    begin_s, end_s = float(evidence.smoothed.t_s[0]), float(evidence.smoothed.t_s[-1])
    known = np.array([spot.at_s for spot in evidence.candidates])
    blur = np.array([max(0.3, 1.5 * spot.blur_s) for spot in evidence.candidates])
    heard = [
        Candidate(float(at), heard=True)
        for at in np.unique(cues_s - lag.best_s)
        if begin_s + 0.2 < at < end_s - 0.2 and not np.any(np.abs(known - at) < blur)
    ]
    told = passed(heard, evidence, usual_s)
    return tuple(sorted([*evidence.candidates, *told], key=lambda spot: spot.at_s))


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
    """Return the best reading with these candidates and this lag; `fixed` cuts are all kept."""
    t_s = evidence.smoothed.t_s
    at_s = np.array([t_s[0], *(spot.at_s for spot in candidates), t_s[-1]])
    if fixed:
        lattice = told_lattice(demonstration, task, evidence, at_s, settings)
    else:
        lattice = motion_lattice(demonstration, task, evidence, candidates, settings)
    if lag is not None:
        blur_s = np.array([spot.blur_s for spot in candidates])
        lattice = heard_lattice(lattice, at_s, cues_s, blur_s, lag, settings)
    told = [(order, 0.0) for order in orders(task)]
    if not fixed:
        told += [(order, settings.decoding.reorder) for order in other_orders(task)]
    order, reading, lattice, share = _best_order(lattice, told)
    return Understood(at_s, candidates, reading, order, lag, lattice, order_chance=share)


def _best_order(
    lattice: Lattice, told: Sequence[tuple[tuple[int, ...], float]]
) -> tuple[tuple[int, ...], Reading, Lattice, float]:
    """Return the order that reads best for what it costs, with its share among all orders."""
    lattices = [reordered(lattice, order) for order, _ in told]
    ways = [decode(each) for each in lattices]
    odds = np.array([way.evidence - cost for way, (_, cost) in zip(ways, told, strict=True)])
    best = int(np.argmax(odds))
    share = float(1.0 / np.sum(np.exp(odds - odds[best])))
    return told[best][0], ways[best], lattices[best], share
