"""What understanding a sentence depends on, and what it results in."""

from __future__ import annotations

from dataclasses import dataclass

from assistant.model.teacher_acts import Asked, Stage, TeacherAct


@dataclass(frozen=True, slots=True)
class Listening:
    """Where the dialogue stands when words are heard.

    Parameters
    ----------
    stage : str
    asked : str or None
        What the robot just asked.
    moving : bool
        Whether the arm moves: any stop word then means stop.
    task : str
        The task's name; empty if none is known yet.
    objects : tuple of str
        Names of known objects and targets.
    subtasks : tuple of str
        Names of all nodes below the root, in the order told.
    """

    stage: Stage = "introduction"
    asked: Asked | None = None
    moving: bool = False
    task: str = ""
    objects: tuple[str, ...] = ()
    subtasks: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Understanding:
    """What a sentence means, with a calibrated probability that this is right.

    Parameters
    ----------
    acts : tuple of TeacherAct
        Never empty; a sentence that means nothing here is ``(Unknown(),)``.
    confidence : float
        In [0, 1].
    heard : str
        The line as it was given, nothing repaired in it.
    """

    acts: tuple[TeacherAct, ...]
    confidence: float
    heard: str
