"""What happens to the dialogue: words, results of learning and checks, reports of the arm.

Events carry values only; nothing here knows a clock, a file or a robot.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from assistant.model.demonstration import Demonstration
from assistant.model.lesson import Lesson
from assistant.model.listening import Understanding
from assistant.model.motion import ArmReport, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task


@dataclass(frozen=True, slots=True)
class Begun:
    """The session is open: the robot may greet.

    Parameters
    ----------
    scene : Scene
    setup : Setup
    task : Task, optional
        To continue teaching.
    saved : tuple of str
        Names of tasks already learned.
    saved_as : str
        The name that the task is kept under; empty if it comes from elsewhere.
    """

    scene: Scene
    setup: Setup
    task: Task | None = None
    saved: tuple[str, ...] = ()
    saved_as: str = ""


@dataclass(frozen=True, slots=True)
class Heard:
    """The teacher said something; `text` is as typed or recognized.

    Parameters
    ----------
    text : str
    understanding : Understanding
    by_voice : bool
    sure : float
        How surely it was recognized, in [0, 1]; the understanding counts it already.
    ago_s : float
        How long ago its first word began: recognizing takes its time.
    """

    text: str
    understanding: Understanding
    by_voice: bool = False
    sure: float = 1.0
    ago_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Shown:
    """A demonstration is over and recorded, or was given up with a reason."""

    demonstration: Demonstration | None
    why_not: str = ""


@dataclass(frozen=True, slots=True)
class Learned:
    """Learning ended: with a lesson, or with the reason why nothing was learned.

    Parameters
    ----------
    lesson : Lesson or None
    why_not : str
        A key such as ``never_closed``, ``too_short``, ``holding_at_end``.
    facts : mapping
        What a sentence about it needs.
    """

    lesson: Lesson | None
    why_not: str = ""
    facts: Mapping[str, object] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True, slots=True)
class Checked:
    """A setup was checked before moving: `refusal` None means the run can begin."""

    setup: Setup
    refusal: Refusal | None
    duration_s: float = 0.0
    note: str = ""


@dataclass(frozen=True, slots=True)
class ArmReported:
    """The arm tells how its motion goes."""

    report: ArmReport


@dataclass(frozen=True, slots=True)
class Halted:
    """Motion was stopped outside the dialogue: a stop word, a key, a closed window."""

    why: str


@dataclass(frozen=True, slots=True)
class Arranged:
    """A setup was given by file or step; the things on the table were put there."""

    setup: Setup
    scene: Scene


@dataclass(frozen=True, slots=True)
class Kept:
    """A task was saved, deleted or written down, or could not be, with the reason.

    Parameters
    ----------
    name : str
    why_not : str
    discarded : bool
        It was to be deleted.
    record : str or None
        It was to be written down; where it is to be read.
    """

    name: str
    why_not: str = ""
    discarded: bool = False
    record: str | None = None


@dataclass(frozen=True, slots=True)
class Loaded:
    """A kept task was read, or could not be."""

    name: str
    task: Task | None
    why_not: str = ""


@dataclass(frozen=True, slots=True)
class Ticked:
    """Simulated time passed."""

    now_s: float


Event = (
    Begun
    | Heard
    | Shown
    | Learned
    | Checked
    | ArmReported
    | Halted
    | Arranged
    | Kept
    | Loaded
    | Ticked
)
