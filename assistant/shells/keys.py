"""Driving the hand by keys at a terminal: a newcomer's teleoperation, with the view on.

Every key drives; Enter opens a line to say something ("then", "finished"). What the hand is
from each thing is shown all the time, so that nobody has to know coordinates.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable

import numpy as np
from prompt_toolkit import Application
from prompt_toolkit.buffer import Buffer
from prompt_toolkit.filters import Condition
from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent
from prompt_toolkit.layout import ConditionalContainer, HSplit, Layout, Window
from prompt_toolkit.layout.controls import BufferControl, FormattedTextControl
from prompt_toolkit.layout.processors import BeforeInput

from assistant.geometry import quat_to_rpy, relative
from assistant.session.equipment import DrivenHand
from assistant.session.loop import Session

HELP = (
    "  w/s forward, back   a/d left, right   r/f up, down   q/e turn   o/c open, close the hand",
    '  +/- faster, slower  space: clutch     n: "next step"  Enter: say something, Esc: finished',
)
WORDS = {"n": "next step", "1": "first step"}
FINISHED = "finished"
PERIOD_S = 0.02


class Driving:
    """One demonstration by keys.

    Parameters
    ----------
    session : Session
        Watching.
    hand : DrivenHand
    """

    def __init__(self, session: Session, hand: DrivenHand) -> None:
        self._session, self._hand = session, hand
        self._typing = False
        self._line = Buffer(multiline=False, accept_handler=self._said)
        self._app: Application[None] = Application(
            layout=self._layout(), key_bindings=self._keys(), refresh_interval=0.1
        )

    def run(self) -> None:
        """Drive until the demonstration is over."""
        self._session.driven = self._hand
        try:
            self._app.run(pre_run=self._begin)
        finally:
            self._session.driven = None

    def _begin(self) -> None:
        self._app.create_background_task(self._pump())

    async def _pump(self) -> None:
        while self._session.watching is not None:
            began_s = time.monotonic()
            self._session.see(self._hand.tick())
            await asyncio.sleep(max(PERIOD_S - (time.monotonic() - began_s), 0.0))
        self._app.exit()

    def _layout(self) -> Layout:
        typing = Condition(lambda: self._typing)
        line = Window(BufferControl(self._line, [BeforeInput("say: ")]), height=1)
        status = Window(FormattedTextControl(self._status), height=len(HELP) + 2)
        return Layout(HSplit([status, ConditionalContainer(line, typing)]), focused_element=None)

    def _status(self) -> str:
        return "\n".join((*HELP, *view(self._session, self._hand)))

    def _keys(self) -> KeyBindings:
        keys = KeyBindings()
        driving = Condition(lambda: not self._typing)

        @keys.add("<any>", filter=driving)
        def drive(event: KeyPressEvent) -> None:
            key = event.data.lower()
            if key in WORDS:
                self._hand.say(WORDS[key])
            else:
                self._hand.press(key)

        @keys.add("enter", filter=driving)
        def speak(event: KeyPressEvent) -> None:
            self._typing = True
            event.app.layout.focus(self._line)

        @keys.add("escape", eager=True)
        def finish(event: KeyPressEvent) -> None:
            self._hand.say(FINISHED)

        @keys.add("c-c", eager=True)
        def stop(event: KeyPressEvent) -> None:
            self._hand.release()

        return keys

    def _said(self, line: Buffer) -> bool:
        self._typing = False
        if line.text.strip():
            self._session.raw(line.text)
            self._hand.say(line.text.strip())
        return False


def view(session: Session, hand: DrivenHand) -> tuple[str, str]:
    """Return two lines that tell where the hand is, seen from every thing, and what it does."""
    look, state = session.mover.look, hand.state
    scene, setup = session.mover.scene, session.mover.setup
    gaps = []
    for name, place in setup.places.items():
        x, y, z, *quat = relative(look.hand, scene.hand_pose(name, place))
        yaw = float(np.rad2deg(quat_to_rpy(np.array(quat))[2]))
        gaps.append(f"{name}: {_way(x, y, z)}, turn {yaw:+.0f} deg")
    clutch = "clutch out" if state.clutched else f"speed {state.speed:.2f}"
    doing = state.blocked and f"blocked: {state.blocked}"
    return "  " + "   ".join(gaps), f"  {clutch}   hand {1000 * look.gripper_m:.0f} mm   {doing}"


def _way(x: float, y: float, z: float) -> str:
    told: list[tuple[float, Callable[[float], str]]] = [
        (x, lambda d: "ahead" if d > 0 else "back"),
        (y, lambda d: "left" if d > 0 else "right"),
        (z, lambda d: "up" if d > 0 else "down"),
    ]
    return " ".join(f"{abs(1000 * gap):.0f} {word(gap)}" for gap, word in told)
