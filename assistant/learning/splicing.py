"""One stretch of a demonstration shown again: it takes the old one's place, the rest is kept.

Differs: the paper shows the whole task once (III); a teacher who slipped in one step need not
show the others again.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
import numpy.typing as npt

from assistant.geometry import Array, angle_between, distance_between, interpolate
from assistant.model.demonstration import Demonstration, Recording, Spoken

NEAR_M = 0.06
"""What is shown again begins and ends no farther than this from where the stretch does."""
TURN_M = 0.1
"""A radian between two poses counts as much as so many meters."""
TOUCHING_M = 5e-4
"""Least way between two samples of what leads from what was kept to what was shown again."""
AROUND_S = 0.5
"""A cut lies at the instant the hand acts, give or take this much."""
LATE_S = 2.0
"""A cue that marks the beginning of a stretch comes no later than this within it."""
Bools = npt.NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Spliced:
    """A demonstration with one stretch replaced.

    Parameters
    ----------
    demonstration : Demonstration
    to_s : float
        When the stretch ends now; it begins when it did.
    """

    demonstration: Demonstration
    to_s: float


@dataclass(frozen=True, slots=True)
class Apart:
    """Why what was shown does not fit into its place.

    Parameters
    ----------
    end : {"begins", "ends"}
    away_mm : float
        How far from where it should; 0 where the place is right and the hand is not as open.
    """

    end: Literal["begins", "ends"]
    away_mm: float = 0.0


def spliced(
    whole: Demonstration, from_s: float, to_s: float, again: Demonstration
) -> Spliced | Apart:
    """Return a demonstration with a stretch as it was shown again.

    Of a showing that begins or ends elsewhere only what lies between where the stretch began
    and ended is taken.

    Parameters
    ----------
    whole : Demonstration
    from_s, to_s : float
        The stretch, on the clock of `whole`.
    again : Demonstration
        The stretch alone, or more.
    """
    old, new = whole.recording, again.recording
    first = int(np.searchsorted(old.t_s, from_s))
    last = max(int(np.searchsorted(old.t_s, to_s, side="right")) - 1, first)
    half_m = _half_open(old)
    was, now = _closed(old, half_m), _closed(new, half_m)
    begin = _joint(new, now, old.path[first], _states(old, was, from_s), "begins")
    if isinstance(begin, Apart):
        return begin
    end = _joint(new, now, old.path[last], _states(old, was, to_s), "ends", begin)
    if isinstance(end, Apart):
        return end
    middle, lead_s = _led(old, (first, last), _part(new, begin, end + 1))
    moved_s = float(middle.t_s[-1] - old.t_s[last])
    recording = _joined((_part(old, 0, first), middle, _part(old, last + 1, None)), moved_s, half_m)
    taken_s = (float(new.t_s[begin]), float(new.t_s[end]))
    put_s = float(middle.t_s[0]) + lead_s - taken_s[0]
    cues, key_states = (
        (*_kept(said, from_s, to_s, moved_s), *_placed(more, taken_s, put_s))
        for said, more in ((whole.cues, again.cues), (whole.key_states, again.key_states))
    )
    changed = replace(
        whole, recording=recording, cues=_in_time(cues), key_states=_in_time(key_states)
    )
    return Spliced(changed, to_s + moved_s)


def _part(recording: Recording, first: int, end: int | None) -> Recording:
    gripper = None if recording.gripper_m is None else recording.gripper_m[first:end]
    return Recording(recording.t_s[first:end], recording.path[first:end], gripper)


def _half_open(recording: Recording) -> float | None:
    opening = recording.gripper_m
    return None if opening is None else (float(opening.min()) + float(opening.max())) / 2.0


def _closed(recording: Recording, half_m: float | None) -> Bools | None:
    """Return whether the hand is closed, by half the travel of the whole demonstration."""
    if half_m is None or recording.gripper_m is None:
        return None
    return np.asarray(recording.gripper_m < half_m)


def _states(recording: Recording, closed: Bools | None, at_s: float) -> frozenset[bool]:
    """Return how the hand is about an instant."""
    if closed is None:
        return frozenset((True, False))
    near = np.abs(recording.t_s - at_s) <= AROUND_S
    return frozenset(bool(one) for one in closed[near])


def _joint(
    new: Recording,
    closed: Bools | None,
    pose: Array,
    states: frozenset[bool],
    end: Literal["begins", "ends"],
    earliest: int = 0,
) -> int | Apart:
    """Return the sample of a showing that is put at an end of the stretch."""
    away = _away(new.path, pose)
    fits = np.full(len(away), True) if closed is None else np.isin(closed, list(states))
    fits[:earliest] = False
    outermost = 0 if end == "begins" else len(away) - 1
    if fits[outermost] and away[outermost] <= NEAR_M:
        return outermost
    if not fits.any():
        return Apart(end)
    nearest = int(np.argmin(np.where(fits, away, np.inf)))
    return nearest if away[nearest] <= NEAR_M else Apart(end, 1000.0 * float(away[nearest]))


def _led(old: Recording, place: tuple[int, int], taken: Recording) -> tuple[Recording, float]:
    """Return what was shown again, led to and on from, and how long it is led to.

    It begins when the samples at its place did.
    """
    first, last = place
    step_s = float(np.median(np.diff(old.t_s)))
    # From sample to sample the hand goes as far as it did there, or as it does in the mean.
    away = _away(old.path[1:], old.path[:-1])
    strides_m = np.maximum(np.append(away, 0.0), away.mean())
    lead = taken.path[:0]
    if first:
        lead = _way(old.path[first - 1], taken.path[0], float(strides_m[first - 1]))
    after = old.path[last + 1] if last + 1 < len(old.t_s) else taken.path[-1]
    tail = _way(taken.path[-1], after, float(strides_m[last]))
    lead_s = step_s * len(lead)
    taken_s = lead_s + taken.t_s - taken.t_s[0]
    tail_s = taken_s[-1] + step_s * np.arange(1.0, len(tail) + 1.0)
    t_s = np.concatenate([step_s * np.arange(float(len(lead))), taken_s, tail_s])
    gripper = taken.gripper_m
    if old.gripper_m is not None and gripper is not None:
        ends = np.full(len(lead), gripper[0]), np.full(len(tail), gripper[-1])
        gripper = np.concatenate([ends[0], gripper, ends[1]])
    path = np.concatenate([lead, taken.path, tail])
    return Recording(old.t_s[first] + t_s, path, gripper), lead_s


def _away(poses: Array, others: Array) -> Array:
    """Return how far poses are from others, in m, their turns among it."""
    return distance_between(poses, others) + TURN_M * angle_between(poses, others)


def _way(start: Array, goal: Array, stride_m: float) -> Array:
    """Return poses between two that lead smoothly from one to the other, both left out."""
    count = max(math.ceil(float(_away(start, goal)) / max(stride_m, TOUCHING_M) - 0.5) - 1, 0)
    share = np.linspace(0.0, 1.0, count + 2)[1:-1]
    return interpolate(start, goal, share**3 * (10.0 - 15.0 * share + 6.0 * share**2))


def _joined(parts: tuple[Recording, ...], moved_s: float, half_m: float | None) -> Recording:
    before, middle, after = parts
    gripper: Array | None = None
    openings = [part.gripper_m for part in parts if part.gripper_m is not None]
    if half_m is not None and len(openings) == len(parts):
        ahead, own, behind = openings
        # An instant at which the hand acts just beside a cut must not be there twice.
        ahead = _settled(ahead[::-1], before.t_s[::-1], float(own[0]), half_m)[::-1]
        behind = _settled(behind, after.t_s, float(own[-1]), half_m)
        gripper = np.concatenate([ahead, own, behind])
    return Recording(
        np.concatenate([before.t_s, middle.t_s, after.t_s + moved_s]),
        np.concatenate([part.path for part in parts]),
        gripper,
    )


def _settled(opening_m: Array, t_s: Array, beside_m: float, half_m: float) -> Array:
    """Return openings, from a joint outward, that begin as open as the hand is beside it.

    Only for as long as a cut may be off: what goes on for longer is another opening.
    """
    same = np.flatnonzero((opening_m < half_m) == (beside_m < half_m))
    until = int(same[0]) if len(same) else 0
    if not until or abs(float(t_s[until] - t_s[0])) > AROUND_S:
        return opening_m
    return np.concatenate([np.full(until, beside_m), opening_m[until:]])


def _kept(
    said: tuple[Spoken, ...], from_s: float, to_s: float, moved_s: float
) -> tuple[Spoken, ...]:
    """Return what was said outside the stretch, or to mark where it begins."""
    late_s = min(from_s + LATE_S, to_s, to_s + moved_s)
    kept = (one for one in said if one.at_s <= late_s)
    later = (replace(one, at_s=one.at_s + moved_s) for one in said if one.at_s > to_s)
    return (*kept, *later)


def _placed(said: tuple[Spoken, ...], taken_s: tuple[float, float], put_s: float) -> list[Spoken]:
    """Return what was said in a showing after it began; that it begins was said before."""
    first_s = taken_s[0] + LATE_S
    heard = (one for one in said if first_s < one.at_s <= taken_s[1])
    return [replace(one, at_s=one.at_s + put_s) for one in heard]


def _in_time(said: tuple[Spoken, ...]) -> tuple[Spoken, ...]:
    return tuple(sorted(said, key=lambda one: one.at_s))
