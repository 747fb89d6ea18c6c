"""What the robot is doing, will do next, and why it stands still or goes at its pace."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from assistant.dialogue.asking import PRACTICE, question, stage
from assistant.dialogue.correcting import speed_of
from assistant.dialogue.doubting import without_guess
from assistant.dialogue.state import Dialogue, Ready, Thinking
from assistant.dialogue.turn import line, plain_action
from assistant.model.robot_acts import RobotAct
from assistant.model.task import primitives


def doing_now(dialogue: Dialogue) -> RobotAct:
    """Tell which step the arm is at; at rest, what the robot waits for."""
    leaves = primitives(dialogue.known.task.tree)
    run = dialogue.run
    if dialogue.arm == "homing":
        return line("explain", "now_homing")
    if isinstance(dialogue.state, Thinking):
        return line("explain", "now_thinking")
    resting = dialogue.arm == "rest" or run is None or not 0 <= run.primitive_at < len(leaves)
    if resting or run is None:
        checking = dialogue.arm == "checking"
        topic = "now_checking" if checking else f"now_rest.{_open_question(dialogue)}"
        return line("explain", topic)
    leaf = leaves[run.primitive_at]
    slots: dict[str, Any] = {
        "name": leaf.name,
        "number": run.primitive_at + 1,
        "count": len(leaves),
        "action": plain_action(leaf.action),
    }
    still = dialogue.arm in ("paused", "stopped")
    return line("explain", "now_still" if still else "now", **slots)


def doing_next(dialogue: Dialogue) -> RobotAct:
    """Tell the step that follows; at rest, what follows the teacher's answer."""
    leaves = primitives(dialogue.known.task.tree)
    run = dialogue.run
    if dialogue.arm in ("moving", "paused", "stopped") and run is not None:
        following = leaves[run.primitive_at + 1 :]
        if following:
            return line("explain", "next_step", name=following[0].name)
        return line("explain", "next_none")
    slots: dict[str, Any] = {"task": dialogue.known.name}
    asked = _open_question(dialogue)
    if asked == "ready" and isinstance(dialogue.state, Ready):
        pace = PRACTICE.slow if dialogue.pace == "slow" else PRACTICE.normal
        slots |= {"steps": [leaf.name for leaf in leaves], "speed": pace * speed_of(dialogue.known)}
        asked = "refused" if _refused(dialogue) else "practice"
    elif asked == "none" or asked not in KNOWN_NEXT:
        asked = stage(dialogue)
    return line("explain", f"next_after.{asked}", **slots)


KNOWN_NEXT = ("ready", "satisfied", "confirm_tree", "confirm_segmentation", "did_you_mean")
"""Questions after whose answer something begins; the others lead to more questions."""


def _refused(dialogue: Dialogue) -> bool:
    asked = question(without_guess(dialogue))
    return asked is not None and asked.topic == "ready_refused"


def _open_question(dialogue: Dialogue) -> str:
    asked = question(dialogue)
    return asked.asked if asked is not None and asked.asked else "none"


def why_still(dialogue: Dialogue) -> RobotAct:
    """Tell why the arm stands, or stood the last time it was halted."""
    if dialogue.in_motion:
        return doing_now(dialogue)
    if dialogue.arm == "paused":
        return line("explain", "stopped")
    if dialogue.halt is None:
        return line("explain", "not_stopped")
    return replace(dialogue.halt, act="explain")


def pace(dialogue: Dialogue) -> RobotAct | None:
    """Tell how fast the arm moves and why; None before there is a lesson."""
    if dialogue.known.lesson is None:
        return None
    factor = PRACTICE.slow if dialogue.pace == "slow" else PRACTICE.normal
    told = round(speed_of(dialogue.known), 3)
    topic = f"pace_{dialogue.pace}"
    return line("explain", topic, percent=factor * told, told=told if told != 1.0 else None)


def why_asked(dialogue: Dialogue) -> RobotAct:
    """Tell what the open question is good for."""
    return line("explain", f"why_asked.{_open_question(dialogue)}", task=dialogue.known.name)
