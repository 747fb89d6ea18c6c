"""What a teacher means: one frozen class an act, with its slots.

`act_to_json` and `act_from_json` turn acts into the mappings that files and programs read:
the act's name is the class's in snake case, absent slots are left out.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, Literal, get_args

from assistant.errors import BadInput
from assistant.model.feedback import When

Degree = Literal["little", "much"]
MoveDirection = Literal["left", "right", "up", "down", "forward", "backward"]
TurnDirection = Literal[
    "left", "right", "up", "down", "forward", "backward", "clockwise", "counterclockwise"
]
Stage = Literal["introduction", "demonstration", "learning", "practice"]
Asked = Literal[
    "task_name",
    "goal",
    "subtask_count",
    "subtask_name",
    "objects",
    "actions",
    "optional",
    "order",
    "confirm_tree",
    "confirm_segmentation",
    "ready",
    "satisfied",
    "pose",
    "missing_step",
    "did_you_mean",
    "which",
    "unsaved",
    "body",
    "facing",
]
Shown = Literal[
    "tree",
    "segmentation",
    "trajectory",
    "plan",
    "setup",
    "conditions",
    "corrections",
    "lessons",
]
STAGES: tuple[Stage, ...] = get_args(Stage)
ASKED: tuple[Asked, ...] = get_args(Asked)


@dataclass(frozen=True, slots=True)
class Where:
    """The part of the task a correction belongs to."""

    subtask: str
    when: When = "during"


@dataclass(frozen=True, slots=True)
class Inform:
    """The answer to the question the robot asked."""

    value: str | int | tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Affirm:
    """Yes."""


@dataclass(frozen=True, slots=True)
class Deny:
    """No."""


@dataclass(frozen=True, slots=True)
class Cue:
    """An organisational marker while demonstrating: "first step", "then"."""

    which: Literal["first", "next", "last"] | int


@dataclass(frozen=True, slots=True)
class KeyState:
    """The teacher calls attention to a change of a key state."""

    text: str


@dataclass(frozen=True, slots=True)
class AdjustSpeed:
    """Faster or slower, by a degree or to a factor of the present speed."""

    change: Literal["faster", "slower"] | None = None
    degree: Degree | None = None
    factor: float | None = None
    where: Where | None = None


@dataclass(frozen=True, slots=True)
class Translate:
    """Move the place of the hand, in the teacher's directions."""

    direction: MoveDirection
    degree: Degree | None = None
    distance_m: float | None = None
    where: Where | None = None


@dataclass(frozen=True, slots=True)
class Rotate:
    """Turn the hand, in the teacher's directions."""

    direction: TurnDirection
    degree: Degree | None = None
    angle_deg: float | None = None
    where: Where | None = None


@dataclass(frozen=True, slots=True)
class Gripper:
    """Open or close the hand."""

    command: Literal["open", "close"]
    where: Where | None = None


@dataclass(frozen=True, slots=True)
class Start:
    """Begin, or go on after a stop."""


@dataclass(frozen=True, slots=True)
class Pause:
    """Halt and keep what was planned."""


@dataclass(frozen=True, slots=True)
class Resume:
    """Go on after a pause."""


@dataclass(frozen=True, slots=True)
class Stop:
    """Halt at once, whatever is going on."""


@dataclass(frozen=True, slots=True)
class Again:
    """Do the practice once more with the same setup."""


@dataclass(frozen=True, slots=True)
class Approve:
    """The teacher is content; while demonstrating, the demonstration is over."""


@dataclass(frozen=True, slots=True)
class GoBack:
    """Return to an earlier stage with everything kept."""

    stage: Stage


@dataclass(frozen=True, slots=True)
class Undo:
    """Take the last change back."""


@dataclass(frozen=True, slots=True)
class Redo:
    """Bring the change taken back again."""


@dataclass(frozen=True, slots=True)
class AdjustLast:
    """Change the last correction, where the sentence names no direction."""

    change: Literal["more", "less", "opposite"] | None = None
    degree: Degree | None = None
    factor: float | None = None


@dataclass(frozen=True, slots=True)
class RepeatLine:
    """Say that again."""


@dataclass(frozen=True, slots=True)
class Help:
    """Ask what can be said now."""


@dataclass(frozen=True, slots=True)
class Show:
    """Show what is known."""

    what: Shown


@dataclass(frozen=True, slots=True)
class Explain:
    """A why or how question."""

    text: str


@dataclass(frozen=True, slots=True)
class Rename:
    """Give a node another name."""

    old: str
    new: str


@dataclass(frozen=True, slots=True)
class Optional:
    """A subtask may be skipped."""

    subtask: str


