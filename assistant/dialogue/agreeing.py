"""The robot and the teacher agree that a task is learned, or the robot says why not (III-D b)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from assistant.dialogue.asking import PRACTICE, ask, tell
from assistant.dialogue.keeping import save
from assistant.dialogue.runs import RunResult
from assistant.dialogue.state import Dialogue, Ready
from assistant.dialogue.turn import (
    Turn,
    first,
    line,
    say,
)
from assistant.model.robot_acts import About, RobotAct


def satisfied(dialogue: Dialogue) -> Turn:
    """Take the teacher's yes: on to normal speed, or to agreement."""
    known = About(dialogue.known.name)
    if dialogue.busy:
        return say(dialogue, line("told", "glad"))
    at_rest = replace(dialogue, arm="rest", state=Ready())
    if dialogue.pace == "slow" and dialogue.runs and not dialogue.agreed:
        return ask(replace(at_rest, pace="normal"))
    lacks = disagreement(dialogue)
    if lacks is not None:
        return tell(at_rest, lacks)
    agreed = replace(at_rest, agreed=True)
    told = line("done", "agreed", about=known, task=dialogue.known.name)
    if not agreed.unsaved and agreed.saved_as:
        return tell(agreed, told)
    return first(say(agreed, told)[1], save(agreed, None))


def disagreement(dialogue: Dialogue) -> RobotAct | None:
    """Return why the robot does not agree yet that the task is learned, or None if it does."""
    runs = dialogue.clean
    setups = len({_key(one) for one in runs})
    if setups >= PRACTICE.agreed_after:
        return None
    last = dialogue.runs[-1] if dialogue.runs else None
    if last is not None and last.missing:
        return line("explain", "not_perceived", missing=list(last.missing))
    wanted = PRACTICE.agreed_after
    return line("explain", "not_agreed", setups=setups, wanted=wanted, more=wanted - setups)


def _key(result: RunResult) -> tuple[Any, ...]:
    return (result.setup.robot_start, *sorted(result.setup.places.items(), key=lambda one: one[0]))
