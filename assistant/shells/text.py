"""The terminal: one line to type in, the robot's lines above it, Ctrl-C stops the arm.

The arm moves beside the typing; a half-typed sentence stays as it is while the robot talks.
"""

from __future__ import annotations

import asyncio
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path

from prompt_toolkit import PromptSession
from prompt_toolkit.auto_suggest import AutoSuggestFromHistory
from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent
from prompt_toolkit.patch_stdout import StdoutProxy
from prompt_toolkit.search import stop_search
from prompt_toolkit.shortcuts import CompleteStyle

from assistant.language.hints import page
from assistant.model.robot_acts import RobotAct
from assistant.session import halting
from assistant.session.acting import leave, wants_to_leave
from assistant.session.heartbeat import Heartbeat
from assistant.session.loop import Session
from assistant.shells.answering import picture, redrawn, rendered
from assistant.shells.bar import bar
from assistant.shells.beating import BEAT_S
from assistant.shells.beside import Beside, Words
from assistant.shells.completing import Sayable, remembered
from assistant.shells.interrupting import interrupts
from assistant.shells.leading import lead
from assistant.shells.overhearing import Overhearing, typed_lines
from assistant.shells.pacing import RealClock, Ticker
from assistant.shells.showing import Showing
from assistant.shells.wrapping import columns, styled, wrapped

STYLES = {"stopped": "1;31", "refuse": "31", "error": "31", "ask": "1", "confirm": "1"}
"""Colors of a terminal by the robot's acts (ANSI): each can be read on white and on black."""
INDENT = "  "
NAME_STYLE, HINT_STYLE = "35", "90"
REFRESH_S = 0.5
FORGOTTEN = "awaitingshow"
"""Where the dialogue stands when what was shown is to be shown anew."""
BUNDLED_S = 0.02
"""What is said within so long is drawn at once."""


