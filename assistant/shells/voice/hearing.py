"""From sound to acts: recognize, understand, weigh the readings, else compare by sound.

The quickest recognizer comes first; a slower one is asked where the first is not to be trusted
alone: short utterances, names, and what does not parse. Each reading votes for what it means
here, so that a likely reading which means nothing counts against a command. Unrelated speech
must never act, and a wrong act is worse than a question: where readings disagree, the
confidence falls below what the dialogue acts on, and it asks.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from assistant.language.answers import OPEN
from assistant.language.completion import suggestions
from assistant.language.understanding import understand
from assistant.model import teacher_acts as acts
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import TeacherAct, Unknown
from assistant.shells.voice.foreground import foreground
from assistant.shells.voice.phonemes import nearest
from assistant.shells.voice.phrasebank import near
from assistant.shells.voice.recognizers import Recognized, Recognizer, Weigher
from assistant.shells.voice.sound import RATE_HZ, Samples
from assistant.shells.voice.weighing import Candidate, length_penalty, weighed

SURE = 0.85
ALONE_WORDS = 3
"""A reading of so many words that parses is believed without a second opinion."""
CLEAR_DB = 22.0
"""In a louder room a second opinion is always asked for."""
SHORT_WORDS = 3
SHORT_SURE = 0.92
"""Few words that only resemble a command are chat: "removed" is not "remove it"."""
QUICK = 0.5
"""What the quickest recognizer's reading weighs beside those of another."""
LIKELY_WORDS = 2.0
"""How much more a reading weighs that is among the phrases expected now."""
CLEARLY = 1.3
"""How many times the votes of any other command the one acted on must have."""
UNKNOWN = 0.5
"""What readings that mean nothing weigh: the teacher talks to the robot, mostly."""
FAINT = 0.35
"""Readings no likelier than this are asked about."""
NEAR = 0.35
MARGIN = 0.08
DOUBT = 0.6
ASKABLE = 0.75
"""Less sure than this it is chat, and the robot does not ask what was meant."""
SHORTEST_S = 1.0
SILENCE = np.zeros(RATE_HZ, dtype=np.float32)
ALIKE = 8
ALIKE_TO = 3
"""So many commands that sound alike are weighed, for so many readings."""
TOO_LONG = 6.0
"""Phrases that cannot have taken so long, or so little, are not weighed."""
LIKELIEST = 12
"""So many candidates are understood."""
SURE_SHARE = 0.7
ASK_SHARE = 0.35
WORST = 4.0
WORST_WORD = 1.5
"""Less likely than this, and less by each word, it is asked about at most."""
HOPELESS = 5.0
"""Less likely still by so much, nobody said it."""

SINGLE_WORDS = (
    "yes", "no", "stop", "left", "right", "up", "down", "forward", "backward", "go", "again",
    "slower", "faster", "pause", "continue", "undo", "help", "open", "close", "good", "halt",
)  # fmt: skip
"""Said alone wherever no name or number is asked for."""

COUNTS = ("none", "one", "two", "three", "four", "five", "six")
"""Said alone where a number is asked for."""

_PLAIN = (
    acts.AdjustLast,
    acts.AdjustSpeed,
    acts.Again,
    acts.Affirm,
    acts.Approve,
    acts.Cue,
    acts.Deny,
    acts.GoBack,
    acts.Gripper,
    acts.Help,
    acts.NewSetup,
    acts.Pause,
    acts.Quit,
    acts.Redo,
    acts.RepeatLine,
    acts.Resume,
    acts.Rotate,
    acts.Show,
    acts.Start,
    acts.Stop,
    acts.Translate,
    acts.Undo,
)
"""Acts without free words in them."""


@dataclass(frozen=True, slots=True)
class Heard:
    """What an utterance came to.

    Parameters
    ----------
    text : str
        The words as recognized; where matched by sound, those they were matched with.
    understanding : Understanding
        Its confidence counts how surely the words were recognized.
    recognizer : str
        Whose words they are.
    by_sound : bool
        Whether they were matched by sound rather than as written.
    """

    text: str
    understanding: Understanding
    recognizer: str = ""
    by_sound: bool = False


