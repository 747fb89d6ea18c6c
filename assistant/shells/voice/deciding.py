"""What several readings of an utterance come to: surely, to be asked about, or nothing.

Each reading stands for what it means here, so that a likely reading which means nothing counts
against a command. Unrelated speech must never act, and a wrong act is worse than a question:
where readings disagree, the confidence falls below what the dialogue acts on, and it asks.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import inf

from assistant.language.answers import OPEN
from assistant.model import teacher_acts as acts
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import TeacherAct, Unknown
from assistant.shells.voice.weighing import Candidate

SURE = 0.85
ALONE_WORDS = 3
"""A reading of so many words that parses is believed without a second opinion."""
SHORT_WORDS = 3
SHORT_SURE = 0.92
"""Few words that only resemble a command are chat: "removed" is not "remove it"."""
LIKELY_WORDS = 2.0
"""How much more a reading weighs that is among the phrases expected now."""
CLEARLY = 1.3
"""How many times the votes of any other command the one acted on must have."""
UNKNOWN = 0.5
"""What readings that mean nothing weigh: the teacher talks to the robot, mostly."""
FAINT = 0.35
"""Readings no likelier than this are asked about."""
DOUBT = 0.6
ASKABLE = 0.75
"""Less sure than this it is chat, and the robot does not ask what was meant."""
LIKELIEST = 12
"""So many candidates are understood."""
SURE_SHARE = 0.6
ASK_SHARE = 0.35
HALFWAY = 0.5
RIVAL_SHARE = 0.25
"""A name so likely spelled otherwise is asked about, for it is part of the plan, and whatever may
so likely have meant something else."""
MOST_STEPS = 9
"""A number of steps that nobody would expect is asked about."""
WORST = ((10.0, 3.0), (17.0, 4.0))
"""How far speech stands out of the room in dB, and how unlikely it may be: in a loud room what
was not said is taken for speech more easily."""
WORST_WORD = (1.0, 1.5)
ALONE_SHARE = 0.95
"""Less likely than this, and less by each word, it is asked about at most; where hardly anything
else may have been said, it may be a little less likely."""
HOPELESS = 5.0
"""Less likely still by so much, nobody said it."""

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


_SLURRED = frozenset(("it", "at", "a", "an", "but", "bet", "about", "that", "this", "of", "with"))
"""What is left of "a bit" where it is said quickly: "move it to the left"."""
_AMOUNTS = ("degree", "distance_m", "angle_deg", "factor")
_TELLING = (acts.Explain, acts.KeyState)
"""Acts whose words are kept as they were said: however they are spelled they are one meaning."""


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
    sure : float
        How surely the words were recognized, whatever they mean; in [0, 1].
    """

    text: str
    understanding: Understanding
    recognizer: str = ""
    by_sound: bool = False
    sure: float = 1.0


@dataclass(frozen=True, slots=True)
class Reading:
    """Words that may have been said, what they weigh, and what they mean here."""

    text: str
    weight: float
    meant: Understanding
    recognizer: str

    @property
    def acts(self) -> tuple[TeacherAct, ...]:
        """What it means."""
        return self.meant.acts

    @property
    def kind(self) -> tuple[object, ...]:
        """What readings with the same meaning share; free words are one meaning."""
        if self._answers and not self.numbers:
            return ("answers",)
        return tuple(type(act) if isinstance(act, _TELLING) else act for act in self.acts)

    @property
    def numbers(self) -> bool:
        """Whether it answers with a number."""
        return any(isinstance(getattr(act, "value", ""), int) for act in self.acts)

    @property
    def commands(self) -> bool:
        """Whether it surely means something."""
        return means(self.meant)

    @property
    def _answers(self) -> bool:
        return answers(self.meant)


