"""Which of several things was said: all that speaks for each, weighed in one sum.

A recognizer that can tell the likelihood of a given phrase is asked about all candidates alike:
its own readings, those of another recognizer, what is expected now, and commands that sound
alike. What else speaks for words is added to it: that a recognizer read them, that they are
expected or mean something here, that teachers say such words. How long somebody spoke says how
much was said: "yes" is a poor account of two seconds. The weights are fitted by
`tests/benchmarks/fit_weighing.py`, so that shares are about as large as they are right.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass, fields, replace
from math import exp, log, sqrt

from assistant.shells.voice.phonemes import phonemes

EXPECTED = -3.2
"""Of each phrase expected now, natural logarithm: there are some forty, and half of what is said
is among them. It takes the place of how likely the recognizer finds the words before it listens,
which is far less for "undo" than for "thank you"."""
REPLACED = 0.6
"""So much of what the recognizer found before it listened is taken off."""
GAIN = (0.5, 5.0)
"""At least and at most, for what a recognizer finds in silence is no more than a hint."""
MEANT_WORDS = 4
"""A sentence that surely means something counts for so many words at most."""
RARE = 3.6
"""How much less likely words are that are hardly ever said here."""
LEAST_READ, LEAST_WORDED = -6.0, -40.0
PHONEME_S = 0.085
PACE_SPREAD, PHONEME_SPREAD = 0.25, 0.75
"""Usual length of a phoneme; standard deviation of its logarithm among speakers, and among
phonemes."""


@dataclass(frozen=True, slots=True)
class Evidence:
    """What speaks for words that may have been said.

    Parameters
    ----------
    text : str
    fit : float
        Natural logarithm of how well the words explain the sound.
    expected : bool
        Whether they may well be said now.
    before : float, optional
        How likely the recognizer finds them before it listens, where that is to be made up for.
    agreed : bool
        Whether another recognizer read them.
    read : float, optional
        Natural logarithm of how likely the recognizer itself read them beside its best reading.
    meant : bool
        Whether they surely mean something here.
    worded : float, optional
        How likely a teacher says just these words, natural logarithm; None for unknown.
    alike, alike_elsewhere : float
        How alike they sound to what the recognizer read, and to what another did; in [0, 1].
    rare : bool
        Whether they are hardly ever said here.
    """

    text: str
    fit: float = 0.0
    expected: bool = False
    before: float | None = None
    agreed: bool = False
    read: float | None = None
    meant: bool = False
    worded: float | None = None
    alike: float = 0.0
    alike_elsewhere: float = 0.0
    rare: bool = False

    @property
    def fitting(self) -> float:
        """How well they explain the sound, where they are said."""
        return self.fit + (0.0 if self.before is None else gain(self.before))

    def features(self, speech_s: float) -> tuple[float, ...]:
        """Return what each weight of `Weights` is multiplied with."""
        words = len(self.text.split())
        plain = self.expected or self.worded is None
        return (
            self.fit,
            float(self.expected),
            0.0 if self.before is None else gain(self.before),
            float(self.agreed),
            float(self.read is not None),
            max(self.read or 0.0, LEAST_READ),
            min(words, MEANT_WORDS) * float(self.meant),
            0.0 if plain else max(self.worded or 0.0, LEAST_WORDED),
            0.0 if plain else float(words),
            -length_penalty(self.text, speech_s),
            self.alike,
            self.alike_elsewhere,
            0.0,
            0.0,
        )


def nothing_of_these(doubt: float) -> tuple[float, ...]:
    """Return what speaks for words nobody thought of, as `Evidence.features`.

    Parameters
    ----------
    doubt : float
        How unlikely the recognizer finds its best reading, natural logarithm for each word.
    """
    return (*(0.0,) * (len(fields(Weights)) - 2), 1.0, doubt)


@dataclass(frozen=True, slots=True)
class Weights:
    """How much each thing counts that speaks for words.

    Parameters
    ----------
    sound : float
        Below 1: a recognizer is surer of itself than it is right.
    expected, before : float
        Of what is expected now, and of how unlikely the recognizer finds it elsewhere.
    agreed, read, better : float
        Of what another recognizer read, of what it read itself, and how likely.
    meant : float
        Of each word of a sentence that surely means something here: the teacher talks to the
        robot, and chance hardly makes a whole sentence of it.
    worded, each_word : float
        Of how likely a teacher says these words, and of each to make up for it.
    length, alike, alike_elsewhere : float
    nothing, doubt : float
        Of what nobody thought of, which is likelier where the recognizer doubts what it read.
    """

    sound: float
    expected: float
    before: float
    agreed: float
    read: float
    better: float
    meant: float
    worded: float
    each_word: float
    length: float
    alike: float
    alike_elsewhere: float
    nothing: float
    doubt: float


COMMANDS = Weights(0.18, -0.64, 0.0, 0.41, 1.8, 0.45, 0.46, 0.21, 0.39, 0.5, 4.1, 3.5, 0.1, 1.1)
"""In a loud room, fitted: what speaks for words beside the sound counts as much as the sound."""
QUIET = Weights(0.8, 0.0, 0.8, 1.2, 0.0, 0.0, 0.48, 0.32, 0.8, 0.8, 0.0, 0.0, -90.0, 0.0)
"""In a quiet room the sound decides."""
NAMES = replace(QUIET, meant=0.0)
"""Where any words may answer."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """Words that may have been said.

    Parameters
    ----------
    text : str
    fit : float
        Natural logarithm of how well the words explain the sound, where they are said.
    share : float
        Of all candidates' weight, in [0, 1].
    expected : bool
        Whether it may well be said now.
    """

    text: str
    fit: float
    share: float
    expected: bool = False


def weighed(
    told: Mapping[str, Evidence],
    speech_s: float,
    weights: Weights = COMMANDS,
    doubt: float = 0.0,
) -> tuple[Candidate, ...]:
    """Return candidates with their shares, the likeliest first.

    What is missing from one is the share of what nobody thought of.

    Parameters
    ----------
    told : mapping of text to Evidence
    speech_s : float
        How long somebody spoke.
    weights : Weights
    doubt : float
        How unlikely the recognizer finds its best reading, natural logarithm for each word.
    """
    odds = {
        text: log_odds(one.features(speech_s), weights) - RARE * one.rare
        for text, one in told.items()
    }
    nothing = log_odds(nothing_of_these(doubt), weights)
    most = max((nothing, *odds.values()))
    parts = {text: exp(one - most) for text, one in odds.items()}
    total = sum(parts.values()) + exp(nothing - most)
    ranked = sorted(parts, key=lambda text: -parts[text])
    return tuple(
        Candidate(text, told[text].fitting, parts[text] / total, told[text].expected)
        for text in ranked
    )


def log_odds(features: Sequence[float], weights: Weights) -> float:
    """Return the natural logarithm of the odds of words with such features, but for a constant."""
    return float(sum(one * weight for one, weight in zip(features, astuple(weights), strict=True)))


def gain(before: float) -> float:
    """Return how much likelier words are where they are expected.

    Parameters
    ----------
    before : float
        How likely the recognizer finds them before it listens; natural logarithm.
    """
    least, most = GAIN
    return min(max(EXPECTED - REPLACED * before, least), most)


def length_penalty(text: str, speech_s: float) -> float:
    """Return how unlikely it is that these words took so long, as a natural logarithm."""
    count = max(len(phonemes(text)), 1)
    spread = sqrt(PACE_SPREAD**2 + PHONEME_SPREAD**2 / count)
    off = log(max(speech_s, PHONEME_S) / (count * PHONEME_S)) / spread
    return 0.5 * off * off
