"""All that the teacher has taught; it is immutable, so undo and redo are two stacks of it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from assistant.dialogue.sketch import Sketch, to_tree
from assistant.model.demonstration import Demonstration
from assistant.model.lesson import Lesson
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Primitive, Subtask, Task, TaskObject

Facing = Literal["own", "facing"]


@dataclass(frozen=True, slots=True)
class Knowledge:
    """What the teacher has taught so far; None means: not asked yet.

    Parameters
    ----------
    facing : {"own", "facing"} or None
        Whether the teacher's directions are the robot's own or mirrored.
    unplaced : tuple of str
        Objects whose place the teacher leaves to the demonstration.
    shaped : tuple of str
        Objects whose shape and size the teacher told.
    learned_root : Sketch or None
        The tree that the lesson was learned with.
    declined : tuple of (asked, about)
        Questions of learning that were answered with no: they are not asked anew.
    language : str
        Which phrasebook the teacher's words are read with.
    """

    scene: Scene = field(default_factory=Scene)
    setup: Setup = field(default_factory=Setup)
    name: str = ""
    goal: str | None = None
    objects: tuple[TaskObject, ...] | None = None
    root: Sketch = field(default_factory=Sketch)
    tree_confirmed: bool = False
    unplaced: tuple[str, ...] = ()
    shaped: tuple[str, ...] = ()
    demonstrations: tuple[Demonstration, ...] = ()
    cuts_s: tuple[float, ...] | None = None
    assigned: tuple[tuple[int, str], ...] = ()
    lesson: Lesson | None = None
    learned_root: Sketch | None = None
    declined: tuple[tuple[str, str], ...] = ()
    reviewed: bool = False
    facing: Facing | None = None
    language: str = "english"

    @property
    def task(self) -> Task:
        """The task as known now; its tree may be incomplete."""
        tree = to_tree(self.root)
        if isinstance(tree, Primitive):
            tree = Subtask(self.name, ())
        return Task(self.name, tree, self.goal or "", self.objects or (), self.lesson)
