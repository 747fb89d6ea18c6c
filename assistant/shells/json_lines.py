"""A program as the teacher: one JSON line in, JSON lines out; time passes only when told.

A line that is a JSON object is a step (``demonstrate``, ``setup``, ``wait``); any other line is
an utterance. After every line handled, ``{"ready": true, "moving": ...}`` follows.
"""

from __future__ import annotations

import json
import queue
import threading
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from assistant.errors import BadInput, WorkFailed
from assistant.model.robot_acts import RobotAct
from assistant.model.teacher_acts import Stage
from assistant.model.transcript import Demonstrate, SetupStep, Step, Wait
from assistant.session import halting
from assistant.session.acting import demonstrate, leave, one_step, wait
from assistant.session.loop import Session
from assistant.session.opening import chosen
from assistant.session.saying import as_json

KINDS = ("demonstrate", "setup", "wait")
STEPS = '{"demonstrate": ...}, {"setup": ...} or {"wait": seconds or "rest"}'


class JsonShell:
    """Speaks JSON lines.

    Parameters
    ----------
    write : callable
        Takes one line of output, without its line break.
    """

    def __init__(self, write: Callable[[str], None]) -> None:
        self._write = write
        self._session: Session | None = None
        self._lines: queue.Queue[str | None] = queue.Queue()
        self._broken = False

    def attach(self, session: Session) -> None:
        """Take note of the session whose lines are told."""
        self._session = session

    def out(self, line: RobotAct, text: str) -> None:
        """Tell a robot line."""
        stage: Stage = "introduction" if self._session is None else self._session.listening.stage
        self._tell(as_json(line, text, stage))

    def run(self, session: Session, lines: Iterable[str]) -> None:
        """Hold the conversation until the robot leaves or the input ends."""
        self.attach(session)
        session.in_touch = lambda: not self._broken
        threading.Thread(target=self._read, args=(session, lines), daemon=True).start()
        self._ready(session)
        while not session.left:
            line = self._lines.get()
            if line is None:
                leave(session, halting.HEARTBEAT if self._broken else halting.NOBODY)
                return
            self._take(session, line)
            if not session.left:
                self._ready(session)

    def _read(self, session: Session, lines: Iterable[str]) -> None:
        # Read beside the conversation, so that a stop word is seen while time passes.
        try:
            for line in lines:
                if self._lines.empty():
                    session.raw(line)
                self._lines.put(line.strip())
        except (OSError, ValueError):
            # An input that breaks, other than one that ends, can take no stop any more.
            self._broken = True
        finally:
            self._lines.put(None)

    def _take(self, session: Session, line: str) -> None:
        if not line:
            return
        try:
            if line.startswith("{"):
                self._act(session, step_of(line))
            else:
                session.hear(line)
        except (BadInput, WorkFailed) as error:
            asked = session.listening.asked
            self.out(RobotAct("error", "step", asked), str(error))

    def _act(self, session: Session, step: Step) -> None:
        match step:
            case Demonstrate():
                demonstrate(session, step, Path())
            case SetupStep():
                session.arrange(*chosen(step.choice, Path()))
            case Wait():
                wait(session, step)
            case _:
                raise BadInput.one("step", "not a step for a program", STEPS)

    def _ready(self, session: Session) -> None:
        self._tell({"ready": True, "moving": session.moving})

    def _tell(self, told: dict[str, Any]) -> None:
        self._write(json.dumps(told, ensure_ascii=False))


def step_of(line: str) -> Step:
    """Return the step a JSON object stands for.

    Raises
    ------
    BadInput
        If it is no JSON, or no step.
    """
    try:
        told = json.loads(line)
    except json.JSONDecodeError as error:
        raise BadInput.one("input", f"not JSON: {error}", f"a step: {STEPS}") from error
    if not isinstance(told, dict) or len(told) != 1 or next(iter(told)) not in KINDS:
        raise BadInput.one("input", f"{line[:60]!r} is not a step", f"one of {STEPS}")
    return one_step(told)
