"""Segmentation points with their voters, and episodes, from a reading."""

from __future__ import annotations

from types import MappingProxyType

import numpy as np

from assistant.geometry import Array
from assistant.learning.candidates import Evidence
from assistant.learning.character import character
from assistant.learning.confidence import calibrated_cut, calibrated_episode
from assistant.learning.reading import Understood
from assistant.learning.validity import validity
from assistant.learning.votes import overall, peaks, sharpness, vote
from assistant.model.lesson import Episode, SegmentationPoint
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Primitive


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
    settings: SegmentationSettings,
) -> tuple[SegmentationPoint, ...]:
    """Return kept cuts, internal points of primitives and eliminated points, in order of time."""
    t_s = evidence.smoothed.t_s
    reading, at_s = understood.reading, understood.at_s
    kept = at_s[list(reading.nodes[1:-1])]
    found = [
        SegmentationPoint(
            float(at),
            calibrated_cut(chance_near(understood, float(at))),
            _at(votes, t_s, float(at)),
        )
        for at in kept
    ]
    total = overall(votes, settings.votes.weights)
    edges = np.array([at_s[0], *kept, at_s[-1]])
    for at in peaks(t_s, total, float(np.mean(total))):
        if np.min(np.abs(edges - at)) < settings.validity.least_s:
            continue
        after = int(np.searchsorted(edges, at))
        halves = ((edges[after - 1], at), (at, edges[after]))
        valid = min(validity(evidence, a, b, settings) for a, b in halves)
        found.append(
            SegmentationPoint(
                float(at),
                calibrated_cut(chance_near(understood, float(at))),
                _at(votes, t_s, float(at)),
                kept=valid >= settings.validity.false_below,
                internal=valid >= settings.validity.false_below,
            )
        )
    return tuple(sorted(found, key=lambda point: point.at_s))


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
        chance = _step_chance(understood, first, last, position)
        found.append(
            Episode(
                from_s,
                to_s,
                None if leaf is None else leaves[leaf].name,
                calibrated_episode(chance),
                character(evidence.smoothed, from_s, to_s),
            )
        )
    return tuple(found)


def chance_near(understood: Understood, at_s: float) -> float:
    """Return the probability that the reading cuts near an instant."""
    near = np.abs(understood.at_s - at_s) < 0.25
    near[0] = near[-1] = False
    return float(min(np.sum(understood.reading.cut_chances[near]), 1.0))


def _step_chance(understood: Understood, first: int, last: int, position: int | None) -> float:
    """Return the probability that a stretch belongs to a primitive: that it ends there as such."""
    if position is None:
        return 0.5
    chances, at_s = understood.reading.step_chances, understood.at_s
    ends = float(np.sum(chances[np.abs(at_s - at_s[last]) < 0.25, position]))
    if first == 0:
        return min(ends, 1.0)
    before = chances[np.abs(at_s - at_s[first]) < 0.25]
    return float(min(ends, np.sum(before[:, : position + 1]), 1.0))


def _at(votes: dict[str, Array], t_s: Array, at_s: float) -> MappingProxyType[str, float]:
    return MappingProxyType(
        {name: round(float(np.interp(at_s, t_s, told)), 4) for name, told in votes.items()}
    )
