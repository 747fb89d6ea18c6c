"""From sound to acts: recognize, understand, weigh the readings, else compare by sound.

The quickest recognizer comes first; a slower one is asked where the first is not to be trusted
alone: short utterances, names, what does not parse, and a room that is not quiet. Where it can
tell how well given words explain the sound, all that may have been said is weighed alike.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from assistant.language.answers import OPEN
from assistant.language.completion import suggestions
from assistant.language.stopping import has_stop_word
from assistant.language.understanding import understand
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import Stop, Unknown
from assistant.shells.voice.choosing import LOUD_DB, Chooser, Said, rivals
from assistant.shells.voice.deciding import (
    ASKABLE,
    DOUBT,
    FAINT,
    SURE,
    Heard,
    Reading,
    as_heard,
    is_unknown,
    nothing_heard,
    trusted,
    voted,
)
from assistant.shells.voice.foreground import foreground
from assistant.shells.voice.phonemes import nearest
from assistant.shells.voice.recognized import (
    Recognized,
    Recognizer,
    Rereader,
    Weigher,
    is_loop,
)
from assistant.shells.voice.repairing import written
from assistant.shells.voice.sound import RATE_HZ, Samples

QUICK = 0.5
"""What the quickest recognizer's reading weighs beside those of another."""
NEAR = 0.35
MARGIN = 0.08
SHORTEST_S = 1.0
READ_AGAIN = 2
"""So many readings of the quick recognizer may second what is doubted."""

SINGLE_WORDS = (
    "yes", "no", "stop", "left", "right", "up", "down", "forward", "backward", "go", "again",
    "slower", "faster", "pause", "continue", "undo", "help", "open", "close", "good", "halt",
)  # fmt: skip
"""Said alone wherever no name or number is asked for."""

CUES = ("next", "now", "then", "next one", "second step", "third step", "last step", "finished")
"""Said alone while a hand shows the task, beside what the phrasebook suggests."""

SENTENCES = (
    "move a bit to the left", "go up two centimeters", "turn it clockwise",
    "a little faster please", "open the gripper", "close the hand", "show me the steps",
    "grasp must come before lift", "you can skip lifting", "show the demonstration again",
    "pick up the block", "pull it back slightly",
)  # fmt: skip
"""Such as teachers say; a recognizer that was told some reads others better."""

COUNTS = ("none", "one", "two", "three", "four", "five", "six")
"""Said alone where a number is asked for."""


