"""What the robot says, by meaning; words are made from it by the phrasebook."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Literal

from assistant.model.task import Index
from assistant.model.teacher_acts import Asked

RobotActName = Literal[
    "greet",
    "ask",
    "read_back",
    "confirm",
    "report",
    "announce",
    "perceived",
    "done",
    "refuse",
    "stopped",
    "explain",
    "help",
    "told",
    "error",
]


@dataclass(frozen=True, slots=True)
class About:
    """The node of the tree a line concerns; index () is the task itself."""

    name: str
    index: Index = ()


@dataclass(frozen=True, slots=True)
class RobotAct:
    """One line of the robot.

    Parameters
    ----------
    act : str
        One of `RobotActName`.
    topic : str
        Which sentence of the phrasebook: ``says.<act>.<topic>``.
    asked : str, optional
        For ``ask`` and ``confirm``.
    about : About, optional
    slots : mapping
        What the sentence needs: names, numbers, lists.
    """

    act: RobotActName
    topic: str
    asked: Asked | None = None
    about: About | None = None
    slots: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))
