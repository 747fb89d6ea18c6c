"""What can be said now, and patience: who was not understood twice is given examples."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import question, stage
from assistant.dialogue.effects import Effect, Say
from assistant.dialogue.state import AwaitingShow, Dialogue, Watching
from assistant.dialogue.things import thing_names
from assistant.dialogue.turn import Turn, line
from assistant.model.robot_acts import RobotAct

NO_ANSWER = ("not_an_answer", "not_now", "size", "count", "not_among")
"""Errors that mean: the robot still waits for an answer."""


def help_line(dialogue: Dialogue) -> RobotAct:
    """Return what can be said now, with the task's own names."""
    asked = question(dialogue)
    topic: str = dialogue.arm
    if dialogue.arm not in ("moving", "paused", "stopped", "checking"):
        topic = asked.asked if asked is not None and asked.asked else stage(dialogue)
        topic = "count_of" if asked is not None and asked.topic == "count_of" else topic
        topic = "demonstration" if isinstance(dialogue.state, AwaitingShow) else topic
        topic = "watching" if isinstance(dialogue.state, Watching) else topic
    things = thing_names(dialogue.known.scene, dialogue.known.setup)
    named = [one.name for one in dialogue.known.objects or ()] or things
    return line("help", topic, things=things, thing=named[0] if named else None)


def patient(before: Dialogue, turn: Turn) -> Turn:
    """Return the turn with examples if this was the second time without an answer."""
    after, effects = turn
    at = next((at for at, one in enumerate(effects) if _no_answer(one)), None)
    if at is None:
        return turn
    missed = replace(after, misses=before.misses + 1)
    if not before.misses:
        return missed, effects
    return missed, (*effects[: at + 1], Say(help_line(missed)), *effects[at + 1 :])


def _no_answer(effect: Effect) -> bool:
    return isinstance(effect, Say) and effect.line.act == "error" and effect.line.topic in NO_ANSWER
