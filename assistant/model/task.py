"""The task tree a teacher introduces: subtasks, primitives, objects, conditions (paper II-A).

A primitive is named by its own text; names of primitives are unique in a tree, so that talk
and files can refer to them. Positions from the root are counted from 1.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Literal

from assistant.model.conditions import Condition
from assistant.model.lesson import Lesson

Role = Literal["object", "target"]
Order = Literal["sequential", "any"]
Verb = Literal["move", "turn", "hand", "free"]
Index = tuple[int, ...]

MOVES = ("approach", "depart", "to", "up", "down", "left", "right", "forward", "backward")
TURNS = (
    "left",
    "right",
    "up",
    "down",
    "forward",
    "backward",
    "clockwise",
    "counterclockwise",
)
HAND = ("open", "close")


@dataclass(frozen=True, slots=True)
class TaskObject:
    """A body the task is about: carried (`object`) or a place for one (`target`)."""

    name: str
    role: Role


@dataclass(frozen=True, slots=True)
class Action:
    """What a primitive does.

    Parameters
    ----------
    verb : {"move", "turn", "hand", "free"}
    way : str
        One of `MOVES`, `TURNS` or `HAND`; for ``free`` the teacher's own text.
    object : str, optional
        The object or target concerned.
    """

    verb: Verb
    way: str
    object: str | None = None


@dataclass(frozen=True, slots=True)
class Primitive:
    """A leaf of the tree: one motion or one command to the hand."""

    name: str
    action: Action
    before: tuple[Condition, ...] = ()
    until: tuple[Condition, ...] = ()
    optional: bool = False


@dataclass(frozen=True, slots=True)
class Subtask:
    """An inner node of the tree; its parts run in sequence or in any order."""

    name: str
    parts: tuple[Subtask | Primitive, ...] = ()
    goal: str = ""
    order: Order = "sequential"
    optional: bool = False


@dataclass(frozen=True, slots=True)
class Task:
    """A task as introduced and, once shown, as learned.

    Parameters
    ----------
    name : str
    tree : Subtask
        The root node.
    goal : str
    objects : tuple of TaskObject
    learned : Lesson, optional
        None until a demonstration has been learned from.
    """

    name: str
    tree: Subtask
    goal: str = ""
    objects: tuple[TaskObject, ...] = ()
    learned: Lesson | None = field(default=None, compare=False)

    def object(self, name: str) -> TaskObject | None:
        """Return the object of that name, or None."""
        return next((known for known in self.objects if known.name == name), None)


def walk(
    node: Subtask | Primitive, index: Index = ()
) -> Iterator[tuple[Index, Subtask | Primitive]]:
    """Yield every node below and including `node`, parents first, with its position."""
    yield index, node
    if isinstance(node, Subtask):
        for position, part in enumerate(node.parts, start=1):
            yield from walk(part, (*index, position))


def primitives(node: Subtask | Primitive) -> tuple[Primitive, ...]:
    """Return the leaves in the order told."""
    return tuple(part for _, part in walk(node) if isinstance(part, Primitive))
