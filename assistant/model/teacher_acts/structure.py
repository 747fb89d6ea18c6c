"""What a teacher says about the tree and about what was cut and assigned."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


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
