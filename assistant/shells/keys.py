"""Driving the hand by keys at a terminal: a newcomer's teleoperation, with the view on.

Every key drives; Enter opens a line to say something ("then", "finished"). The way to each
thing is shown all the time, in words and keys, so that nobody has to know coordinates. The
keys shown can be clicked; the mouse drags the hand in either picture, its wheel lifts and lowers.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from contextlib import AbstractContextManager
from typing import Any

from prompt_toolkit import Application
from prompt_toolkit.buffer import Buffer
from prompt_toolkit.filters import Condition
from prompt_toolkit.formatted_text import StyleAndTextTuples
from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent
from prompt_toolkit.keys import Keys
from prompt_toolkit.layout import ConditionalContainer, HSplit, Layout, Window
from prompt_toolkit.layout.controls import BufferControl, FormattedTextControl
from prompt_toolkit.layout.processors import BeforeInput
from prompt_toolkit.mouse_events import MouseEvent, MouseEventType

from assistant.language.hints import page
from assistant.ports import HandSample
from assistant.session.equipment import DrivenHand
from assistant.session.loop import Session
from assistant.shells.driving_screen import Screen
from assistant.shells.driving_view import key_for
from assistant.shells.due import PERIOD_S, Begun, Due
from assistant.shells.gripping import Grip
from assistant.shells.said_driving import wish

ARROWS = {
    Keys.Up: "w",
    Keys.Down: "s",
    Keys.Left: "a",
    Keys.Right: "d",
    Keys.PageUp: "r",
    Keys.PageDown: "f",
}
NAMED = {"space": " "}
WHEEL = {MouseEventType.SCROLL_UP: "r", MouseEventType.SCROLL_DOWN: "f"}
REFRESH_S = 0.1
PREPARING = ("h", "u", "+", "-", "space")
"""Keys that show nothing yet: who takes the hand to a good posture first begins after that."""


class View(FormattedTextControl):
    """Text whose mouse events are first offered to someone else.

    Parameters
    ----------
    text : callable
    take : callable
        Returns whether it took an event.
    """

    def __init__(
        self, text: Callable[[], StyleAndTextTuples], take: Callable[[MouseEvent], bool]
    ) -> None:
        super().__init__(text)
        self._take = take

    def mouse_handler(self, mouse_event: MouseEvent) -> object:
        """Handle one event."""
        return None if self._take(mouse_event) else super().mouse_handler(mouse_event)


class Driving:
    """One demonstration by keys.

    Parameters
    ----------
    session : Session
        Watching.
    hand : DrivenHand
    lock : context manager
        Held while a sample is taken: words heard beside it take turns.
    every_s : float
        Between samples that are recorded; the hand is driven as smoothly as ever.
    """

    def __init__(
        self,
        session: Session,
        hand: DrivenHand,
        lock: AbstractContextManager[Any],
        every_s: float = PERIOD_S,
    ) -> None:
        self._session, self._hand, self._lock = session, hand, lock
        self._due = Due(every_s)
        self._words: dict[str, Any] = page("terminal", session.language)["driving"]
        self._cues: dict[str, str] = self._words["cues"]
        self._screen = Screen(session, hand, self._words, self.press)
        self._grip = Grip(hand, lambda: self._screen.areas)
        self._typing = False
        self._begun = Begun()
        self._told = ""
        self._asked = False
        self.anew = False
        """Whether the teacher wants to show it from the beginning."""
        self._error: BaseException | None = None
        self._line = Buffer(multiline=False, accept_handler=self._said)
        self._app: Application[None] = Application(
            layout=self._layout(),
            key_bindings=self._keys(),
            refresh_interval=REFRESH_S,
            mouse_support=True,
            erase_when_done=True,
        )

    def run(self) -> None:
        """Drive until the demonstration is over."""
        self._session.workplace.driven = self._hand
        try:
            self._app.run(pre_run=self._begin)
        finally:
            self._session.workplace.driven = None
        if self._error is not None:
            raise self._error

    def _begin(self) -> None:
        self._app.create_background_task(self._pump())

    async def _pump(self) -> None:
        try:
            while self._session.watching is not None and not self._session.left:
                began_s = time.monotonic()
                with self._lock:
                    self._see(self._hand.tick())
                await asyncio.sleep(max(PERIOD_S - (time.monotonic() - began_s), 0.0))
        except Exception as error:
            self._error = error
        self._app.exit()

    def _see(self, sample: HandSample) -> None:
        """Record a sample; while the hand takes something back nothing is recorded."""
        if self._hand.state.returning:
            if sample.said:
                # Words are not taken back: they go with the next sample that counts.
                self._hand.say(sample.said)
            return
        watching, shown = self._session.watching, self._begun(sample)
        if watching is not None and (shown is None or shown.t_s <= watching.shown_s):
            watching.take_back(0.0 if shown is None else shown.t_s)
        if shown is not None and self._due(shown):
            self._session.see(shown)

    def _layout(self) -> Layout:
        typing = Condition(lambda: self._typing)
        before = BeforeInput(str(self._words["say"]))
        line = Window(BufferControl(self._line, [before]), height=1)
        view = Window(View(self._status, self._mouse), dont_extend_height=True)
        return Layout(HSplit([view, ConditionalContainer(line, typing)]), focused_element=None)

    def _status(self) -> StyleAndTextTuples:
        return self._screen.fragments(self._told, dragging=self._grip.holds)

    def _mouse(self, event: MouseEvent) -> bool:
        """Take what the mouse does beyond clicking a key."""
        if event.event_type in WHEEL:
            self.press(WHEEL[event.event_type])
            return True
        taken = self._grip.take(event)
        if taken:
            self._begun.begin()
        return taken

    def press(self, key: str) -> None:
        """Take a key as it is named in the list of keys."""
        self._asked = self._asked and key == "Esc"
        if key == "Enter":
            self._speak()
        elif key == "Esc":
            self._finish()
        elif key in self._cues:
            self._told = str(self._words["said"]).format(words=f'"{self._cues[key]}"')
            self._hand.say(self._cues[key])
        else:
            self._move(key)

    def _move(self, key: str) -> None:
        key = key if key in NAMED else key.lower()
        name = next((name for name, each in NAMED.items() if each == key), key)
        if self._hand.press(key_for(NAMED.get(key, key), facing=self._screen.facing)):
            if name not in PREPARING:
                self._begun.begin()
            self._told = self._done(name)
        else:
            shown = key if key.isprintable() else "?"
            self._told = str(self._words["nothing"]).format(key=shown)

    def _done(self, name: str) -> str:
        """Return what a key did; with the clutch out only the clutch does anything."""
        if self._hand.state.clutched:
            return ""
        return str(
            self._words["clutch_in"] if name == "space" else self._words["keys"].get(name, "")
        )

    def _speak(self) -> None:
        self._typing = True
        self._app.layout.focus(self._line)

    def _keys(self) -> KeyBindings:
        keys = KeyBindings()
        driving = Condition(lambda: not self._typing)

        @keys.add("<any>", filter=driving)
        def drive(event: KeyPressEvent) -> None:
            pressed = event.key_sequence[0].key
            self.press(ARROWS.get(pressed, event.data) if isinstance(pressed, Keys) else event.data)

        @keys.add("enter", filter=driving)
        def speak(event: KeyPressEvent) -> None:
            self._speak()

        @keys.add("escape", eager=True)
        def finish(event: KeyPressEvent) -> None:
            self._finish_or_go_on()

        @keys.add("c-c", eager=True)
        @keys.add("<sigint>")
        def stop(event: KeyPressEvent) -> None:
            self._hand.release()
            self._told = str(self._words["halted"])

        return keys

    def _finish_or_go_on(self) -> None:
        """Esc leaves the line if one is being typed, else it ends the demonstration."""
        if self._typing:
            self._line.reset()
            self._typing = False
        else:
            self._finish()

    def _finish(self) -> None:
        """End the demonstration; what seems to be missing is told once."""
        told = "" if self._asked else self._screen.unfinished()
        self._asked = True
        if told:
            self._told = told
            return
        self._hand.say(self._cues["Esc"])

    def _said(self, line: Buffer) -> bool:
        self._typing = False
        text = line.text.strip()
        if text:
            self._session.raw(text)
            self._take(text)
        return False

    def _take(self, text: str) -> None:
        """Do what is typed: it is said to the robot, or asks something of the keys."""
        asked, part = wish(self._session, text)
        if asked == "back":
            self.press("u")
        elif asked == "help":
            self._told = str(self._words["help"])
        else:
            self.anew = asked == "anew"
            self._hand.say(part)
            self._told = str(self._words["said"]).format(words=f'"{text}"')
