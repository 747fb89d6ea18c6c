"""A session written down like a play, to be read, replayed as a test, or resumed from.

Every step carries the line of the file it stands on (0 when made in memory), so that a
failing replay can point there; lines take no part in comparing steps.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Literal

from assistant.model.demonstration import Spoken
from assistant.model.robot_acts import About
from assistant.model.setup import Setup

Times = Literal["one", "maybe", "any", "some"]
"""How many robot lines a step stands for: ``robot``, ``robot?``, ``robot*``, ``robot+``."""


@dataclass(frozen=True, slots=True)
class Note:
    """A remark for the reader; nothing happens."""

    text: str
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class TeacherLine:
    """The teacher says something.

    Parameters
    ----------
    says : str
        What was said.
    heard : str, optional
        What the recognizer made of it; None if the same.
    at_s : float, optional
        Seconds into the running motion at which it is said; None for the teacher's turn.
    by_voice : float, optional
        How surely it was heard, in [0, 1], where it was spoken; None if typed.
    """

    says: str
    heard: str | None = None
    at_s: float | None = None
    by_voice: float | None = None
    line: int = field(default=0, compare=False)

    @property
    def text(self) -> str:
        """The words that reach the robot."""
        return self.says if self.heard is None else self.heard


@dataclass(frozen=True, slots=True)
class RobotLine:
    """A line expected of the robot, matched by what is given and by nothing else.

    Parameters
    ----------
    times : {"one", "maybe", "any", "some"}
    act, asked, topic : str, optional
    slots : mapping
        Only those listed must agree; a value may be a `Near`.
    about : About, optional
        A bare text: the name alone must agree.
    words : str, optional
        The sentence itself, word for word.
    pattern : str, optional
        A regular expression found in the sentence.
    """

    times: Times = "one"
    act: str | None = None
    asked: str | None = None
    topic: str | None = None
    slots: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))
    about: About | str | None = None
    words: str | None = None
    pattern: str | None = None
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Wait:
    """Let simulated time pass: seconds, or None until the arm rests."""

    seconds: float | None
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Demonstrate:
    """The teacher shows the task: from a recording, or by the scripted hand.

    Parameters
    ----------
    recording : str, optional
        A CSV file, relative to the transcript; None for the scripted hand.
    seed : int
        Of the scripted hand.
    cues : tuple of Spoken, or None
        None: the scripted hand says its own (``cues: auto``).
    key_states : tuple of Spoken
    """

    recording: str | None = None
    seed: int = 0
    cues: tuple[Spoken, ...] | None = ()
    key_states: tuple[Spoken, ...] = ()
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class SetupChoice:
    """Which setup: by the name of a kept or shipped one, by a file, or told in full.

    Exactly one of `name`, `file` and `setup` is given; `file` is relative to the transcript.
    """

    name: str | None = None
    file: str | None = None
    setup: Setup | None = None


@dataclass(frozen=True, slots=True)
class SetupStep:
    """The things on the table are rearranged."""

    choice: SetupChoice
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Near:
    """A number that may differ by `within`, in its own unit."""

    near: float
    within: float


@dataclass(frozen=True, slots=True)
class Expect:
    """Values of the session's public view, by dotted path: plain values or `Near`."""

    values: Mapping[str, Any]
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Restart:
    """The program dies and starts again, knowing only what was flushed to disk."""

    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Happened:
    """What the arm, learning or a check answered; feeding it back computes and moves nothing."""

    result: Mapping[str, Any]
    line: int = field(default=0, compare=False)


Step = Note | TeacherLine | RobotLine | Wait | Demonstrate | SetupStep | Expect | Restart | Happened


@dataclass(frozen=True, slots=True)
class Transcript:
    """A whole session (transcript/1).

    Parameters
    ----------
    title : str
    setup : SetupChoice, optional
        Where things are at the beginning; None for the default.
    arm : str
        Which arm: ``pybullet`` or ``kinematic``.
    task : str, optional
        A task file to go on with, relative to the transcript.
    language : str
    steps : tuple of Step
    source : str
        The file it was read from; empty if made in memory.
    """

    title: str
    steps: tuple[Step, ...] = ()
    setup: SetupChoice | None = None
    arm: Literal["pybullet", "kinematic"] = "kinematic"
    task: str | None = None
    language: str = "english"
    source: str = field(default="", compare=False)
