"""Listening beside the typed shell: frames in, stops at once, sentences to the session.

Two paths leave a frame. The spotter's is short and never muted: while the arm moves a spotted
stop sets the flag that the arm's tick reads. The other joins frames into an utterance, has it
recognized and understood, and hands the words on like typed ones, with how surely they were
heard and how long ago they began. Recognizing happens in a thread of its own, so that a stop
said meanwhile is spotted; it begins with the silence that may end an utterance, not behind it.
"""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable, Iterable, Iterator
from typing import Protocol

from assistant.language.stopping import has_stop_word
from assistant.model.listening import Listening
from assistant.session.loop import Session
from assistant.shells.beside import Words
from assistant.shells.voice.deciding import DOUBT, Heard, is_unknown
from assistant.shells.voice.endpointing import FRAME_S, Endpointer, Utterance
from assistant.shells.voice.memory import give_back
from assistant.shells.voice.sound import Samples

SHORT_ANSWERS = frozenset(
    ("ready", "satisfied", "confirm_tree", "confirm_segmentation", "optional", "order",
     "did_you_mean", "unsaved", "facing", "subtask_count")
)  # fmt: skip
"""Questions whose answer is a word or two: silence ends it sooner."""

TAIL_FRAMES = 4
"""So much later the robot's own voice is heard no more: an eighth of a second."""


class Spotter(Protocol):
    """Tells at once when it hears stop."""

    def hear(self, samples: Samples) -> bool:
        """Take the next sound; return whether stop was heard in it."""
        ...


class Listens(Protocol):
    """Turns an utterance into words, such as `Hearing`."""

    def hear(self, samples: Samples, listening: Listening) -> Heard:
        """Return what the utterance means where the dialogue stands."""
        ...


class Voice(Protocol):
    """The robot's own voice, as far as listening depends on it, such as `Speaking`."""

    @property
    def speaking(self) -> bool:
        """Whether the robot speaks now."""
        ...

    def hush(self) -> None:
        """Fall silent now."""
        ...

    def is_echo(self, words: str) -> bool:
        """Whether these words are mostly the robot's own."""
        ...