def decided(
    found: Sequence[Candidate], meaning: Callable[[str], Understanding], clear_db: float = inf
) -> Heard:
    """Return what weighed candidates come to: surely, to be asked about, or nothing.

    Candidates that mean the same vote together. Free words are one meaning however they are
    spelled: the likeliest spelling is taken.

    Parameters
    ----------
    found : sequence of Candidate
        The likeliest first.
    meaning : callable
        What words mean here.
    clear_db : float
        How far the speech stands out of the room: in a loud one more is asked about.
    """
    read = [Reading(one.text, one.share, meaning(one.text), "") for one in found[:LIKELIEST]]
    votes: dict[tuple[object, ...], float] = {}
    for one, known in zip(read, found, strict=False):
        askable = known.expected or one.meant.confidence >= ASKABLE
        if askable and not is_unknown(one.meant):
            votes[one.kind] = votes.get(one.kind, 0.0) + one.weight
    acted = max(votes, key=lambda one: votes[one], default=None)
    if acted is None or votes[acted] < ASK_SHARE:
        return nothing_heard(read[0].text)
    chosen = _best_of([one for one in read if one.kind == acted])
    candidate = next(one for one in found if one.text == chosen.text)
    fit = candidate.fit
    alone = votes[acted] >= ALONE_SHARE
    worst = -(_worst(clear_db) + WORST_WORD[alone] * len(chosen.text.split()))
    if fit < worst - HOPELESS:
        return nothing_heard(chosen.text)
    rival = max((share for kind, share in votes.items() if kind != acted), default=0.0)
    well = fit >= worst and votes[acted] >= SURE_SHARE and rival < RIVAL_SHARE
    usual = candidate.expected or not chosen.numbers or _few(chosen)
    other = (
        one.weight
        for one in read
        if one.kind == acted and one.kind == ("answers",) and one.acts != chosen.acts
    )
    sure = (
        well
        and usual
        and max(other, default=0.0) < RIVAL_SHARE
        and (chosen.commands or chosen.meant.confidence < SURE)
    )
    return as_heard(chosen, 1.0 if sure else DOUBT)


def _worst(clear_db: float) -> float:
    (low_db, least), (high_db, most) = WORST
    share = min(max((clear_db - low_db) / (high_db - low_db), 0.0), 1.0)
    return least + share * (most - least)


def _best_of(alike: Sequence[Reading]) -> Reading:
    """Return the likeliest of readings that mean the same; one that surely does goes before."""
    likeliest = alike[0]
    surer = (
        one
        for one in alike
        if one.commands and one.acts == likeliest.acts and one.weight >= HALFWAY * likeliest.weight
    )
    return next(surer, likeliest)


def _few(reading: Reading) -> bool:
    """Whether it answers with a small number; one nobody would expect is asked about."""
    return all(getattr(act, "value", MOST_STEPS) < MOST_STEPS for act in reading.acts)


def nothing_heard(text: str) -> Heard:
    """Return words that mean nothing."""
    return Heard(text, Understanding((Unknown(),), SURE, text))


def answers(meant: Understanding) -> bool:
    """Whether it answers what was asked, and does no more."""
    return all(isinstance(act, acts.Inform) for act in meant.acts)


def means(meant: Understanding) -> bool:
    """Whether words surely mean something here."""
    short = len(meant.heard.split()) <= SHORT_WORDS
    least = SHORT_SURE if short and not answers(meant) else SURE
    return meant.confidence >= least and not is_unknown(meant)


def is_sure(heard: Heard) -> bool:
    """Whether it may be acted on."""
    return heard.understanding.confidence >= SURE and not is_unknown(heard.understanding)


def is_unknown(meant: Understanding) -> bool:
    """Whether nothing was understood."""
    return any(isinstance(act, Unknown) for act in meant.acts)


def trusted(reading: Reading, listening: Listening) -> bool:
    """Whether a quick reading needs no second opinion."""
    enough = len(reading.text.split()) >= ALONE_WORDS
    free = any(not isinstance(act, _PLAIN) or getattr(act, "where", None) for act in reading.acts)
    plain = reading.commands and enough and not free and listening.asked not in OPEN
    return plain and not _may_have_lost_a_bit(reading)


def _may_have_lost_a_bit(reading: Reading) -> bool:
    """Whether "a bit" may have been said, which makes another amount of it."""
    amounts = (act for act in reading.acts if hasattr(act, "degree"))
    plain = any(not any(getattr(act, name, None) for name in _AMOUNTS) for act in amounts)
    return plain and not _SLURRED.isdisjoint(reading.text.split())


def voted(readings: Sequence[Reading], phrases: Sequence[str]) -> Heard | None:
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
    return as_heard(chosen, 1.0 if sure else DOUBT)


def as_heard(reading: Reading, most: float) -> Heard:
    """Return a reading as heard, no surer than `most`."""
    sure = min(reading.meant.confidence, most)
    meant = replace(reading.meant, confidence=sure)
    return Heard(reading.text, meant, reading.recognizer, sure=most)
