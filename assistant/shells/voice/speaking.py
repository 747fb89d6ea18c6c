"""Speaking the robot's lines one after another, beside the captions.

A line that holds a stop word is not spoken while the arm moves: the robot must not stop itself.
While it moves a line is spoken in one sentence, and only the newest: talk would fall behind the
motion, and a stop said meanwhile is hard to hear. Long lists are shown, not spoken. What was
spoken is remembered for a while, so that the robot's own voice in the microphone is not taken
for the teacher's.
"""

from __future__ import annotations

import queue
import re
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Protocol

from assistant.language.stopping import has_stop_word

MOST_WORDS = 40
MOST_LINES = 3
ECHO_SHARE = 0.6
POLL_S = 0.05
RECENT_LINES = 4
SENTENCE_END = re.compile(r"(?<=[.!?])\s+(?=[A-Z\"])")


class Speaker(Protocol):
    """An engine that speaks one sentence at a time, such as `Mouth`."""

    @property
    def speaking(self) -> bool:
        """Whether a sentence is being spoken."""
        ...

    def say(self, text: str) -> None:
        """Begin to speak and return at once."""
        ...

    def hush(self) -> None:
        """Fall silent now."""
        ...


class Speaking:
    """Speaks lines in turn, in a thread of its own.

    Parameters
    ----------
    speaker : Speaker
    moving : callable
        Whether the arm moves now.
    language : str
    """

    def __init__(
        self, speaker: Speaker, moving: Callable[[], bool], language: str = "english"
    ) -> None:
        self._speaker = speaker
        self._moving = moving
        self._language = language
        self._lines: queue.Queue[tuple[str, bool]] = queue.Queue()
        self._recent: list[str] = []
        self._waiting = 0
        self._lock = threading.Lock()
        threading.Thread(target=self._run, name="mouth", daemon=True).start()

    @property
    def speaking(self) -> bool:
        """Whether something is being spoken or waits to be."""
        return self._waiting > 0 or self._speaker.speaking

    def say(self, text: str) -> None:
        """Speak a line after those before it that still matter; return at once."""
        moving = self._moving()
        aloud = briefly(speakable(text)) if moving else speakable(text)
        if moving and has_stop_word(aloud, self._language):
            return
        with self._lock:
            self._forget_passed()
            self._waiting += 1
            self._recent = [*self._recent, aloud][-RECENT_LINES:]
            self._lines.put((aloud, moving))

    def hush(self) -> None:
        """Fall silent and forget what waits: the teacher speaks."""
        with self._lock:
            self._waiting -= len(self._taken_back())
        self._speaker.hush()

    def _forget_passed(self) -> None:
        """Drop lines that wait about a motion which has gone on since."""
        for line, passing in self._taken_back():
            if passing:
                self._waiting -= 1
            else:
                self._lines.put((line, passing))

    def _taken_back(self) -> list[tuple[str, bool]]:
        """Return the lines that waited; the mouth may take one of them meanwhile."""
        taken: list[tuple[str, bool]] = []
        with suppress(queue.Empty):
            while True:
                taken.append(self._lines.get_nowait())
        return taken

    def finish(self, most_s: float = 10.0) -> None:
        """Wait until all is said, for so long at most."""
        until_s = time.monotonic() + most_s
        while self.speaking and time.monotonic() < until_s:
            time.sleep(POLL_S)
        self._speaker.hush()

    def is_echo(self, words: str) -> bool:
        """Whether words heard just now are mostly the robot's own."""
        told = words.lower().split()
        own = {word.strip(".,!?:;\"'") for line in self._recent for word in line.lower().split()}
        return bool(told) and sum(word in own for word in told) >= ECHO_SHARE * len(told)

    def _run(self) -> None:
        while True:
            line, _ = self._lines.get()
            try:
                self._speaker.say(line)
                while self._speaker.speaking:
                    time.sleep(POLL_S)
            finally:
                with self._lock:
                    self._waiting = max(0, self._waiting - 1)


def briefly(text: str) -> str:
    """Return the first sentence of a line."""
    return SENTENCE_END.split(text, maxsplit=1)[0]


def speakable(text: str) -> str:
    """Return what is spoken of a line: without trees and tables, and not on and on."""
    lines = [line for line in text.splitlines() if line.strip()]
    prose = [line for line in lines if line[0].isalnum() or line[0] in "\"'("] or lines[:1]
    words = " ".join(prose[:MOST_LINES] if len(prose) > MOST_LINES else prose).split()
    if len(words) <= MOST_WORDS and len(prose) == len(lines):
        return " ".join(words)
    short = " ".join(words[:MOST_WORDS])
    ended = max(short.rfind(". "), short.rfind("? "), short.rfind(": "), short.rfind("; "))
    short = short[: ended + 1] if ended > 0 and len(words) > MOST_WORDS else short
    return f"{short.rstrip(':;,')} The rest is shown."
