"""The part of a recording that shows the task: who waits before it, or after it, shows nothing.

How long rests, steps and silences usually are is told by the whole of what was shown; a hand that
waits for its teacher would stretch all of that. So would words said before anything was done: no
cue comes before what it tells of.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from assistant.geometry import Array, angle_between, distance_between
from assistant.learning.jolts import jolts
from assistant.learning.signals import gripper_events
from assistant.learning.smoothing import Smoothed, smooth
from assistant.model.demonstration import Demonstration, Recording, Spoken
from assistant.model.settings import SegmentationSettings

_LEFT = 0.02
"""Of the farthest way from where it waits: a hand so near has yet to move."""
_KEPT_S = 1.0
_KEPT_SAMPLES = 3
"""So long, or so many samples, of a long rest before and after are kept."""
_LONG = 3.0
"""Times that: a shorter rest is left as it is."""
_AT_ONCE_S = 0.05
_FEWEST = 5


def shown_part(demonstration: Demonstration, settings: SegmentationSettings) -> Demonstration:
    """Return the demonstration without long rests at its ends, and without cues of nothing.

    Parameters
    ----------
    demonstration : Demonstration
    settings : SegmentationSettings

    Returns
    -------
    demonstration : Demonstration
        The very same where there is nothing to leave out.
    """
    recording = demonstration.recording
    if len(np.unique(recording.t_s)) < _FEWEST:
        return demonstration
    smoothed = smooth(recording, settings.smoothing)
    first_s, last_s = _acting(recording, smoothed, settings)
    kept_s = max(_KEPT_S, _KEPT_SAMPLES * float(np.median(np.diff(smoothed.t_s))))
    begin_s, end_s = float(smoothed.t_s[0]), float(smoothed.t_s[-1])
    inside, told_s = np.full(len(recording.t_s), True), (begin_s, end_s)
    if first_s - begin_s > _LONG * kept_s:
        inside, told_s = recording.t_s >= first_s - kept_s, (first_s, end_s)
    if end_s - last_s > _LONG * kept_s:
        inside, told_s = inside & (recording.t_s <= last_s + kept_s), (told_s[0], last_s)
    cues = _once(demonstration.cues, told_s[0], told_s[1] + settings.cues.most_lag_s)
    if np.all(inside) and cues == demonstration.cues:
        return demonstration
    return replace(demonstration, recording=_cut_to(recording, inside), cues=cues)


def _once(cues: Sequence[Spoken], first_s: float, last_s: float) -> tuple[Spoken, ...]:
    """Return the cues within a time, each once: who is heard twice at once spoke once."""
    found: list[Spoken] = []
    for cue in sorted(cues, key=lambda one: one.at_s):
        if first_s <= cue.at_s <= last_s and not (found and cue.at_s - found[-1].at_s < _AT_ONCE_S):
            found.append(cue)
    return tuple(found)


def _acting(
    recording: Recording, smoothed: Smoothed, settings: SegmentationSettings
) -> tuple[float, float]:
    """Return from when to when the hand moves or acts, in s."""
    away = [_away(smoothed, end, settings) for end in (0, -1)]
    left = [np.flatnonzero(far > _LEFT * np.max(far)) for far in away]
    if len(left[0]) == 0 or len(left[1]) == 0:
        return float(smoothed.t_s[0]), float(smoothed.t_s[-1])
    moving_s = smoothed.t_s[[left[0][0], left[1][-1]]]
    acted_s = [event.at_s for event in gripper_events(recording, settings.signals)]
    shaken_s = jolts(recording, smoothed, settings.jolts)[:, 0]
    every = np.concatenate([moving_s, acted_s, shaken_s])
    return float(np.min(every)), float(np.max(every))


def _away(smoothed: Smoothed, end: int, settings: SegmentationSettings) -> Array:
    """Return how far the hand is from its first or its last pose, in m, shape (n,)."""
    there = np.broadcast_to(smoothed.path[end], smoothed.path.shape)
    turned_m = settings.signals.turn_weight_m * angle_between(smoothed.path, there)
    return np.asarray(np.hypot(distance_between(smoothed.path, there), turned_m))


def _cut_to(recording: Recording, inside: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> Recording:
    if np.all(inside):
        return recording
    gripper_m = None if recording.gripper_m is None else recording.gripper_m[inside]
    return Recording(recording.t_s[inside], recording.path[inside], gripper_m)