class TextShell:
    """Talks at a terminal.

    Parameters
    ----------
    history : Path
        Where what was typed is remembered between sessions.
    pace : float
        How many simulated seconds pass in a real one.
    """

    def __init__(self, history: Path, pace: float = 1.0) -> None:
        self._pace = pace
        self._history = history
        self._session: Session | None = None
        self._names: dict[str, str] = page("terminal", "english")["names"]
        self._ticker: Ticker | None = None
        self._error: BaseException | None = None
        self._left_known_s: float | None = None
        self._interrupted = False
        self._typed = ""
        self._waiting: list[str] = []
        self._begun = ""
        self._showing = Showing(self._write, keys=True)
        self._heart = Heartbeat(RealClock())

    def attach(self, session: Session) -> None:
        """Take note of the language of a session that is about to begin."""
        self._names = page("terminal", session.language)["names"]

    def out(self, line: RobotAct, text: str) -> None:
        """Say a robot line above the line being typed."""
        session = self._session
        shown = None if session is None else picture(session, line, asked=self._typed)
        if session is not None and shown is not None:
            text = page("terminal", session.language)["pictures"].get(line.topic, text)
        style = STYLES.get(line.act, "")
        name = f"{self._names['robot']}: "
        first, *more = wrapped(text, columns(), before=name)
        write(styled(name, NAME_STYLE) + styled(first[len(name) :], style))
        for one in more:
            write(styled(one, style))
        shown = shown or (redrawn(session, line) if session is not None else None)
        if shown is not None:
            write(rendered(shown, columns() - 1))

    def run(self, session: Session, beside: Beside | None = None) -> None:
        """Hold the conversation until the robot leaves or the terminal closes.

        Parameters
        ----------
        session : Session
        beside : Beside, optional
            What listens beside the typing.
        """
        self._session = session
        session.in_touch = self._heart.alive
        self._ticker = ticker = Ticker(session, self._fail, self._pace)
        words = page("terminal", session.language)
        kept = "" if session.journal.trouble else f" {words['kept']}"
        self._write(words["welcome"] + kept)
        prompt = self._prompt(session)
        ticker.start()
        if beside is not None:
            beside.begin(session, lambda words: self._heard(session, prompt, words))
        try:
            with _above_the_prompt(), interrupts(self._interrupt):
                while not session.left and self._error is None:
                    self._turn(session, prompt)
        finally:
            ticker.stop()
        if self._error is not None:
            raise self._error

    def _turn(self, session: Session, prompt: PromptSession[str]) -> None:
        if self._waiting:
            self._take(session, self._waiting.pop(0))
            return
        try:
            begun, self._begun = self._begun, ""
            text = prompt.prompt(
                f"{self._names['you']}: ",
                default=begun,
                pre_run=lambda: self._begin(session, prompt),
            ).strip()
        except EOFError:
            self._closed(session)
            return
        # What is pasted in several lines is said line by line.
        for line in text.splitlines() or ("",):
            if session.left:
                return
            self._take(session, line.strip())

    def _closed(self, session: Session) -> None:
        """Take Ctrl-D for "quit"; nobody is there who closes the line again."""
        assert self._ticker is not None
        session.equipment.stop_flag.set()
        with self._ticker.lock:
            self._heart.beat()
            if not wants_to_leave(session):
                leave(session, tells=True)
                session.left = True

    def _take(self, session: Session, text: str) -> None:
        session.raw(text)
        self._typed = text
        assert self._ticker is not None
        # Whoever drives by keys may talk meanwhile: the lock is taken for each sample.
        every_s = self._showing.by_keys(session, text)
        if every_s is not None:
            lead(session, self._ticker.lock, every_s, self._write)
            text = ""
        with self._ticker.lock, Overhearing(typed_lines(), session.raw) as overheard:
            if text and not self._showing.take(session, text):
                session.hear(text)
            self._showing.offer(session)
            self._heart.beat()
        self._waiting += overheard.lines
        self._begun += overheard.begun

    def _interrupt(self) -> None:
        """Stop what moves or is about to; the rest is done when what is under way is over."""
        self._interrupted = True
        if self._session is not None:
            self._session.equipment.stop_flag.set()

    def _halt(self, session: Session) -> None:
        self._interrupted = False
        assert self._ticker is not None
        with self._ticker.lock:
            if session.moving:
                session.halt(halting.KEY)
                return
            # What was to be stopped is over; whatever is begun next is begun on purpose.
            session.equipment.stop_flag.clear()
        self._write(page("terminal", session.language)["at_rest"])

    def _begin(self, session: Session, prompt: PromptSession[str]) -> None:
        if self._interrupted:
            self._halt(session)
        prompt.app.create_background_task(self._beat())

    async def _beat(self) -> None:
        """Beat as long as the line can be typed in: a loop that hangs takes no stop."""
        while True:
            self._heart.beat()
            await asyncio.sleep(BEAT_S)

    def _prompt(self, session: Session) -> PromptSession[str]:
        return PromptSession(
            history=remembered(self._history),
            completer=Sayable(session),
            complete_while_typing=False,
            complete_style=CompleteStyle.MULTI_COLUMN,
            # Without colors what is suggested would look like what is typed.
            auto_suggest=None if os.environ.get("NO_COLOR") else AutoSuggestFromHistory(),
            enable_history_search=True,
            bottom_toolbar=lambda: bar(session, self._left_s(session)),
            refresh_interval=REFRESH_S,
            key_bindings=self._keys(session),
        )

    def _keys(self, session: Session) -> KeyBindings:
        keys = KeyBindings()

        @keys.add("c-c", eager=True)
        @keys.add("<sigint>")
        def stop(event: KeyPressEvent) -> None:
            searching = event.app.layout.is_searching
            if searching:
                stop_search()
            if not session.moving and (searching or event.current_buffer.text):
                event.app.current_buffer.reset()
                return
            self._interrupt()
            self._halt(session)

        return keys

    def _heard(self, session: Session, prompt: PromptSession[str], words: Words) -> None:
        """Take what was heard beside the typing; a half-typed line stays as it is."""
        assert self._ticker is not None
        with self._ticker.lock:
            if session.left:
                return
            self._write(f"{self._names['you']}: {words.text}")
            if not self._showing.take(session, words.text):
                session.hear(words.text, by_voice=True, sure=words.sure, ago_s=words.ago_s)
            self._showing.offer(session)
        app, loop = prompt.app, prompt.app.loop
        if session.left and loop is not None and app.is_running:
            loop.call_soon_threadsafe(lambda: app.exit(result=""))

    def _left_s(self, session: Session) -> float | None:
        """Return for how long the arm still moves; None while it is busy."""
        if self._ticker is None or not session.moving:
            return None
        # Looking at the arm must not come between its ticks, nor wait for them.
        if self._ticker.lock.acquire(blocking=False):
            try:
                self._left_known_s = session.mover.left_s / self._pace
            finally:
                self._ticker.lock.release()
        return self._left_known_s

    def _write(self, text: str) -> None:
        for line in wrapped(text, columns(), before=INDENT):
            write(styled(line, HINT_STYLE))

    def _fail(self, error: BaseException) -> None:
        self._error = error


@contextmanager
def _above_the_prompt() -> Iterator[None]:
    """Let what is written appear above the line being typed."""
    with StdoutProxy(BUNDLED_S, raw=True) as proxy, redirect_stdout(proxy), redirect_stderr(proxy):
        yield


def write(text: str) -> None:
    """Write a line above the one being typed; safe from any thread while the prompt is open."""
    sys.stdout.write(f"{text}\n")
    sys.stdout.flush()