class Ears:
    """Hears for a session.

    Parameters
    ----------
    session : Session
    take : callable
        Takes words to the session, in turn with the arm's ticks.
    endpointer : Endpointer
    hearing : Listens
    spotter : Spotter or None
    voice : Voice or None
        The robot's own.
    headset : bool
        The microphone does not hear the robot, so the teacher may talk over it.
    """

    def __init__(
        self,
        session: Session,
        take: Callable[[Words], None],
        endpointer: Endpointer,
        hearing: Listens,
        *,
        spotter: Spotter | None = None,
        voice: Voice | None = None,
        headset: bool = False,
    ) -> None:
        self._session = session
        self._give = take
        self._endpointer = endpointer
        self._hearing = hearing
        self._spotter = spotter
        self._voice = voice
        self._headset = headset
        self._talked_over = False
        self._since_own = 0
        self._frames = 0
        self._spotted_s = -1.0
        self._waiting: queue.Queue[tuple[Utterance, bool] | Utterance | None] = queue.Queue()
        self._ahead: tuple[Utterance, Listening, Heard] | None = None

    @property
    def now_s(self) -> float:
        """How much has been heard."""
        return self._frames * FRAME_S

    def listen(self, frames: Iterable[Samples], *, beside: bool = True) -> None:
        """Hear frames until there are no more, or the session is left.

        Parameters
        ----------
        frames : iterable of array, each of 512 samples
        beside : bool
            Recognize in a thread of its own; else frames wait for it.
        """
        if not beside:
            for ended in self._utterances(frames):
                self._understand(*ended)
            return
        worker = threading.Thread(target=self._work, name="recognizer", daemon=True)
        worker.start()
        try:
            for ended in self._utterances(frames, ahead=self._waiting.put):
                self._waiting.put(ended)
        finally:
            self._waiting.put(None)
            worker.join()

    def _utterances(
        self, frames: Iterable[Samples], ahead: Callable[[Utterance], None] | None = None
    ) -> Iterator[tuple[Utterance, bool]]:
        """Yield utterances that have ended; `ahead` takes those that may have."""
        for frame in frames:
            if self._session.left:
                return
            if ended := self._hear(frame):
                yield ended
            elif ahead is None or not self._matters(self._talked_over):
                continue
            elif paused := self._endpointer.paused():
                ahead(paused)
        if last := self._endpointer.end():
            yield last, self._talked_over

    def _work(self) -> None:
        while (one := self._waiting.get()) is not None:
            if self._session.left:
                continue
            if not isinstance(one, Utterance):
                self._understand(*one)
            elif self._waiting.empty():
                # What else waits has overtaken it.
                listening = self._session.listening
                self._ahead = one, listening, self._recognized(one, listening)

    def _hear(self, frame: Samples) -> tuple[Utterance, bool] | None:
        """Take one frame; return an utterance that has ended and whether the robot spoke too."""
        self._frames += 1
        self._endpointer.short_answer = self._session.listening.asked in SHORT_ANSWERS
        ended = self._endpointer.hear(frame)
        self._spot(frame)
        own = self._voice is not None and self._voice.speaking
        self._since_own = 0 if own else self._since_own + 1
        over = self._endpointer.speaking and own
        if over and self._headset and self._voice is not None:
            self._voice.hush()
        self._talked_over = self._talked_over or (over and not self._headset)
        if ended is None and self._talked_over and self._since_own == TAIL_FRAMES:
            # Whoever answers at once is not to be taken for the robot.
            ended = self._endpointer.end()
        if ended is None:
            if not self._endpointer.speaking:
                self._talked_over = False
            return None
        talked_over, self._talked_over = self._talked_over, False
        return ended, talked_over

    def _spot(self, frame: Samples) -> None:
        if self._spotter is None or not self._spotter.hear(frame) or not self._session.moving:
            return
        if not self._endpointer.somebody:
            # A clatter or a tune may resemble the word; nobody spoke.
            return
        # The flag halts the arm at its next tick; the words for it take their turn.
        self._session.equipment.stop_flag.set()
        self._spotted_s = self.now_s
        self._give(Words("stop", 1.0, 0.0))

    def _matters(self, talked_over: bool) -> bool:
        """Whether to recognize it: at rest the robot's own voice is nothing to spend time on."""
        return self._session.moving or not talked_over

    def _understand(self, utterance: Utterance, talked_over: bool) -> None:
        if not self._matters(talked_over):
            return
        heard = self._heard(utterance)
        words = heard.text
        if not words or self._is_own(words, talked_over) or self._is_noise(heard):
            return
        spotted = self._spotted_s >= utterance.speech_from_s
        if spotted and has_stop_word(words, self._session.language):
            return
        self._session.raw(words)
        # Words that were weighed and found to mean nothing are not to be taken for something.
        unknown = is_unknown(heard.understanding)
        sure = min(heard.sure, DOUBT if unknown else 1.0)
        self._give(Words(words, sure, self.now_s - utterance.speech_from_s))

    def _heard(self, utterance: Utterance) -> Heard:
        """Return what an utterance means, recognized ahead if that still holds."""
        listening = self._session.listening
        if self._ahead is not None:
            ahead, where, heard = self._ahead
            same = ahead.speech_from_s == utterance.speech_from_s
            if same and ahead.speech_to_s == utterance.speech_to_s and where == listening:
                return heard
        return self._recognized(utterance, listening)

    def _recognized(self, utterance: Utterance, listening: Listening) -> Heard:
        heard = self._hearing.hear(utterance.sound.samples, listening)
        give_back()
        return heard

    def _is_own(self, words: str, talked_over: bool) -> bool:
        """Whether this is the robot's own voice, at least in part; a stop is never muted."""
        if has_stop_word(words, self._session.language) and self._session.moving:
            return False
        echo = self._voice is not None and self._voice.is_echo(words)
        return talked_over and (echo or not has_stop_word(words, self._session.language))

    def _is_noise(self, heard: Heard) -> bool:
        """Whether nobody needs an answer: chat and noise while the arm moves or a hand shows."""
        busy = self._session.moving or self._session.watching is not None
        return busy and is_unknown(heard.understanding)