@dataclass(frozen=True, slots=True)
class _Reading:
    text: str
    weight: float
    meant: Understanding
    recognizer: str

    @property
    def acts(self) -> tuple[TeacherAct, ...]:
        return self.meant.acts

    @property
    def kind(self) -> tuple[object, ...]:
        return ("answers",) if self._answers else self.acts

    @property
    def commands(self) -> bool:
        short = len(self.text.split()) <= SHORT_WORDS
        least = SHORT_SURE if short and not self._answers else SURE
        return self.meant.confidence >= least and not is_unknown(self.meant)

    @property
    def _answers(self) -> bool:
        return all(isinstance(act, acts.Inform) for act in self.acts)


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
        self._unheard: dict[str, float] = {}

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the recognizers, for telling the teacher."""
        return tuple(recognizer.name for recognizer in self._recognizers)

    def hear(self, samples: Samples, listening: Listening) -> Heard:
        """Return what the utterance means where the dialogue stands."""
        phrases = expected(listening, self._language)
        near_by = foreground(samples)
        samples = _long_enough(near_by.samples)
        readings: list[_Reading] = []
        for recognizer in self._recognizers:
            # Commands expected now are weighed where that can be done; names are hinted at.
            told = isinstance(recognizer, Weigher) and listening.asked not in OPEN
            found = recognizer.recognize(samples, hot_words(listening, () if told else phrases))
            others = recognizer is not self._recognizers[-1]
            weight = QUICK if others else 1.0
            read = [self._read(one, weight, recognizer.name, listening) for one in found]
            clear = near_by.clear_db >= CLEAR_DB
            if others and clear and read and _trusted(read[0], listening):
                return _as_heard(read[0], 1.0)
            readings += read
        slow = self._recognizers[-1]
        if isinstance(slow, Weigher) and readings:
            return self._weighed(slow, samples, near_by.speech_s, readings, phrases, listening)
        return _voted(readings, phrases) or self._by_sound(readings, phrases, listening)

    def _weighed(
        self,
        slow: Weigher,
        samples: Samples,
        speech_s: float,
        readings: Sequence[_Reading],
        phrases: Sequence[str],
        listening: Listening,
    ) -> Heard:
        """Weigh all that may have been said by how well it explains the sound."""
        known = {one.text: one for one in readings}
        other = [one.text for one in readings if one.recognizer != readings[-1].recognizer]
        texts = (*known, *phrases, *self._alike([*known][:ALIKE_TO]))
        texts = tuple(
            text
            for text in dict.fromkeys(texts)
            if text in known or length_penalty(text, speech_s) < TOO_LONG
        )
        told = dict(zip(texts, slow.likelihoods(samples, texts), strict=True))
        before = self._before(slow, [phrase for phrase in phrases if phrase in told])
        found = weighed(told, speech_s, expected=before, agreed=other)
        return decided(found, lambda text: understand(text, listening, self._language))

    def _before(self, slow: Weigher, phrases: Sequence[str]) -> dict[str, float]:
        """Return how likely the recognizer finds phrases before it listens, asked once."""
        new = tuple(phrase for phrase in phrases if phrase not in self._unheard)
        if new:
            told = slow.likelihoods(SILENCE, new)
            self._unheard.update(zip(new, told, strict=True))
        return {phrase: self._unheard[phrase] for phrase in phrases}

    def _alike(self, heard: Sequence[str]) -> tuple[str, ...]:
        if self._language != "english":
            return ()
        return tuple(one for text in heard for one in near(text, ALIKE))

    def _read(
        self, one: Recognized, weight: float, recognizer: str, listening: Listening
    ) -> _Reading:
        meant = understand(one.text, listening, self._language)
        return _Reading(one.text, weight * one.sure, meant, recognizer)

    def _by_sound(
        self, readings: Sequence[_Reading], phrases: Sequence[str], listening: Listening
    ) -> Heard:
        most = max((one.weight for one in readings), default=0.0)
        for reading in sorted(readings, key=lambda one: -one.weight):
            phrase, far, margin = nearest(reading.text, phrases)
            if far <= NEAR and margin >= MARGIN and reading.weight >= max(most / 2, FAINT):
                meant = understand(phrase, listening, self._language)
                sure = replace(meant, confidence=meant.confidence * (1.0 - far))
                return Heard(phrase, sure, reading.recognizer, by_sound=True)
        if not readings:
            return Heard("", Understanding((Unknown(),), 1.0, ""))
        likeliest = max(readings, key=lambda one: one.weight)
        if is_unknown(likeliest.meant) or likeliest.meant.confidence < ASKABLE:
            nothing = Understanding((Unknown(),), SURE, likeliest.text)
            return Heard(likeliest.text, nothing, likeliest.recognizer)
        return _as_heard(likeliest, DOUBT)


def decided(found: Sequence[Candidate], meaning: Callable[[str], Understanding]) -> Heard:
    """Return what weighed candidates come to: surely, to be asked about, or nothing.

    Candidates that mean the same vote together. Free words are one meaning however they are
    spelled: the likeliest spelling is taken.
    """
    read = [_Reading(one.text, one.share, meaning(one.text), "") for one in found[:LIKELIEST]]
    votes: dict[tuple[object, ...], float] = {}
    for one in read:
        if not is_unknown(one.meant) and one.meant.confidence >= ASKABLE:
            votes[one.kind] = votes.get(one.kind, 0.0) + one.weight
    acted = max(votes, key=lambda one: votes[one], default=None)
    if acted is None or votes[acted] < ASK_SHARE:
        return _nothing(read[0].text)
    chosen = next(one for one in read if one.kind == acted)
    likelihood = next(one.likelihood for one in found if one.text == chosen.text)
    worst = -(WORST + WORST_WORD * len(chosen.text.split()))
    if likelihood < worst - HOPELESS:
        return _nothing(chosen.text)
    well = likelihood >= worst and votes[acted] >= SURE_SHARE
    sure = well and (chosen.commands or chosen.meant.confidence < SURE)
    return _as_heard(chosen, 1.0 if sure else DOUBT)


def _nothing(text: str) -> Heard:
    return Heard(text, Understanding((Unknown(),), SURE, text))


def expected(listening: Listening, language: str) -> tuple[str, ...]:
    """Return what may well be said now: the phrasebook's suggestions, then single words."""
    phrases = suggestions(listening, language)
    if language != "english":
        return phrases
    alone: tuple[str, ...] = () if listening.asked in OPEN else SINGLE_WORDS
    if listening.asked == "subtask_count":
        alone = COUNTS
    return tuple(dict.fromkeys((*phrases, *alone)))


