"""Segmentation points with their voters, and episodes, from a reading."""

from __future__ import annotations

from types import MappingProxyType

import numpy as np

from assistant.geometry import Array
from assistant.learning.candidates import Evidence
from assistant.learning.character import character
from assistant.learning.confidence import cut_confidence, step_confidence, surely_moved
from assistant.learning.reading import Understood
from assistant.learning.validity import validity
from assistant.learning.votes import overall, peaks, sharpness, vote
from assistant.model.lesson import Episode, SegmentationPoint
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Primitive

_SAME_S = 0.12
"""A point so near to a rest belongs to it."""


def signal_votes(
    evidence: Evidence, cues_s: Array, cuts: int, settings: SegmentationSettings
) -> dict[str, Array]:
    """Return the vote of each signal over time, eq. (1); `cues_s` are already without the lag."""
    t_s, path = evidence.smoothed.t_s, evidence.smoothed.path
    instants = {
        "gripper": np.array([event.at_s for event in evidence.events]),
        "speed": np.array([spot.at_s for spot in evidence.minima]),
        "cue": cues_s,
        "jolt": evidence.jolts[:, 0],
    }
    return {
        name: vote(
            t_s,
            path,
            np.clip(at_s, t_s[0], t_s[-1]),
            sharpness(name, t_s, path, cuts, settings.votes),
            settings.signals.turn_weight_m,
        )
        for name, at_s in instants.items()
        if name in settings.votes.weights
    }


def points(
    understood: Understood,
    evidence: Evidence,
    votes: dict[str, Array],
    cues_s: Array,
    settings: SegmentationSettings,
) -> tuple[SegmentationPoint, ...]:
    """Return kept cuts, internal points of primitives and eliminated points, in order of time."""
    t_s = evidence.smoothed.t_s
    reading, at_s = understood.reading, understood.at_s
    nodes = list(reading.nodes[1:-1])
    found = [
        SegmentationPoint(
            float(at_s[node]),
            cut_confidence(understood, node, cues_s),
            _at(votes, t_s, float(at_s[node])),
        )
        for node in nodes
    ]
    return tuple(sorted([*found, *_others(understood, evidence, votes, settings)], key=_when))


def _others(
    understood: Understood,
    evidence: Evidence,
    votes: dict[str, Array],
    settings: SegmentationSettings,
) -> list[SegmentationPoint]:
    """Return what is no cut between primitives: points within one, and eliminated ones.

    A peak of the vote that leaves valid episodes on both sides is a point within a primitive;
    other peaks and candidates were eliminated (paper III-A).
    """
    t_s, at_s = evidence.smoothed.t_s, understood.at_s
    edges = at_s[list(understood.reading.nodes)]
    total = overall(votes, settings.votes.weights)
    voted = [_settled(evidence, at) for at in peaks(t_s, total, float(np.mean(total)))]
    found: list[SegmentationPoint] = []
    for at in (*voted, *(spot.at_s for spot in understood.candidates if not spot.part)):
        told = np.array([*edges, *(point.at_s for point in found)])
        if np.min(np.abs(told - at)) < settings.validity.least_s or _one_rest(evidence, at, told):
            continue
        internal = at in voted and _valid(evidence, edges, at, settings)
        sure = surely_moved(understood, at, settings)
        found.append(SegmentationPoint(at, sure, _at(votes, t_s, at), internal, internal))
    return found


def _settled(evidence: Evidence, at_s: float) -> float:
    """Return the gripper's instant within the rest an instant lies in, or the rest's middle."""
    for spot in evidence.minima:
        if spot.to_s > spot.from_s and spot.from_s - _SAME_S <= at_s <= spot.to_s + _SAME_S:
            acting = [e.at_s for e in evidence.events if spot.from_s <= e.at_s <= spot.to_s]
            return min(acting, key=lambda act: abs(act - at_s)) if acting else spot.at_s
    return float(at_s)


def _valid(evidence: Evidence, edges: Array, at_s: float, settings: SegmentationSettings) -> bool:
    after = int(np.searchsorted(edges, at_s))
    halves = ((edges[after - 1], at_s), (at_s, edges[after]))
    valid = min(validity(evidence, a, b, settings) for a, b in halves)
    return valid >= settings.validity.false_below


def episodes(
    understood: Understood, evidence: Evidence, leaves: tuple[Primitive, ...]
) -> tuple[Episode, ...]:
    """Return the episodes of the reading with the probability of each assignment."""
    reading, at_s = understood.reading, understood.at_s
    found = []
    for first, last, position in zip(
        reading.nodes[:-1], reading.nodes[1:], reading.taken, strict=True
    ):
        leaf = understood.leaf(position)
        from_s, to_s = float(at_s[first]), float(at_s[last])
        chance = step_confidence(understood, first, last, position)
        found.append(
            Episode(
                from_s,
                to_s,
                None if leaf is None else leaves[leaf].name,
                chance,
                character(evidence.smoothed, from_s, to_s),
            )
        )
    return tuple(found)


def _one_rest(evidence: Evidence, at_s: float, edges: Array) -> bool:
    """Tell whether the hand rests all the way from an instant to the nearest cut."""
    t_s = evidence.smoothed.t_s
    low, high = sorted((at_s, float(edges[np.argmin(np.abs(edges - at_s))])))
    between = evidence.pace[(t_s >= low) & (t_s <= high)]
    return bool(len(between) and np.max(between) < 0.5 * np.mean(evidence.pace))


def _when(point: SegmentationPoint) -> float:
    return point.at_s


def _at(votes: dict[str, Array], t_s: Array, at_s: float) -> MappingProxyType[str, float]:
    return MappingProxyType(
        {name: round(float(np.interp(at_s, t_s, told)), 4) for name, told in votes.items()}
    )
