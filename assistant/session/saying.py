"""A robot line as a transcript step and as what programs read."""

from __future__ import annotations

from types import MappingProxyType
from typing import Any

from assistant.model.robot_acts import RobotAct
from assistant.model.teacher_acts import Stage
from assistant.model.transcript import RobotLine


def not_kept(trouble: str) -> RobotAct:
    """Return the line that tells that a session cannot be written down."""
    return RobotAct("error", "not_kept", slots=MappingProxyType({"reason": trouble}))


def as_step(line: RobotAct, text: str) -> RobotLine:
    """Return the step that stands for a line in journals and in what a play wrote down."""
    return RobotLine(act=line.act, asked=line.asked, topic=line.topic, about=line.about, words=text)


def as_json(line: RobotAct, text: str, stage: Stage) -> dict[str, Any]:
    """Return the mapping a program reads for a line."""
    about = None
    if line.about is not None:
        about = {"name": line.about.name, "index": list(line.about.index)}
    return {
        "act": line.act,
        "asked": line.asked,
        "about": about,
        "text": text,
        "stage": stage,
        "topic": line.topic,
    }
