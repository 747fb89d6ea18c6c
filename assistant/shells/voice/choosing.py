"""Which of all that may have been said it was: readings, what is expected, and what sounds alike.

A recognizer that tells how well given words explain a sound weighs all of them alike. Whole
sentences that were read are weighed among themselves first: mostly that settles it, in a tenth
of the time.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from math import inf

import numpy as np

from assistant.language.answers import OPEN
from assistant.language.understanding import understand
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import Deny
from assistant.shells.voice.deciding import Heard, Reading, decided, is_sure, means
from assistant.shells.voice.phrasebank import mended, named, near, related, sounding
from assistant.shells.voice.recognized import Weigher
from assistant.shells.voice.repairing import repaired, written
from assistant.shells.voice.sound import RATE_HZ, Samples
from assistant.shells.voice.weighing import length_penalty, weighed
from assistant.shells.voice.wording import wording

LOUD_DB = 22.0
"""Where speech stands out of the room less, a second opinion is always asked for, and recognizers
take all care."""
SILENCE = np.zeros(RATE_HZ, dtype=np.float32)
ALIKE = 8
ALIKE_TO = 3
"""So many commands that sound alike are weighed, for so many readings."""
LIKE_HEARD = 0.3
"""Words less alike to all that was read were not said: no time is spent on weighing them."""
REPAIRS, REPAIRS_TRIED = 8, 16
"""So many sentences are weighed that a reading nearly is, of so many likeliest ones: what they
mean takes long to tell."""
SENTENCE_WORDS = 3
TOO_LONG = 6.0
"""Phrases that cannot have taken so long, or so little, are not weighed."""
MENDED = -10.0
"""Stands for how likely a mended name is found before listening: teachers speak of their work."""
TEACHING = (
    "place", "pick", "grasp", "move", "lift", "lower", "put", "push", "pour", "insert", "wipe",
    "turn", "open", "close", "release", "approach", "block", "target", "object", "hand", "cup",
    "up", "down", "step", "task",
)  # fmt: skip
"""Words that names of tasks, things and steps are made of."""
THINGS = ("object", "target", "block", "cup", "box", "table", "lid", "hand")
RARE = 4.5
"""Taken off readings that sound like a likelier word: nobody says "please" in a name, where
"place" is common; while a hand shows the task "now" is a cue, and "no" answers nothing."""


@dataclass(frozen=True, slots=True)
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

    @property
    def texts(self) -> tuple[str, ...]:
        """Everything that was read, once."""
        return tuple(dict.fromkeys(one.text for one in self.readings))

    @property
    def seconded(self) -> frozenset[str]:
        """What another recognizer than the last read."""
        last = self.readings[-1].recognizer
        return frozenset(one.text for one in self.readings if one.recognizer != last)

    @property
    def free(self) -> bool:
        """Whether any words may answer what was asked."""
        return self.listening.asked in OPEN


class Chooser:
    """Chooses by weighing.

    Parameters
    ----------
    slow : Weigher
    language : str
    """

    def __init__(self, slow: Weigher, language: str = "english") -> None:
        self._slow = slow
        self._language = language
        self._wording = wording(language)
        self._unheard: dict[str, float] = {}

    def choose(self, said: Said) -> Heard:
        """Return what was said, as surely as the sound tells it."""
        if not said.free and any(map(_is_sentence, said.texts)):
            heard = self._weighed(said, said.texts, (), ())
            if is_sure(heard) and _is_sentence(heard.text):
                return heard
        known = said.texts[:ALIKE_TO]
        made = tuple(text for one in known for text in self._made(one, said.listening))
        texts: Sequence[str] = (*said.texts, *said.phrases, *made, *self._alike(known))
        if self._language == "english" and not said.free:
            texts = sounding(texts, said.texts, LIKE_HEARD)
        return self._weighed(said, texts, said.phrases, made if said.free else ())

    def _weighed(
        self, said: Said, texts: Iterable[str], phrases: Sequence[str], mends: Sequence[str]
    ) -> Heard:
        """Weigh texts; `phrases` are likelier than they sound, and so are `mends`."""
        fitting = tuple(
            text
            for text in dict.fromkeys(texts)
            if text in said.texts or length_penalty(text, said.speech_s) < TOO_LONG
        )
        likely = self._slow.likelihoods(said.samples, fitting, loud=said.loud)
        found = zip(fitting, likely, strict=True)
        told = {text: one - self._rare(text, said.listening) for text, one in found}
        before = self._before([phrase for phrase in phrases if phrase in told])
        before |= {text: MENDED for text in mends if text in told}
        meant = {text: self._meaning(text, said.listening) for text in told}
        surely = frozenset() if said.free else {text for text in meant if means(meant[text])}
        shares = weighed(
            told,
            said.speech_s,
            expected=before,
            agreed=said.seconded,
            meant=surely,
            worded=self._worded(text for text in told if text not in phrases),
        )
        return decided(shares, lambda text: meant[text], said.clear_db)

    def _meaning(self, text: str, listening: Listening) -> Understanding:
        said = written(text, listening.asked, self._language)
        return understand(said, listening, self._language)

    def _worded(self, texts: Iterable[str]) -> dict[str, float]:
        """Return how likely a teacher says each text, where that is known."""
        known = self._wording
        return {} if known is None else {text: known.likelihood(text) for text in texts}

    def _rare(self, text: str, listening: Listening) -> float:
        """Return what is taken off a reading that is hardly ever said here."""
        if listening.asked in OPEN:
            return RARE if "please" in text.split() else 0.0
        if listening.stage != "demonstration" or listening.asked is not None:
            return 0.0
        return RARE if self._meaning(text, listening).acts == (Deny(),) else 0.0

    def _before(self, phrases: Sequence[str]) -> dict[str, float]:
        """Return how likely the recognizer finds phrases before it listens, asked once."""
        new = tuple(phrase for phrase in phrases if phrase not in self._unheard)
        if new:
            told = self._slow.likelihoods(SILENCE, new)
            self._unheard.update(zip(new, told, strict=True))
        return {phrase: self._unheard[phrase] for phrase in phrases}

    def _alike(self, heard: Sequence[str]) -> tuple[str, ...]:
        if self._language != "english":
            return ()
        return tuple(one for text in heard for one in near(text, ALIKE))

    def _made(self, heard: str, listening: Listening) -> Iterator[str]:
        """Yield what may have been said where it was read nearly right."""
        if listening.asked not in OPEN:
            yield from islice(self._repaired(heard, listening), REPAIRS)
            return
        yield from rivals(heard, listening)
        if listening.asked == "subtask_name" and self._language == "english":
            yield from named(heard, (*listening.objects, "object", "target"), ALIKE)

    def _repaired(self, heard: str, listening: Listening) -> Iterator[str]:
        """Yield sentences that surely mean something else than what was read, the nearest first."""
        if self._language != "english":
            return
        names = (listening.task, *listening.objects, *listening.subtasks)
        before = self._meaning(heard, listening)
        for text in self._likeliest(repaired(heard, names, self._language)):
            meant = self._meaning(text, listening)
            if means(meant) and not (means(before) and meant.acts == before.acts):
                yield text

    def _likeliest(self, texts: Sequence[str]) -> Sequence[str]:
        """Return the few texts a teacher likeliest says, whatever their length."""
        likely = self._worded(texts)
        ranked = sorted(texts, key=lambda text: -likely.get(text, 0.0) - len(text.split()))
        return ranked[:REPAIRS_TRIED]


def _is_sentence(text: str) -> bool:
    return len(text.split()) >= SENTENCE_WORDS


def rivals(heard: str, listening: Listening) -> tuple[str, ...]:
    """Return names and lists that sound like one that was heard, one word of it changed."""
    named_things = " ".join(listening.objects).split()
    between = ("and",) if listening.asked == "objects" else ("on", "to", "in")
    told = related(heard, (*named_things, *THINGS), between)
    return (*mended(heard, (*TEACHING, *named_things)), *told)