@dataclass(frozen=True, slots=True)
class Required:
    """A subtask may not be skipped."""

    subtask: str


@dataclass(frozen=True, slots=True)
class Unordered:
    """These may run in any order; none named means all parts of the node in question."""

    subtasks: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Ordered:
    """One must come before the other."""

    first: str
    second: str


@dataclass(frozen=True, slots=True)
class AddSubtask:
    """A step that was left out."""

    name: str
    after: str | None = None
    before: str | None = None


@dataclass(frozen=True, slots=True)
class RemoveSubtask:
    """A step that does not belong."""

    subtask: str


@dataclass(frozen=True, slots=True)
class Merge:
    """These are one step."""

    subtasks: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Split:
    """A step that is more than one."""

    subtask: str


@dataclass(frozen=True, slots=True)
class MoveCut:
    """The cut that ends a subtask lies elsewhere."""

    subtask: str
    at_s: float | None = None
    direction: Literal["earlier", "later"] | None = None


@dataclass(frozen=True, slots=True)
class Assign:
    """An episode, counted from 1, belongs to a subtask."""

    episode: int
    subtask: str


@dataclass(frozen=True, slots=True)
class SetPose:
    """Where a body is, in mm and degrees; `by_mm` is relative to where it was."""

    object: str
    position_mm: tuple[float, float, float] | None = None
    rpy_deg: tuple[float, float, float] | None = None
    by_mm: tuple[float, float, float] | None = None


@dataclass(frozen=True, slots=True)
class NewSetup:
    """Try another arrangement."""


@dataclass(frozen=True, slots=True)
class BeBrief:
    """Say less."""


@dataclass(frozen=True, slots=True)
class BeThorough:
    """Explain more."""


@dataclass(frozen=True, slots=True)
class Save:
    """Keep the task, under a name of its own if given."""

    name: str | None = None


@dataclass(frozen=True, slots=True)
class Load:
    """Bring a kept task."""

    name: str | None = None


@dataclass(frozen=True, slots=True)
class Compare:
    """Compare with a kept version."""

    name: str | None = None


@dataclass(frozen=True, slots=True)
class Quit:
    """Leave."""


@dataclass(frozen=True, slots=True)
class Unknown:
    """Nothing the assistant is for."""


TeacherAct = (
    Inform
    | Affirm
    | Deny
    | Cue
    | KeyState
    | AdjustSpeed
    | Translate
    | Rotate
    | Gripper
    | Start
    | Pause
    | Resume
    | Stop
    | Again
    | Approve
    | GoBack
    | Undo
    | Redo
    | AdjustLast
    | RepeatLine
    | Help
    | Show
    | Explain
    | Rename
    | Optional
    | Required
    | Unordered
    | Ordered
    | AddSubtask
    | RemoveSubtask
    | Merge
    | Split
    | MoveCut
    | Assign
    | SetPose
    | NewSetup
    | BeBrief
    | BeThorough
    | Save
    | Load
    | Compare
    | Quit
    | Unknown
)


def act_name(act: TeacherAct | type[TeacherAct]) -> str:
    """Return the act's name in files and programs, such as ``adjust_speed``."""
    name = (act if isinstance(act, type) else type(act)).__name__
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


ACTS: Mapping[str, type[TeacherAct]] = {act_name(kind): kind for kind in get_args(TeacherAct)}


def act_to_json(act: TeacherAct) -> dict[str, Any]:
    """Return the act as a mapping, absent slots left out, tuples as lists."""
    slots = {field.name: getattr(act, field.name) for field in fields(act)}
    told = {name: _plain(value) for name, value in slots.items() if value is not None}
    return {"act": act_name(act), **told}


def act_from_json(mapping: Mapping[str, Any]) -> TeacherAct:
    """Return the act a mapping stands for.

    Raises
    ------
    BadInput
        If the act or one of its slots is not known, or a slot is missing.
    """
    slots = dict(mapping)
    name = slots.pop("act", None)
    kind = ACTS.get(str(name))
    if kind is None:
        raise BadInput.one("act", f"unknown act {name!r}", f"one of {', '.join(sorted(ACTS))}")
    if isinstance(slots.get("where"), Mapping):
        slots["where"] = Where(**slots["where"])
    try:
        return kind(**{key: _frozen(value) for key, value in slots.items()})
    except TypeError as error:
        known = ", ".join(field.name for field in fields(kind)) or "none"
        raise BadInput.one("act", f"wrong slots for {name}", f"its slots are: {known}") from error


def _plain(value: Any) -> Any:
    if isinstance(value, Where):
        return {"subtask": value.subtask, "when": value.when}
    return list(value) if isinstance(value, tuple) else value


def _frozen(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value