def hot_words(listening: Listening, phrases: Sequence[str]) -> tuple[str, ...]:
    """Return what the recognizer should expect: the task's names first, then phrases."""
    names = (listening.task, *listening.objects, *listening.subtasks)
    return tuple(dict.fromkeys(name for name in (*names, *phrases) if name))[:60]


def is_unknown(meant: Understanding) -> bool:
    """Whether nothing was understood."""
    return any(isinstance(act, Unknown) for act in meant.acts)


def _trusted(reading: _Reading, listening: Listening) -> bool:
    enough = len(reading.text.split()) >= ALONE_WORDS
    free = any(not isinstance(act, _PLAIN) or getattr(act, "where", None) for act in reading.acts)
    return reading.commands and enough and not free and listening.asked not in OPEN


def _voted(readings: Sequence[_Reading], phrases: Sequence[str]) -> Heard | None:
    """Return the meaning with most votes if it has enough of them."""
    votes: dict[tuple[TeacherAct, ...], float] = {}
    nothing = 0.0
    for reading in readings:
        if not reading.commands:
            nothing += UNKNOWN * reading.weight
            continue
        weight = reading.weight * (LIKELY_WORDS if reading.text in phrases else 1.0)
        votes[reading.acts] = votes.get(reading.acts, 0.0) + weight
    ranked = sorted(votes, key=lambda one: -votes[one])
    if not ranked or votes[ranked[0]] < nothing / 2:
        return None
    backers = [one for one in readings if one.commands and one.acts == ranked[0]]
    chosen = max(backers, key=lambda one: one.weight)
    rival = votes[ranked[1]] if len(ranked) > 1 else 0.0
    clear = votes[ranked[0]] >= max(nothing, CLEARLY * rival)
    agreed = len({one.recognizer for one in backers}) > 1
    heard_well = chosen.recognizer == readings[-1].recognizer and chosen.weight >= FAINT
    sure = clear and (agreed or heard_well)
    return _as_heard(chosen, 1.0 if sure else DOUBT)


def _as_heard(reading: _Reading, most: float) -> Heard:
    sure = min(reading.meant.confidence, most)
    return Heard(reading.text, replace(reading.meant, confidence=sure), reading.recognizer)


def _long_enough(samples: Samples) -> Samples:
    # A word alone is heard better with some silence around it.
    missing = round(SHORTEST_S * RATE_HZ) - len(samples)
    return samples if missing <= 0 else np.pad(samples, (missing // 2, missing - missing // 2))
