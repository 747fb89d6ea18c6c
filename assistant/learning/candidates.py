"""All instants at which the demonstration may be cut, with what each signal says there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from assistant.geometry import Array, angle_between, distance_between
from assistant.learning.jolts import jolts
from assistant.learning.onsets import centered
from assistant.learning.signals import (
    GripperEvent,
    Minimum,
    gripper_events,
    pace,
    speed_minima,
)
from assistant.learning.smoothing import Smoothed
from assistant.learning.votes import poses_at
from assistant.model.demonstration import Demonstration
from assistant.model.settings import SegmentationSettings

_TOGETHER_S = 0.12


@dataclass(frozen=True, slots=True)
class Candidate:
    """An instant proposed as a cut.

    Parameters
    ----------
    at_s : float
    depth : float
        Of the minimum of speed here, in log speed; 0 where there is none.
    rest_s : float
        How long the hand rests here.
    slow, bend, veer : float
        How the motion passes here, told by `assistant.learning.passing`.
    gripper : bool
        The gripper crossed half its travel here.
    jolt : float
        Strength of a jolt here.
    heard : bool
        Proposed by a spoken cue only.
    part : bool
        Within a rest in which the gripper acts, before it does.
    blur_s : float
        How well the instant is known (one standard deviation).
    settling : float
        How little the hand moves from here until it rests again, in [0, 1]: a small correction
        belongs to the reach it corrects.
    """

    at_s: float
    depth: float = 0.0
    rest_s: float = 0.0
    slow: float = 0.0
    bend: float = 0.0
    veer: float = 0.0
    gripper: bool = False
    jolt: float = 0.0
    heard: bool = False
    part: bool = False
    blur_s: float = 0.0
    settling: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """What the signals of one demonstration say."""

    smoothed: Smoothed
    pace: Array
    events: tuple[GripperEvent, ...]
    minima: tuple[Minimum, ...]
    jolts: Array
    candidates: tuple[Candidate, ...]


def gather(
    demonstration: Demonstration, smoothed: Smoothed, settings: SegmentationSettings
) -> Evidence:
    """Return the candidates of gripper, jolts and speed, merged where they are one instant."""
    signals = settings.signals
    speed = pace(smoothed, signals)
    events = gripper_events(demonstration.recording, signals)
    minima = speed_minima(smoothed.t_s, speed, signals)
    shaken = jolts(demonstration.recording, smoothed, settings.jolts)
    minima = tuple(sorted(minima, key=lambda spot: -spot.depth)[: signals.most_candidates])
    minima = centered(minima, smoothed, signals)
    merged = _merged(events, minima, shaken, smoothed)
    inside = [c for c in merged if smoothed.t_s[0] < c.at_s < smoothed.t_s[-1]]
    settling = _settling(inside, smoothed, settings)
    step = float(np.median(np.diff(smoothed.t_s)))
    found = tuple(
        replace(c, blur_s=_blur(c, step, settings), settling=float(s))
        for c, s in zip(inside, settling, strict=True)
    )
    return Evidence(smoothed, speed, events, minima, shaken, found)


def _merged(
    events: tuple[GripperEvent, ...],
    minima: tuple[Minimum, ...],
    shaken: Array,
    smoothed: Smoothed,
) -> list[Candidate]:
    """Join what is one instant: the gripper's within a rest, then jolts, then minima."""
    found: list[Candidate] = [Candidate(event.at_s, gripper=True) for event in events]
    for at, strength in shaken:
        near = [k for k, c in enumerate(found) if abs(c.at_s - at) < 4 * _TOGETHER_S]
        if near:
            found[near[0]] = replace(found[near[0]], jolt=float(strength))
        else:
            found.append(Candidate(float(at), jolt=float(strength)))
    for spot in minima:
        found = _with_minimum(found, spot, smoothed)
    return sorted(found, key=lambda c: c.at_s)


def _with_minimum(found: list[Candidate], spot: Minimum, smoothed: Smoothed) -> list[Candidate]:
    low, high = spot.from_s - _TOGETHER_S, spot.to_s + _TOGETHER_S
    rest = spot.to_s - spot.from_s
    inside = [k for k, c in enumerate(found) if low <= c.at_s <= high]
    if not inside:
        return [*found, Candidate(spot.at_s, spot.depth, rest)]
    joined = [
        replace(c, depth=max(c.depth, spot.depth), rest_s=max(c.rest_s, rest)) if k in inside else c
        for k, c in enumerate(found)
    ]
    # A rest with the gripper's instant in it may hold two cuts: one before, one at the instant.
    acting = [found[k].at_s for k in inside if found[k].gripper]
    if acting:
        step = 0.5 * (spot.from_s + acting[0])
        if acting[0] - spot.from_s > 4 * _TOGETHER_S:
            joined.append(Candidate(step, part=True))
    del smoothed
    return joined


def _blur(candidate: Candidate, step_s: float, settings: SegmentationSettings) -> float:
    given = settings.signals
    if candidate.gripper:
        return 0.1 * step_s
    if candidate.jolt > 0.0:
        return settings.jolts.blur_s
    # Where the hand hardly slows down, the minimum wanders; where it stops, it is sharp.
    shallow = given.blur_shallow_s * float(np.clip(given.clear_depth - candidate.depth, 0.0, 1.0))
    told = (given.blur_least_s, given.blur_of_rest * candidate.rest_s, given.blur_steps * step_s)
    return float(np.linalg.norm([*told, shallow]))


def _settling(
    found: Sequence[Candidate], smoothed: Smoothed, settings: SegmentationSettings
) -> Array:
    """Return how little the hand moves from each rest to the next, unless the gripper acts."""
    settling = np.zeros(len(found))
    if len(found) < 2:
        return settling
    poses = poses_at(smoothed.t_s, smoothed.path, np.array([spot.at_s for spot in found]))
    extent_m = float(np.linalg.norm(np.ptp(smoothed.path[:, :3], axis=0))) + 1e-6
    turned_m = settings.signals.turn_weight_m * angle_between(poses[1:], poses[:-1])
    moved = np.hypot(distance_between(poses[1:], poses[:-1]), turned_m) / extent_m
    for k, (here, then) in enumerate(pairwise(found)):
        if not (here.gripper or then.gripper or here.jolt or then.jolt or here.part or then.part):
            settling[k] = np.exp(-0.5 * (moved[k] / settings.signals.correction) ** 2)
    return settling
