"""What the dialogue wants done; the session does it and answers with events."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assistant.model.demonstration import Demonstration
from assistant.model.robot_acts import RobotAct
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task


@dataclass(frozen=True, slots=True)
class Say:
    """Tell the teacher something."""

    line: RobotAct


@dataclass(frozen=True, slots=True)
class Record:
    """Begin to watch the teacher's hand, from the start (answered by ``Shown``)."""


@dataclass(frozen=True, slots=True)
class EndRecording:
    """The demonstration is over (`keep`), or starts over (not `keep`)."""

    keep: bool = True


@dataclass(frozen=True, slots=True)
class Learn:
    """Learn a task from its demonstrations (answered by ``Learned``).

    Parameters
    ----------
    task : Task
    demonstrations : tuple of Demonstration
    cuts_s : tuple of float or None
        Cuts the teacher fixed by hand, one a boundary between episodes.
    assigned : tuple of (episode counted from 1, primitive name)
        Assignments the teacher fixed.
    """

    task: Task
    demonstrations: tuple[Demonstration, ...]
    cuts_s: tuple[float, ...] | None = None
    assigned: tuple[tuple[int, str], ...] = ()


@dataclass(frozen=True, slots=True)
class Replay:
    """Carry out the demonstration as it was shown, checked like any motion."""

    task: Task
    demonstration: Demonstration
    setup: Setup
    speed: float = 1.0


@dataclass(frozen=True, slots=True)
class Check:
    """Adapt the task to a setup and check it (answered by ``Checked``).

    Parameters
    ----------
    speed : float
        Factor of the demonstration's speed.
    anew : bool
        Only the rest of the run that was halted, from the measured pose, with what the task
        says now (it was corrected while paused). The ``Move`` that follows is `anew` too.
    """

    task: Task
    setup: Setup
    scene: Scene
    speed: float
    anew: bool = False


@dataclass(frozen=True, slots=True)
class Move:
    """Carry out what was checked last; always follows an accepted ``Checked``.

    Parameters
    ----------
    task : Task
    setup : Setup
    speed : float
        Factor of the demonstration's speed.
    pause_before_primitives : bool
        Wait for ``GoOn`` before each primitive (so that slow practice can announce).
    anew : bool
        What was checked is the rest of a halted run: nothing is put back, the arm goes on
        from where it is.
    """

    task: Task
    setup: Setup
    speed: float
    pause_before_primitives: bool = False
    anew: bool = False


@dataclass(frozen=True, slots=True)
class GoOn:
    """Continue after an announcement, or (`anew`) after a pause or stop.

    With `anew` the rest of the halted run is planned from the measured pose and checked; if it
    cannot be done, ``Checked`` with a refusal answers and nothing moves.
    """

    anew: bool = False


@dataclass(frozen=True, slots=True)
class Halt:
    """Stop or pause the arm."""

    why: Literal["stop", "pause"]


@dataclass(frozen=True, slots=True)
class SetHand:
    """Open or close the hand at rest."""

    command: Literal["open", "close"]


@dataclass(frozen=True, slots=True)
class Jog:
    """Move the hand by a small checked step at rest, in m and rad, base frame."""

    offset_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    turn_rad: tuple[float, float, float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Home:
    """Bring the hand back to where a setup has it start, checked like any motion."""

    setup: Setup


@dataclass(frozen=True, slots=True)
class Arrange:
    """Put the things where a setup says; `random` asks the session for a new setup."""

    setup: Setup | None
    scene: Scene | None = None
    random: bool = False


@dataclass(frozen=True, slots=True)
class Keep:
    """Save a task (answered by ``Kept``)."""

    task: Task
    name: str
    overwrite: bool = False


@dataclass(frozen=True, slots=True)
class Load:
    """Read a kept task (answered by ``Loaded``)."""

    name: str


@dataclass(frozen=True, slots=True)
class Discard:
    """Delete a kept task (answered by ``Kept`` with `discarded`)."""

    name: str


@dataclass(frozen=True, slots=True)
class WriteDown:
    """Write a record of a task that people can read (answered by ``Kept`` with `record`)."""

    task: Task
    name: str


@dataclass(frozen=True, slots=True)
class Leave:
    """End the session."""


Effect = (
    Say
    | Record
    | EndRecording
    | Learn
    | Replay
    | Check
    | Move
    | GoOn
    | Halt
    | SetHand
    | Jog
    | Home
    | Arrange
    | Keep
    | Load
    | Discard
    | WriteDown
    | Leave
)

__all__ = [
    "Arrange",
    "Check",
    "Discard",
    "Effect",
    "EndRecording",
    "GoOn",
    "Halt",
    "Home",
    "Jog",
    "Keep",
    "Learn",
    "Leave",
    "Load",
    "Move",
    "Record",
    "Replay",
    "Say",
    "SetHand",
    "WriteDown",
]
