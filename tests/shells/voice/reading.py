"""Recognizers that read what they are told, and what is heard by them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assistant.model.listening import Listening
from assistant.model.teacher_acts import (
    TeacherAct,
)
from assistant.shells.voice.deciding import SURE, Heard, is_unknown
from assistant.shells.voice.hearing import Hearing
from assistant.shells.voice.recognized import Recognized
from assistant.shells.voice.sound import Samples

PRACTICE = Listening(stage="practice")
IN_SILENCE = np.concatenate(
    [np.full(length, loud, np.float32) for length, loud in ((4000, 0.0), (6000, 0.3), (4000, 0.0))]
)
A_SECOND = np.concatenate(
    [np.full(length, loud, np.float32) for length, loud in ((4000, 0.0), (18000, 0.3), (4000, 0.0))]
)
NAMING = Listening(stage="introduction", asked="subtask_name")


class Reads:
    """A recognizer with given readings."""

    def __init__(self, *readings: tuple[str, float]) -> None:
        self.name = f"reads {readings}"
        self.readings = tuple(Recognized(text, sure) for text, sure in readings)
        self.asked = 0

    def recognize(
        self, samples: Samples, hot_words: Sequence[str] = (), *, loud: bool = False
    ) -> tuple[Recognized, ...]:
        self.asked += 1
        return self.readings


class Rereads(Reads):
    """A recognizer that tells what else it may have read."""

    def reread(self, samples: Samples) -> tuple[Recognized, ...]:
        return self.readings


def heard(
    quick: Reads, slow: Reads, listening: Listening = PRACTICE, sound: Samples = IN_SILENCE
) -> Heard:
    return Hearing((quick, slow)).hear(sound, listening)


def acted_on(one: Heard) -> tuple[TeacherAct, ...]:
    sure = one.understanding.confidence >= SURE and not is_unknown(one.understanding)
    return one.understanding.acts if sure else ()


class Weighs(Reads):
    """A recognizer that also tells how well words explain a sound."""

    def __init__(self, likely: dict[str, float], *readings: tuple[str, float]) -> None:
        super().__init__(*readings)
        self.likely = likely

    def likelihoods(
        self, samples: Samples, phrases: Sequence[str], *, loud: bool = False
    ) -> tuple[float, ...]:
        return tuple(self.likely.get(phrase, -30.0) for phrase in phrases)
