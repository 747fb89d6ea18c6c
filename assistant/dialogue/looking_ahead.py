"""What a check tells before anything moves: whether all is within reach, and how long it takes."""

from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType
from typing import Any

from assistant.dialogue.asking import ask, check, tell
from assistant.dialogue.correcting import speed_of
from assistant.dialogue.effects import Say
from assistant.dialogue.events import Checked
from assistant.dialogue.state import Dialogue, Ready
from assistant.dialogue.turn import Turn, line
from assistant.model.task import primitives

LONGER = 1.25
"""A run so many times longer than asked for is told: moved setups alone take up to 1.2 times."""
REACHED = "all"


def looked(dialogue: Dialogue) -> Turn:
    """Ask what is open, and tell with it that a new arrangement is within reach."""
    after, effects = ask(replace(dialogue, state=Ready(), arm="rest", refusal=None))
    return after, tuple(_reached(one) if isinstance(one, Say) else one for one in effects)


def _reached(said: Say) -> Say:
    slots = MappingProxyType({**said.line.slots, "reached": REACHED})
    return Say(replace(said.line, slots=slots))


def told_dry(dialogue: Dialogue, event: Checked) -> Turn:
    """Tell what a run would be like; nothing has moved."""
    slots: dict[str, Any] = {
        "names": [leaf.name for leaf in primitives(dialogue.known.task.tree)],
        "duration_s": round(event.duration_s, 1),
        "asked_s": asked_s(dialogue, event.duration_s),
        "note": event.note,
    }
    told = line("told", "dry_run", **slots)
    return tell(replace(dialogue, state=Ready(), arm="rest", refusal=None), told)


def asked_s(dialogue: Dialogue, duration_s: float) -> float | None:
    """Return how long a run would take at the speed asked for; None where it is kept to.

    Parameters
    ----------
    dialogue : Dialogue
    duration_s : float
        As checked.
    """
    lesson, speed = dialogue.known.lesson, check(dialogue).speed * speed_of(dialogue.known)
    if lesson is None or lesson.path is None or speed <= 1.0:
        return None
    wanted_s = float(lesson.path.t_s[-1] - lesson.path.t_s[0]) / speed
    return wanted_s if duration_s > LONGER * wanted_s else None
