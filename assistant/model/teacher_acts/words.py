"""Words that slots are made of: degrees, directions, stages, questions, places in a task."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

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
