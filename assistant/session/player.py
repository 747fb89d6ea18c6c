"""Plays a transcript: does what its teacher does and compares what the robot says and finds.

Time passes only in ``wait``, ``demonstrate`` and a teacher's line with ``at_s``. A journal
(a transcript with ``happened`` steps) is played by feeding these back: nothing is computed
or moved then, the dialogue alone is tested.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import assert_never

from assistant.errors import AssistantError
from assistant.files.transcripts import write_transcript
from assistant.model.robot_acts import RobotAct
from assistant.model.transcript import (
    Demonstrate,
    Expect,
    Happened,
    Note,
    Restart,
    RobotLine,
    SetupStep,
    Step,
    TeacherLine,
    Transcript,
    Wait,
)
from assistant.session.acting import demonstrate, wait
from assistant.session.equipment import EquipmentMaker
from assistant.session.happenings import from_happened
from assistant.session.matching import Difference, Said, account, difference, look_up
from assistant.session.opening import Opening, chosen, open_session, reopen_session
from assistant.session.saying import as_step

Listener = Callable[[str, str], None]
"""Told who speaks (``teacher`` or ``robot``) and the words, as the play goes on."""


def silent(who: str, words: str) -> None:
    """Listen to nothing."""


@dataclass(frozen=True, slots=True)
class Played:
    """How a transcript went.

    Parameters
    ----------
    difference : Difference or None
        None if everything was as expected.
    actual : Transcript
        What really happened, up to the difference.
    """

    difference: Difference | None
    actual: Transcript


class _Differs(Exception):
    def __init__(self, difference: Difference) -> None:
        super().__init__(difference.why)
        self.difference = difference


class Player:
    """One play of one transcript.

    Parameters
    ----------
    transcript : Transcript
    equipment : callable
        Makes the equipment for the transcript's arm.
    folder : Path
        Where the play's own journal and kept tasks go.
    listener : callable, optional
    """

    def __init__(
        self,
        transcript: Transcript,
        equipment: EquipmentMaker,
        folder: Path,
        listener: Listener = silent,
    ) -> None:
        self.transcript = transcript
        self.base = Path(transcript.source).parent
        self.listener = listener
        self.fed = any(isinstance(step, Happened) for step in transcript.steps)
        self._expected: list[RobotLine] = []
        self._said: list[Said] = []
        self._actual: list[Step] = []
        self.opening = Opening(equipment, folder, self._hear_robot)
        self.session = open_session(self.opening, transcript, fed=self.fed)

    def play(self) -> Played:
        """Play to the end or to the first difference."""
        difference: Difference | None = None
        try:
            for step in self.transcript.steps:
                self._do(step)
            self._settle(self._last_line())
        except _Differs as found:
            difference = found.difference
            self._actual.append(Note(f"the play ended here: {difference.why}"))
        finally:
            self.session.close()
        actual = replace(self.transcript, steps=tuple(self._actual))
        return Played(difference, actual)

    def _hear_robot(self, line: RobotAct, text: str) -> None:
        self._said.append(Said(line, text))
        self._actual.append(as_step(line, text))
        self.listener("robot", text)

    def _do(self, step: Step) -> None:
        if isinstance(step, RobotLine):
            self._expected.append(step)
            return
        if isinstance(step, Note):
            self._actual.append(step)
            return
        if isinstance(step, Expect):
            self._compare(step)
            return
        self._settle(step.line)
        self._actual.append(step)
        try:
            self._act(step)
        except AssistantError as error:
            if self._actual[-1] is step:
                # It was not done, and nothing was said of it.
                self._actual.pop()
            raise _Differs(Difference(step.line, str(error))) from error

    def _act(self, step: TeacherLine | Wait | Demonstrate | SetupStep | Restart | Happened) -> None:
        match step:
            case TeacherLine():
                self._say(step)
            case Wait():
                wait(self.session, step)
            case Demonstrate():
                demonstrate(self.session, step, self.base)
            case SetupStep():
                self.session.arrange(*chosen(step.choice, self.base))
            case Restart():
                self.session = reopen_session(self.opening, self.session)
            case Happened():
                self.session.happen(from_happened(step.result, self.base))
            case _:
                assert_never(step)

    def _say(self, step: TeacherLine) -> None:
        if step.at_s is not None and not self.fed:
            self.session.run_until(step.at_s)
        self.listener("teacher", step.says)
        if step.by_voice is None:
            self.session.hear(step.text)
        else:
            self.session.hear(step.text, by_voice=True, sure=step.by_voice)

    def _settle(self, line: int) -> None:
        """Compare the robot lines expected so far with those said."""
        found = account(self._expected, self._said, line)
        self._expected, self._said = [], []
        if found is not None:
            raise _Differs(found)

    def _compare(self, step: Expect) -> None:
        view = {**self.session.dialogue_view, "arm": self.session.mover.view()}
        real = {path: look_up(view, path) for path in step.values}
        told = {path: difference(value, real[path]) for path, value in step.values.items()}
        found = {path: real[path] if why else step.values[path] for path, why in told.items()}
        self._actual.append(Expect(found, step.line))
        for path, why in told.items():
            if why:
                raise _Differs(Difference(step.line, f"{path}: {why}"))

    def _last_line(self) -> int:
        return max((step.line for step in self.transcript.steps), default=1)


def actual_path(source: Path) -> Path:
    """Return where a failing play writes what really happened."""
    return source.with_name(f"{source.stem}.actual.yaml")


def write_actual(played: Played) -> Path:
    """Write what really happened beside the transcript and return where."""
    path = actual_path(Path(played.actual.source))
    write_transcript(played.actual, path)
    return path
