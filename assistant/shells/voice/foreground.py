"""The stretch of an utterance in which the nearest speaker speaks.

Voice activity takes others talking in the room, or a tap, for speech, and an utterance in noise
begins and ends with it; recognizers write that down as words. The teacher is louder than the
room: what lies far below the loud parts at either end is cut off. In silence nothing is.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from assistant.shells.voice.sound import RATE_HZ, Samples

FRAME = 480
HOP = 240
LOUD = 95
"""Percentile of the frames' levels taken for the speaker's."""
END_S = 0.2
"""The ends of an utterance are the room's, at least at one of them."""
ABOVE_ROOM_DB = 3.0
WITHIN_DB = (8.0, 30.0)
"""A speaker's soft sounds lie so far below the loud ones: at least in any room, at most."""
MARGIN_S = 0.2
SMOOTHED = 5
SHORTEST_S = 0.3
PAUSE_S = 0.5
CONSONANT_S = (0.15, 0.4)
"""Softer sounds for so long are no pause: in a quiet room, and where noise hides them."""
HIDDEN_S = 0.12
"""So much of the beginning and the end of speech a loud room hides."""
CLEAR_DB, HIDDEN = (3.0, 8.0, 12.0, 25.0), (0.0, 1.0, 1.0, 0.0)
"""How much of soft sounds is hidden: all of them in a loud room, none in a quiet one, and none
where the sound begins and ends within speech, so that no room is heard."""
FAINT = 0.1
"""Stretches beyond a pause that hold less than this share of the power are the room's."""


@dataclass(frozen=True, slots=True, eq=False)
class Foreground:
    """What the nearest speaker said.

    Parameters
    ----------
    samples : array of float32, shape (n,)
        With a margin at both ends.
    speech_s : float
        How long they spoke, without pauses.
    clear_db : float
        How far the speaker's loud sounds stand out of the room.
    """

    samples: Samples
    speech_s: float
    clear_db: float


def foreground(samples: Samples) -> Foreground:
    """Return the part of an utterance in which the nearest speaker speaks.

    Parameters
    ----------
    samples : array of float32, shape (n,)
    """
    whole = Foreground(samples, len(samples) / RATE_HZ, 0.0)
    if whole.speech_s < SHORTEST_S:
        return whole
    levels_db = _levels_db(samples)
    loud_db, room_db = _loud_and_room(levels_db)
    edge_db = np.clip(room_db + ABOVE_ROOM_DB, loud_db - WITHIN_DB[1], loud_db - WITHIN_DB[0])
    share = np.convolve(levels_db > edge_db, np.ones(SMOOTHED) / SMOOTHED, "same")
    loud = np.flatnonzero(share > 0.5)
    if not len(loud):
        return whole
    first, last = _speaker(loud, 10.0 ** (levels_db / 10.0))
    inside = loud[(loud >= first) & (loud <= last)]
    from_s, to_s = first * HOP / RATE_HZ, (last * HOP + FRAME) / RATE_HZ
    hidden = float(np.interp(loud_db - room_db, CLEAR_DB, HIDDEN))
    margin_s = MARGIN_S + hidden * HIDDEN_S
    begin, end = (round(at_s * RATE_HZ) for at_s in (from_s - margin_s, to_s + margin_s))
    return Foreground(samples[max(begin, 0) : end], _speech_s(inside, hidden), loud_db - room_db)


def _levels_db(samples: Samples) -> NDArray[np.float64]:
    count = 1 + (len(samples) - FRAME) // HOP
    at = np.arange(count)[:, None] * HOP + np.arange(FRAME)
    power = np.mean(np.square(samples[at], dtype=np.float64), axis=1)
    return np.asarray(10.0 * np.log10(power + 1e-12))


def _loud_and_room(levels_db: NDArray[np.float64]) -> tuple[float, float]:
    ends = round(END_S * RATE_HZ / HOP)
    room_db = min(float(np.percentile(part, 90)) for part in (levels_db[:ends], levels_db[-ends:]))
    return float(np.percentile(levels_db, LOUD)), room_db


def _speech_s(loud: NDArray[np.intp], hidden: float) -> float:
    """Return how long somebody spoke; stops of a consonant are no pause.

    Parameters
    ----------
    loud : array of int
        Frames in which the speaker is loud.
    hidden : float
        How much of soft sounds the room hides, in [0, 1].
    """
    steps = np.diff(loud) * HOP / RATE_HZ
    consonant_s = np.interp(hidden, (0.0, 1.0), CONSONANT_S)
    spoken_s = float(np.sum(np.where(steps < consonant_s, steps, 0.0)) + FRAME / RATE_HZ)
    return spoken_s + hidden * HIDDEN_S


def _speaker(loud: NDArray[np.intp], power: NDArray[np.float64]) -> tuple[int, int]:
    """Return the first and last frame, without faint stretches beyond a pause at either end."""
    parts = np.split(loud, np.flatnonzero(np.diff(loud) > PAUSE_S * RATE_HZ / HOP) + 1)
    powers = [float(power[part].sum()) for part in parts]
    strong = [at for at, one in enumerate(powers) if one >= FAINT * sum(powers)]
    return int(parts[strong[0]][0]), int(parts[strong[-1]][-1])
