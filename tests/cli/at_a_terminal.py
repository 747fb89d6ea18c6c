"""Someone at a terminal: types, presses keys, looks where the hand is, answers as terminals do."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pexpect

from assistant.cli.adapters import make_equipment
from assistant.geometry import Array
from assistant.model.transcript import Transcript
from assistant.session.opening import Opening, open_session

KEYS = (("w", "s"), ("a", "d"), ("r", "f"))
"""Keys for more and for less of x, y and z."""
RESTS_S = 0.1
REPEATED_S = 0.03
"""A terminal repeats a held key about this often."""
STEP_M = 0.005
"""What a tap does."""
WHERE = "\x1b[6n"
"""How a terminal is asked where its cursor is."""
TALK = (
    ("pick and place", "should be the case"),
    ("the block rests on the target", "Which things"),
    ("the block and the target", "how many steps"),
    ("five", "first of the 5"),
    ("approach the block", "second of"),
    ("grasp the block", "third of"),
    ("move up", "fourth of"),
    ("move down to the target", "fifth of"),
    ("place the block on the target", "parts"),
    ("none", "Is that right"),
    ("yes", "Are you ready"),
    ("yes", "FILE"),
    ("keys", "clutch"),
)


def introduced(home: Path) -> None:
    """Keep a session in which the task is told and the robot watches, as if it were killed."""
    opening = Opening(make_equipment, home, lambda line, text: None)
    session = open_session(opening, Transcript("a lesson", arm="kinematic"))
    for text, _ in TALK[:-1]:
        session.hear(text)
    session.close()


class Answering:
    """Sees what a terminal is told to draw, and tells where its cursor is when it is asked.

    What asks waits a second for an answer, at every line that is typed.
    """

    def __init__(self, terminal: pexpect.spawn, row: int) -> None:
        self._terminal, self._answer = terminal, f"\x1b[{row};1R"
        self._last = ""

    def write(self, text: str) -> None:
        whole = self._last + text
        for _ in range(whole.count(WHERE)):
            self._terminal.send(self._answer)
        # A question may come in two pieces; a whole one is not to be answered twice.
        self._last = "" if whole.endswith(WHERE) else whole[1 - len(WHERE) :]

    def flush(self) -> None:
        pass


class Teacher:
    """Someone at a keyboard who looks where the hand is."""

    def __init__(self, home: Path, *more: str, pace: float = 40.0, arm: str = "kinematic") -> None:
        self.home = home
        environment = {**os.environ, "ASSISTANT_HOME": str(home), "TERM": "xterm"}
        # The terminal is as large as it says, whatever these tests run in was told.
        environment = {k: v for k, v in environment.items() if k not in ("COLUMNS", "LINES")}
        flags = ("--arm", arm, "--pace", str(pace))
        self.terminal = pexpect.spawn(
            sys.executable,
            ["-m", "assistant", "teach", *flags, *more],
            env=environment,
            encoding="utf-8",
            timeout=60,
            dimensions=(40, 120),
        )
        self.terminal.delaybeforesend = None
        self.terminal.logfile_read = Answering(self.terminal, row=8)

    def say(self, text: str, then: str) -> None:
        self.terminal.send(f"{text}\r")
        self.terminal.expect(then)

    def prompted(self) -> None:
        """Wait until a line can be typed: what comes before may be dropped by Ctrl-C."""
        self.terminal.expect("you:|du:")

    def introduce(self) -> None:
        """Tell what the task is, until the hand is driven by keys."""
        self.terminal.expect("What is the task called")
        for text, then in TALK:
            self.say(text, then)

    def take_the_hand(self) -> None:
        """Drive the hand by keys, where the robot already watches."""
        self.prompted()
        self.say(*TALK[-1])

    def watch(self, for_s: float) -> None:
        """Look at the screen for so long; a program whose screen is not read stands still."""
        self.terminal.expect(pexpect.TIMEOUT, timeout=for_s)

    def until(self, happened: Callable[[], bool]) -> None:
        for _ in range(1000):
            if happened():
                return
            self.watch(REPEATED_S)
        raise AssertionError("it does not happen")

    def sample(self) -> Array:
        """Return the last whole row of the recording."""
        path = self.home / "sessions" / "1" / "recording_1.csv"
        while True:
            lines = path.read_bytes()[-1000:].split(b"\n") if path.exists() else []
            if len(lines) > 2:
                return np.array([float(text) for text in lines[-2].split(b",")])
            self.watch(REPEATED_S)

    @property
    def hand(self) -> Array:
        """The hand's pose as recorded last."""
        return np.array(self.sample()[1:8])

    def press(self, key: str) -> None:
        self.terminal.send(key)
        self.watch(REPEATED_S)

    def rest(self) -> Array:
        """Return the hand's pose once it rests by its own clock, however slow the machine is."""
        since = self.sample()
        while True:
            self.watch(REPEATED_S)
            now = self.sample()
            if not np.array_equal(now[1:8], since[1:8]):
                since = now
            elif now[0] - since[0] > RESTS_S:
                return np.array(now[1:8])

    def drive(self, goal: Array, axis: str, within: float = 0.001) -> None:
        """Tap a key as often as the hand has steps to go, and look where it is then."""
        k = "xyz".index(axis)
        for _ in range(40):
            gap = float(goal[k] - self.rest()[k])
            if abs(gap) < within:
                return
            key = KEYS[k][0 if gap > 0 else 1]
            for _ in range(int(abs(gap) / STEP_M) - 1):
                self.terminal.send(key)
            self.tap(key)
        raise AssertionError("the hand does not get there")

    def tap(self, key: str) -> None:
        """Press a key once and wait until the hand moves."""
        before = self.hand
        self.press(key)
        self.until(lambda: not np.array_equal(self.hand, before))

    def act(self, key: str, opening_m: float) -> None:
        """Open or close the hand."""
        self.press(key)
        self.until(lambda: abs(self.sample()[8] - opening_m) < 0.003)
