"""An utterance, how it was read, and where: what a choice among readings is made from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf, log

from rapidfuzz.distance import Levenshtein

from assistant.language.answers import OPEN
from assistant.model.listening import Listening
from assistant.shells.voice.deciding import Reading
from assistant.shells.voice.foreground import LOUD_DB
from assistant.shells.voice.phrasebank import letters
from assistant.shells.voice.sound import Samples

SENTENCE_WORDS, SENTENCE_S = 3, 0.8
BEST_READINGS = 6
LEAST_SURE = 0.02
"""A recognizer's least trust in a word of a reading."""


def is_sentence(text: str) -> bool:
    """Whether a text has more than a word or two."""
    return len(text.split()) >= SENTENCE_WORDS


@dataclass(frozen=True)
class Said:
    """An utterance, how it was read, and where it was said.

    Parameters
    ----------
    samples : array of float32, shape (n,)
    speech_s : float
        How long somebody spoke.
    readings : sequence of Reading
        At least one.
    phrases : sequence of str
        What may well be said now.
    listening : Listening
    clear_db : float
        How far the speech stands out of the room.
    """

    samples: Samples
    speech_s: float
    readings: Sequence[Reading]
    phrases: Sequence[str]
    listening: Listening
    clear_db: float = inf

    @property
    def loud(self) -> bool:
        """Whether the room is."""
        return self.clear_db < LOUD_DB

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """Everything that was read, once."""
        return tuple(dict.fromkeys(one.text for one in self.readings))

    @cached_property
    def seconded(self) -> frozenset[str]:
        """What another recognizer than the last read."""
        last = self.readings[-1].recognizer
        return frozenset(one.text for one in self.readings if one.recognizer != last)

    @cached_property
    def read(self) -> dict[str, float]:
        """How likely the last recognizer itself finds what it read, beside its best reading."""
        last = self.readings[-1].recognizer
        told = {one.text: one.weight for one in self.readings if one.recognizer == last}
        most = max(told.values())
        return {
            text: (len(text.split()) + 1) * log(max(one, LEAST_SURE) / max(most, LEAST_SURE))
            for text, one in told.items()
        }

    @property
    def doubt(self) -> float:
        """How unlikely the last recognizer finds its best reading."""
        last = self.readings[-1].recognizer
        most = max(one.weight for one in self.readings if one.recognizer == last)
        return -log(max(most, LEAST_SURE))

    @cached_property
    def _sounds(self) -> tuple[tuple[tuple[str, float], ...], tuple[tuple[str, float], ...]]:
        """How the best readings of the last recognizer sound, and those of others."""
        last = self.readings[-1].recognizer
        own = [one for one in self.readings if one.recognizer == last]
        others = [one for one in self.readings if one.recognizer != last]
        own.sort(key=lambda one: -one.weight)
        return _best(own), _best(others)

    def alike(self, text: str) -> tuple[float, float]:
        """Return how alike a text sounds to the last recognizer's readings, and to others'."""
        own, others = self._sounds
        return _alike(letters(text), own), _alike(letters(text), others)

    @property
    def free(self) -> bool:
        """Whether any words may answer what was asked."""
        return self.listening.asked in OPEN

    @property
    def commanded(self) -> bool:
        """Whether it is a command in a loud room, of more than a word or two.

        With so few words the sound decides: they hardly tell a sentence from chance.
        """
        long = self.speech_s >= SENTENCE_S and any(map(is_sentence, self.texts))
        return self.loud and not self.free and long


def _best(readings: Sequence[Reading]) -> tuple[tuple[str, float], ...]:
    return tuple((letters(one.text), one.weight) for one in readings[:BEST_READINGS])


def _alike(sounds: str, readings: Sequence[tuple[str, float]]) -> float:
    """Return how alike sounds are to readings, on the average; half where nothing was read."""
    total = sum(weight for _, weight in readings)
    if total <= 0.0:
        return 0.5
    like = Levenshtein.normalized_similarity
    return float(sum(weight * like(one, sounds) for one, weight in readings)) / total
