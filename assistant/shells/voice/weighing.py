"""Which of several things was said: each weighed by how well it explains the sound.

A recognizer that can tell the likelihood of a given phrase is asked about all candidates alike:
its own readings, those of another recognizer, what is expected now, and commands that sound
alike. Candidates that mean the same act stand together; those that mean nothing stand for
chat. How long somebody spoke says how much was said: "yes" is a poor account of two seconds.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
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
AGREED = 1.5
"""How much likelier what another recognizer read is."""
MEANT, MEANT_WORDS = 0.6, 4
"""How much likelier each word makes a sentence that surely means something here, up to so many
words: the teacher talks to the robot, and chance hardly makes a whole sentence of it."""
WORDED, EACH_WORD, UNWORDED = 0.4, 1.0, -3.0
"""So much of how likely a teacher says these words counts, and each word makes up for so much: a
usual one costs nothing. No more than the last is taken off: others speak too."""
SHARPNESS = 0.8
"""Below 1: a recognizer is surer of itself than it is right."""
PHONEME_S = 0.085
PACE_SPREAD, PHONEME_SPREAD = 0.25, 0.75
"""Usual length of a phoneme; standard deviation of its logarithm among speakers, and among
phonemes."""


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
    likelihoods: Mapping[str, float],
    speech_s: float,
    *,
    expected: Mapping[str, float] | None = None,
    agreed: Collection[str] = (),
    meant: Collection[str] = (),
    worded: Mapping[str, float] | None = None,
) -> tuple[Candidate, ...]:
    """Return candidates with their shares, the likeliest first.

    Parameters
    ----------
    likelihoods : mapping of text to natural logarithm
    speech_s : float
        How long somebody spoke.
    expected : mapping of text to natural logarithm, optional
        What may well be said now, and how likely the recognizer finds it before it listens.
    agreed : collection of str
        What another recognizer read.
    meant : collection of str
        What surely means something here.
    worded : mapping of text to natural logarithm, optional
        How likely a teacher says just these words.
    """
    gains = {text: gain(before) for text, before in (expected or {}).items()}
    fits = {text: told + gains.get(text, 0.0) for text, told in likelihoods.items()}
    weights = {
        text: fit
        + AGREED * (text in agreed)
        + MEANT * min(len(text.split()), MEANT_WORDS) * (text in meant and text not in gains)
        + worded_gain(text, (worded or {}).get(text))
        - length_penalty(text, speech_s)
        for text, fit in fits.items()
    }
    most = max(weights.values(), default=0.0)
    odds = {text: exp(SHARPNESS * (weight - most)) for text, weight in weights.items()}
    total = sum(odds.values())
    ranked = sorted(odds, key=lambda text: -odds[text])
    return tuple(Candidate(text, fits[text], odds[text] / total, text in gains) for text in ranked)


def worded_gain(text: str, likely: float | None) -> float:
    """Return how much likelier it is that a teacher says this than that anybody does.

    Parameters
    ----------
    text : str
    likely : float or None
        That a teacher says just these words, natural logarithm; None for unknown.
    """
    if likely is None:
        return 0.0
    return max(WORDED * likely + EACH_WORD * len(text.split()), UNWORDED)


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
