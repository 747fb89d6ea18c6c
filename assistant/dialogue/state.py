"""Where the dialogue stands: what is being asked, what the arm is doing, what was said last."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.runs import Pace, Run, RunResult
from assistant.model.lesson import Question
from assistant.model.motion import Refusal
from assistant.model.robot_acts import RobotAct
from assistant.model.task import Index
from assistant.model.teacher_acts import Asked, TeacherAct

Arm = Literal["rest", "checking", "moving", "paused", "stopped", "homing"]
"""``homing``: on the way back to where an arrangement has the hand start; no run is under way."""
After = tuple[Literal["", "fresh", "load"], str]
"""What follows once unsaved work is seen to: another task, or a kept one by its name."""


@dataclass(frozen=True, slots=True)
class Opening:
    """Before the session is open."""


@dataclass(frozen=True, slots=True)
class Introducing:
    """A question about the task is open.

    Parameters
    ----------
    asked : str
    index : Index
        The node concerned.
    thing : str
        The object concerned, for ``body`` and ``pose``.
    named : tuple of str
        For a contradiction: the steps named, more than had been said.
    said : int
        For a contradiction: how many had been said.
    """

    asked: Asked
    index: Index = ()
    thing: str = ""
    named: tuple[str, ...] = ()
    said: int = 0


@dataclass(frozen=True, slots=True)
class AwaitingShow:
    """The teacher is to say when the demonstration begins.

    Parameters
    ----------
    step : str
        The one step that is to be shown again; empty for the whole task.
    """

    step: str = ""


@dataclass(frozen=True, slots=True)
class Watching:
    """The teacher's hand is being recorded; `ending` once the end was asked for.

    Parameters
    ----------
    ending : str
    step : str
        As in `AwaitingShow`.
    """

    ending: Literal["", "learn", "ask"] = ""
    step: str = ""


@dataclass(frozen=True, slots=True)
class Thinking:
    """Learning is under way."""


@dataclass(frozen=True, slots=True)
class Reviewing:
    """What was learned is being gone through; the first question is open."""

    questions: tuple[Question, ...] = ()


@dataclass(frozen=True, slots=True)
class Ready:
    """At rest in practice, waiting for a start."""


@dataclass(frozen=True, slots=True)
class Running:
    """The arm carries out a setup, is being checked for it, or was halted on the way."""


@dataclass(frozen=True, slots=True)
class Ran:
    """A run is over; the teacher is to say whether it was right."""


@dataclass(frozen=True, slots=True)
class Closed:
    """The session is over."""


State = (
    Opening
    | Introducing
    | AwaitingShow
    | Watching
    | Thinking
    | Reviewing
    | Ready
    | Running
    | Ran
    | Closed
)


@dataclass(frozen=True, slots=True)
class Pending:
    """A question in between: what happens on yes, and on no.

    Parameters
    ----------
    asked : str
    line : RobotAct
        The question, to be repeated.
    acts : tuple of TeacherAct
        What the teacher is taken to want, done on yes (for ``facing``: after the answer).
    words : str
        The teacher's own words.
    keep_name : str
        For overwriting: the name to save under.
    leave : bool
        For ``unsaved``: leave after the answer.
    after : tuple
        For ``unsaved``: what else follows the answer.
    other : tuple of TeacherAct
        For a guess: what the teacher means if not that.
    over : Pending or None
        For a guess: the question that the words may have answered; open again after it.
    """

    asked: Asked
    line: RobotAct
    acts: tuple[TeacherAct, ...] = ()
    words: str = ""
    keep_name: str = ""
    leave: bool = False
    after: After = ("", "")
    other: tuple[TeacherAct, ...] = ()
    over: Pending | None = None


@dataclass(frozen=True, slots=True)
class Change:
    """A snapshot to go back to, with what was changed after it.

    Parameters
    ----------
    known : Knowledge
    label : str
    questions : tuple of Question
        Of learning, those that were open then.
    """

    known: Knowledge
    label: str
    questions: tuple[Question, ...] = ()


@dataclass(frozen=True, slots=True)
class Other:
    """What would have been done with the other of two candidates.

    Parameters
    ----------
    acts : tuple of TeacherAct
        Empty where there are not just two.
    done : TeacherAct or None
        What was done; it may be done at another step or with another thing.
    words : str
    depth : int
        How many changes had been made before the first candidate was taken.
    """

    acts: tuple[TeacherAct, ...]
    words: str
    depth: int
    done: TeacherAct | None = None


@dataclass(frozen=True, slots=True)
class Dialogue:
    """The whole dialogue between two events.

    Parameters
    ----------
    known : Knowledge
    state : State
    pending : Pending or None
        A question in between; the state's own question waits.
    arm : str
    run : Run or None
        The present or last one.
    runs : tuple of RunResult
        All since the session began.
    clean : tuple of RunResult
        Those in a row, uncorrected, since the last change.
    past, future : tuples of Change
        Undo and redo.
    said : tuple of RobotAct
        The robot's last turn, for "what did you say?".
    halt : RobotAct or None
        Why the arm was stopped the last time, as it was told.
    other : Other or None
        For "no, I meant the other one"; forgotten with the next words.
    misses : int
        Times in a row that the teacher was not understood.
    """

    known: Knowledge = field(default_factory=Knowledge)
    state: State = field(default_factory=Opening)
    pending: Pending | None = None
    arm: Arm = "rest"
    pace: Pace = "slow"
    run: Run | None = None
    runs: tuple[RunResult, ...] = ()
    clean: tuple[RunResult, ...] = ()
    refusal: Refusal | None = None
    past: tuple[Change, ...] = ()
    future: tuple[Change, ...] = ()
    said: tuple[RobotAct, ...] = ()
    halt: RobotAct | None = None
    other: Other | None = None
    misses: int = 0
    brief: bool = False
    saved: tuple[str, ...] = ()
    saved_as: str = ""
    unsaved: bool = False
    agreed: bool = False
    leaving: bool = False
    after: After = ("", "")
    comparing: bool = False

    @property
    def language(self) -> str:
        """Which phrasebook the teacher's words are read with."""
        return self.known.language

    @property
    def busy(self) -> bool:
        """Whether the arm moves or is about to; a look ahead of a run does not count."""
        looking = self.run is not None and self.run.purpose in ("look", "dry")
        return self.in_motion or (self.arm == "checking" and not looking)

    @property
    def in_motion(self) -> bool:
        """Whether the arm moves, in a run or on its way back."""
        return self.arm in ("moving", "homing")

    @property
    def can_halt(self) -> bool:
        """Whether there is anything that a stop would end."""
        return self.in_motion or self.arm in ("checking", "paused")
