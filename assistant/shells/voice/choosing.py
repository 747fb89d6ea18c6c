"""Which of all that may have been said it was: readings, what is expected, and what sounds alike.

A recognizer that tells how well given words explain a sound weighs all of them alike. Whole
sentences that were read are weighed among themselves first: mostly that settles it, in a tenth
of the time.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice

import numpy as np

from assistant.language.answers import OPEN
from assistant.language.understanding import understand
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import Deny
from assistant.shells.voice.deciding import CLEAR_SHARE, SURE_SHARE, Heard, decided, is_sure, means
from assistant.shells.voice.phrasebank import mended, named, near, related
from assistant.shells.voice.recognized import Weigher
from assistant.shells.voice.repairing import repaired, written
from assistant.shells.voice.said import Said, is_sentence
from assistant.shells.voice.sound import RATE_HZ
from assistant.shells.voice.weighing import (
    COMMANDS,
    NAMES,
    QUIET,
    Evidence,
    length_penalty,
    log_odds,
    weighed,
)
from assistant.shells.voice.wording import wording

SILENCE = np.zeros(RATE_HZ, dtype=np.float32)
ALIKE = 8
ALIKE_TO = 3
"""So many commands that sound alike are weighed, for so many readings."""
REPAIRS = 8
"""So many sentences are weighed that a reading nearly is."""
MOST = 14
"""So many sentences are asked about: among them is what was said wherever it is at all."""
UNWORDED, UNWORDED_WORD = -7.5, 2.5
"""Where the sound is clear, how teachers word things takes no more off than this."""
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
        self.wording = wording(language)
        self._unheard: dict[str, float] = {}
        self._meanings: dict[tuple[str, Listening], Understanding] = {}
        self._fits: dict[str, float] = {}

    def choose(self, said: Said) -> Heard:
        """Return what was said, as surely as the sound tells it."""
        self.forget()
        if not said.free and any(map(is_sentence, said.texts)):
            heard = self._settled(said, self.evidence(said, said.texts))
            if is_sure(heard) and is_sentence(heard.text):
                return heard
        return self._settled(said, self.everything(said))

    def forget(self) -> None:
        """Forget the last utterance."""
        self._meanings.clear()
        self._fits.clear()

    def everything(self, said: Said) -> dict[str, Evidence]:
        """Return all that may have been said, and what speaks for it."""
        known = said.texts[:ALIKE_TO]
        made = tuple(text for one in known for text in self._made(one, said.listening))
        texts = (*said.texts, *said.phrases, *made, *self._alike(known))
        return self.evidence(said, texts, said.phrases, made if said.free else ())

    def _settled(self, said: Said, told: Mapping[str, Evidence]) -> Heard:
        weights = COMMANDS if said.commanded else NAMES if said.free else QUIET
        found = weighed(told, said.speech_s, weights, said.doubt)
        least = SURE_SHARE if said.commanded else CLEAR_SHARE
        return decided(found, lambda text: self.meaning(text, said.listening), said.clear_db, least)

    def evidence(
        self,
        said: Said,
        texts: Iterable[str],
        phrases: Sequence[str] = (),
        mends: Sequence[str] = (),
    ) -> dict[str, Evidence]:
        """Return what speaks for the texts that may be it; `phrases` are expected now.

        How well words explain the sound takes the longest to tell: that is asked about those
        for which most else speaks.
        """
        told = [
            self._beforehand(said, text, phrases)
            for text in dict.fromkeys(texts)
            if text in said.texts or length_penalty(text, said.speech_s) < TOO_LONG
        ]
        if said.commanded:
            told.sort(key=lambda one: -log_odds(one.features(said.speech_s), COMMANDS))
            return self._fitted(said, told[:MOST])
        hoped = [one.text for one in told if one.text in phrases]
        before = self._before(hoped) | {text: MENDED for text in mends}
        return self._fitted(said, [replace(one, before=before.get(one.text)) for one in told])

    def _beforehand(self, said: Said, text: str, phrases: Sequence[str]) -> Evidence:
        """Return what speaks for words beside the sound."""
        expected = text in phrases
        own, other = said.alike(text)
        return Evidence(
            text,
            expected=expected,
            agreed=text in said.seconded,
            read=said.read.get(text),
            meant=self._means(said, text, expected),
            worded=self._worded(said, text),
            alike=own,
            alike_elsewhere=other,
            rare=self._rare(text, said.listening),
        )

    def _means(self, said: Said, text: str, expected: bool) -> bool:
        """Whether it counts that a text means something here; elsewhere `expected` does."""
        if said.free or expected:
            return expected and said.commanded
        return means(self.meaning(text, said.listening))

    def _worded(self, said: Said, text: str) -> float | None:
        """Return how likely a teacher says a text; where the sound is clear, any may be said."""
        if self.wording is None:
            return None
        likely = self.wording.likelihood(text)
        least = UNWORDED - UNWORDED_WORD * len(text.split())
        return likely if said.commanded else max(likely, least)

    def _fitted(self, said: Said, told: Sequence[Evidence]) -> dict[str, Evidence]:
        """Return all with how well they explain the sound, asked once for each utterance."""
        new = tuple(one.text for one in told if one.text not in self._fits)
        likely = self._slow.likelihoods(said.samples, new, loud=said.loud)
        self._fits.update(zip(new, likely, strict=True))
        return {one.text: replace(one, fit=self._fits[one.text]) for one in told}

    def meaning(self, text: str, listening: Listening) -> Understanding:
        """Return what words mean here, made once for each utterance."""
        if (text, listening) not in self._meanings:
            said = written(text, listening.asked, self._language)
            self._meanings[text, listening] = understand(said, listening, self._language)
        return self._meanings[text, listening]

    def _rare(self, text: str, listening: Listening) -> bool:
        """Whether words are hardly ever said here, though they sound like others that are.

        Nobody says "please" in a name, where "place" is common; while a hand shows the task
        "now" is a cue, and "no" answers nothing.
        """
        if listening.asked in OPEN:
            return "please" in text.split()
        watching = listening.stage == "demonstration" and listening.asked is None
        return watching and self.meaning(text, listening).acts == (Deny(),)

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
        before = self.meaning(heard, listening)
        for text in repaired(heard, names, self._language):
            meant = self.meaning(text, listening)
            if means(meant) and not (means(before) and meant.acts == before.acts):
                yield text


def rivals(heard: str, listening: Listening) -> tuple[str, ...]:
    """Return names and lists that sound like one that was heard, one word of it changed."""
    named_things = " ".join(listening.objects).split()
    between = ("and",) if listening.asked == "objects" else ("on", "to", "in")
    told = related(heard, (*named_things, *THINGS), between)
    return (*mended(heard, (*TEACHING, *named_things)), *told)
