"""What was said in a loud room: all that speaks for some words is weighed, by fitted weights.

No words explain the sound of a loud room well, and a recognizer is as sure of what it reads there
as it is wrong. So each thing that may have been said stands beside the others with all that speaks
for it: how well it explains the sound, who read it and how surely, whether it means something
here, and whether a teacher would word it so. That none of them was said is one more candidate:
the less sure everything is, the likelier. The weights are fitted by `tests/benchmarks/fit_noise.py`
on what was said by other voices in other noises, so that a share is about as large as it is right.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import astuple, dataclass
from math import exp, log

from assistant.model.listening import Understanding
from assistant.shells.voice.choosing import Chooser, Said
from assistant.shells.voice.deciding import (
    ASK_SHARE,
    ASKABLE,
    DOUBT,
    Heard,
    Reading,
    as_heard,
    best_of,
    is_few,
    is_unknown,
    means,
    nothing_heard,
)
from assistant.shells.voice.phonemes import phonemes
from assistant.shells.voice.recognized import Recognized, Rereader
from assistant.shells.voice.weighing import length_penalty

SURE_SHARE, ALONE_SURE_SHARE = 0.55, 0.7
"""What is likelier is acted on; a word alone, of which noise makes another, must be likelier still:
"go" and "no" differ by one sound, which either all hear or none."""
RARE = 3.6
"""How much less likely words are that are hardly ever said here."""
LEAST_EXPLAINED, LEAST_WORDED, LEAST_READ, LEAST_REREAD = -25.0, -40.0, -8.0, -12.0
LEAST_EACH = -3.0
"""Logarithms below these tell no more."""
MOST_PACE = 6.0


@dataclass(frozen=True, slots=True)
class Weights:
    """How much each thing counts that speaks for words.

    Parameters
    ----------
    explained : float
        Of how well they explain the sound beside the words that do so best, natural logarithm.
    worded, alone : float
        Of how likely a teacher says just these, natural logarithm, and of a word alone.
    pace : float
        Of how unlikely it is that they took so long.
    meant, confidence : float
        Of what surely means something here, and of how surely it is understood.
    read, read_surely, first : float
        Of what the slow recognizer read, how likely it found it, and of its likeliest reading.
    reread, reread_surely, both : float
        Of what the quick one read, how likely it found it, and of what both did.
    expected : float
        Of what may well be said now.
    nothing, doubt, unread : float
        Of what nobody thought of: at all, by how well a phoneme of the best words explains the
        sound, and by how likely the slow recognizer found its likeliest reading.
    """

    explained: float
    worded: float
    alone: float
    pace: float
    meant: float
    confidence: float
    read: float
    read_surely: float
    first: float
    reread: float
    reread_surely: float
    both: float
    expected: float
    nothing: float
    doubt: float
    unread: float


WEIGHTS = Weights(
    explained=0.27,
    worded=0.04,
    alone=1.01,
    pace=0.36,
    meant=1.65,
    confidence=1.15,
    read=1.83,
    read_surely=0.42,
    first=1.1,
    reread=0.25,
    reread_surely=0.21,
    both=0.47,
    expected=0.95,
    nothing=0.43,
    doubt=-0.51,
    unread=-0.69,
)
OF_NOTHING = 3
"""So many of the weights, the last ones, are of what nobody thought of."""
Features = tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Evidence:
    """What speaks for words that may have been said.

    Parameters
    ----------
    text : str
    meant : Understanding
        What they mean here.
    explained, worded, pace : float
        As in `Weights`.
    read, reread : float or None
        Natural logarithm of how likely each recognizer found them; None for those it did not read.
    first, expected, rare : bool
        Whether they are the slow recognizer's likeliest reading, may well be said now, and are
        hardly ever said here.
    """

    text: str
    meant: Understanding
    explained: float = 0.0
    worded: float = 0.0
    pace: float = 0.0
    read: float | None = None
    reread: float | None = None
    first: bool = False
    expected: bool = False
    rare: bool = False

    def features(self) -> Features:
        """Return what each of the weights is multiplied with."""
        return (
            max(self.explained, LEAST_EXPLAINED),
            max(self.worded, LEAST_WORDED),
            float(" " not in self.text),
            -min(self.pace, MOST_PACE),
            float(means(self.meant)),
            self.meant.confidence,
            float(self.read is not None),
            max(self.read or 0.0, LEAST_READ),
            float(self.first),
            float(self.reread is not None),
            max(self.reread or 0.0, LEAST_REREAD),
            float(self.read is not None and self.reread is not None),
            float(self.expected),
            *(0.0,) * OF_NOTHING,
        )

    @property
    def silent(self) -> bool:
        """Whether they mean nothing anybody would ask about."""
        return is_unknown(self.meant) or (self.meant.confidence < ASKABLE and not self.expected)


@dataclass(frozen=True, slots=True)
class Evident:
    """All that may have been said.

    Parameters
    ----------
    candidates : sequence of Evidence
        At least one.
    doubt, unread : float
        As in `Weights`.
    """

    candidates: Sequence[Evidence]
    doubt: float = 0.0
    unread: float = 0.0

    def features(self) -> tuple[Features, ...]:
        """Return those of each candidate; of what nobody thought of last."""
        count = len(astuple(WEIGHTS)) - OF_NOTHING
        nothing = (*(0.0,) * count, 1.0, max(self.doubt, LEAST_EACH), max(self.unread, LEAST_READ))
        return (*(one.features() for one in self.candidates), nothing)

    def shares(self, weights: Weights = WEIGHTS) -> tuple[float, ...]:
        """Return the share of each candidate, and of what nobody thought of last."""
        each = astuple(weights)
        odds = [
            sum(one * weight for one, weight in zip(row, each, strict=True))
            for row in self.features()
        ]
        rare = (*(RARE * one.rare for one in self.candidates), 0.0)
        odds = [one - less for one, less in zip(odds, rare, strict=True)]
        parts = [exp(one - max(odds)) for one in odds]
        return tuple(part / sum(parts) for part in parts)


class InNoise:
    """Chooses in a loud room.

    Parameters
    ----------
    chooser : Chooser
        Finds what may have been said.
    quick : Rereader
        Tells what else it read, and how well words explain the sound.
    """

    def __init__(self, chooser: Chooser, quick: Rereader) -> None:
        self._chooser = chooser
        self._quick = quick

    def choose(self, said: Said) -> Heard:
        """Return what was said, as surely as all that speaks for it tells."""
        return settled(self.evident(said))

    def evident(self, said: Said) -> Evident:
        """Return all that may have been said, with what speaks for it."""
        again = logs(self._quick.reread(said.samples))
        texts = self._chooser.possible(said, tuple(again))
        likely = dict(zip(texts, self._quick.explained(said.samples, texts), strict=True))
        most = max(likely, key=lambda text: likely[text])
        slow = (one for one in said.readings if one.recognizer != self._quick.name)
        read = logs(Recognized(one.text, one.weight) for one in slow)
        first = next(iter(read), "")
        worded = self._chooser.worded(texts)
        told = tuple(
            Evidence(
                text,
                self._chooser.meaning(text, said.listening),
                explained=likely[text] - likely[most],
                worded=worded.get(text, 0.0),
                pace=length_penalty(text, said.speech_s),
                read=read.get(text),
                reread=again.get(text),
                first=text == first,
                expected=text in said.phrases,
                rare=self._chooser.rare(text, said.listening) > 0.0,
            )
            for text in texts
        )
        doubt = likely[most] / max(len(phonemes(most)), 1)
        return Evident(told, doubt, read.get(first, LEAST_READ))


def logs(read: Iterable[Recognized]) -> Mapping[str, float]:
    """Return the natural logarithms of how likely readings are, in their order."""
    return {one.text: log(max(one.sure, 1e-9)) for one in read}


def settled(told: Evident, weights: Weights = WEIGHTS) -> Heard:
    """Return what it comes to: surely, to be asked about, or nothing.

    Candidates that mean the same vote together, as in `deciding.decided`.
    """
    shares = told.shares(weights)
    votes: dict[tuple[object, ...], float] = {}
    read: list[Reading] = []
    for one, share in zip(told.candidates, shares, strict=False):
        reading = Reading(one.text, share, one.meant, "")
        read.append(reading)
        if not one.silent:
            votes[reading.kind] = votes.get(reading.kind, 0.0) + share
    acted = max(votes, key=lambda kind: votes[kind], default=None)
    read.sort(key=lambda one: -one.weight)
    if acted is None or votes[acted] < ASK_SHARE:
        return nothing_heard(read[0].text)
    chosen = best_of([one for one in read if one.kind == acted])
    expected = any(one.expected for one in told.candidates if one.text == chosen.text)
    usual = expected or not chosen.numbers or is_few(chosen)
    least = SURE_SHARE if " " in chosen.text else ALONE_SURE_SHARE
    sure = votes[acted] >= least and usual and chosen.commands
    return as_heard(chosen, 1.0 if sure else DOUBT)
