"""What a teacher says to lead the talk: answers, markers, questions, going back, keeping."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assistant.model.teacher_acts.words import Shown, Stage


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