class Hearing:
    """Understands utterances in a place of the dialogue.

    Parameters
    ----------
    recognizers : sequence of Recognizer
        The quickest first.
    language : str
    """

    def __init__(self, recognizers: Sequence[Recognizer], language: str = "english") -> None:
        self._recognizers = tuple(recognizers)
        self._language = language
        slow = self._recognizers[-1]
        self._chooser = Chooser(slow, language) if isinstance(slow, Weigher) else None

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the recognizers, for telling the teacher."""
        return tuple(recognizer.name for recognizer in self._recognizers)

    def hear(self, samples: Samples, listening: Listening) -> Heard:
        """Return what the utterance means where the dialogue stands."""
        heard = self._heard(samples, listening)
        return replace(heard, text=written(heard.text, listening.asked, self._language))

    def _heard(self, samples: Samples, listening: Listening) -> Heard:
        phrases = expected(listening, self._language)
        near_by = foreground(samples)
        loud = near_by.clear_db < LOUD_DB
        samples = _long_enough(near_by.samples)
        readings: list[Reading] = []
        for recognizer in self._recognizers:
            hot = hot_words(listening, phrases, self._language)
            found = recognizer.recognize(samples, hot, loud=loud)
            last = recognizer is self._recognizers[-1]
            weight = 1.0 if last else QUICK
            found = tuple(one for one in found if not self._is_noise(one.text))
            read = [self._read(one, weight, recognizer.name, listening) for one in found]
            if not last and not loud and read and trusted(read[0], listening):
                return as_heard(read[0], 1.0)
            readings += read
        said = Said(samples, near_by.speech_s, readings, phrases, listening, near_by.clear_db)
        return self._seconded(said, self._settled(said))

    def _is_noise(self, text: str) -> bool:
        """Whether words can only be a loop; whoever says stop over and over is in need."""
        return is_loop(text) and not has_stop_word(text, self._language)

    def _seconded(self, said: Said, heard: Heard) -> Heard:
        """Return what is doubted as sure, if another recognizer reads it too and nothing else.

        In a loud room no words explain the sound well; but noise seldom makes two models, of
        which neither knows the other, read the same meaning. Of a lone word it does: "go" and
        "no" differ by one sound, which either all hear or none.
        """
        doubted = heard.sure < 1.0 and not is_unknown(heard.understanding)
        if not (doubted and said.loud) or said.free:
            return heard
        last = said.readings[-1].recognizer
        read = {one.acts for one in said.readings if one.recognizer == last}
        again = [
            one for one in self._reread(said) if one.acts in read and not is_unknown(one.meant)
        ]
        # What is only guessed seconds nothing, but speaks against another meaning.
        sure = [one for one in again if one.commands and " " in one.text]
        if not sure or {one.acts for one in again} != {heard.understanding.acts}:
            return heard
        return as_heard(sure[0], 1.0)

    def _reread(self, said: Said) -> Iterator[Reading]:
        """Yield the likeliest readings of those recognizers that can tell more than one."""
        for other in self._recognizers[:-1]:
            found = other.reread(said.samples) if isinstance(other, Rereader) else ()
            for one in found[:READ_AGAIN]:
                yield self._read(one, 1.0, other.name, said.listening)

    def _settled(self, said: Said) -> Heard:
        """Return what all readings come to."""
        readings, phrases, listening = said.readings, said.phrases, said.listening
        if listening.moving and any(has_stop_word(one.text, self._language) for one in readings):
            # While the arm moves any reading may stop it: a stop for nothing costs little.
            return Heard("stop", Understanding((Stop(),), 1.0, "stop"))
        # Names are hinted at: there the readings themselves vote first. Numbers are few.
        free = listening.asked in OPEN and listening.asked != "subtask_count"
        named = voted(readings, phrases) if free else None
        sure = named is not None and named.understanding.confidence >= SURE
        if named is not None and sure and not rivals(named.text, listening):
            return named
        if self._chooser is not None and readings:
            return self._chooser.choose(said)
        return voted(readings, phrases) or self._by_sound(readings, phrases, listening)

    def _read(
        self, one: Recognized, weight: float, recognizer: str, listening: Listening
    ) -> Reading:
        text = written(one.text, listening.asked, self._language)
        meant = understand(text, listening, self._language)
        return Reading(one.text, weight * one.sure, meant, recognizer)

    def _by_sound(
        self, readings: Sequence[Reading], phrases: Sequence[str], listening: Listening
    ) -> Heard:
        most = max((one.weight for one in readings), default=0.0)
        for reading in sorted(readings, key=lambda one: -one.weight):
            phrase, far, margin = nearest(reading.text, phrases)
            if far <= NEAR and margin >= MARGIN and reading.weight >= max(most / 2, FAINT):
                meant = understand(phrase, listening, self._language)
                sure = replace(meant, confidence=meant.confidence * (1.0 - far))
                return Heard(phrase, sure, reading.recognizer, by_sound=True, sure=1.0 - far)
        if not readings:
            return Heard("", Understanding((Unknown(),), 1.0, ""))
        likeliest = max(readings, key=lambda one: one.weight)
        if is_unknown(likeliest.meant) or likeliest.meant.confidence < ASKABLE:
            return nothing_heard(likeliest.text)
        return as_heard(likeliest, DOUBT)


def expected(listening: Listening, language: str) -> tuple[str, ...]:
    """Return what may well be said now: the phrasebook's suggestions, then single words."""
    phrases = suggestions(listening, language)
    if language != "english":
        return phrases
    alone: tuple[str, ...] = () if listening.asked in OPEN else SINGLE_WORDS
    if listening.asked == "subtask_count":
        alone = COUNTS
    if listening.stage == "demonstration" and listening.asked is None:
        alone = CUES
    return tuple(dict.fromkeys((*phrases, *alone)))


def hot_words(
    listening: Listening, phrases: Sequence[str], language: str = "english"
) -> tuple[str, ...]:
    """Return what the recognizer should expect: the task's names first, then phrases."""
    names = (listening.task, *listening.objects, *listening.subtasks)
    first = tuple(dict.fromkeys(name for name in (*names, *phrases) if name))[:60]
    free = listening.asked in OPEN or listening.stage == "demonstration"
    return first if free or language != "english" else (*first, *SENTENCES)


def _long_enough(samples: Samples) -> Samples:
    # A word alone is heard better with some silence around it.
    missing = round(SHORTEST_S * RATE_HZ) - len(samples)
    return samples if missing <= 0 else np.pad(samples, (missing // 2, missing - missing // 2))
