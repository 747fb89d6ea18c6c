"""Before- and until-conditions of primitives: told, learned, or implied (paper III-C c)."""

from __future__ import annotations

from typing import Any

from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.runs import Run
from assistant.dialogue.turn import plain_condition
from assistant.model.conditions import Condition
from assistant.model.task import Primitive, Task, primitives

SEEN = ("hand", "docked", "held", "on", "aligned", "clear")
"""Kinds of condition whose coming true the arm reports."""

Conditions = tuple[Condition, ...]


def expected(known: Knowledge, leaf: Primitive) -> tuple[Conditions, Conditions]:
    """Return the before- and until-conditions of a primitive as known now."""
    return conditions_of(known.task, leaf)


def conditions_of(task: Task, leaf: Primitive) -> tuple[Conditions, Conditions]:
    """Return the before- and until-conditions of a primitive of a task.

    What the teacher told comes first, then what was learned, then what the action implies.
    """
    lesson = task.learned
    learned_before = lesson.before.get(leaf.name, ()) if lesson else ()
    learned_until = lesson.until.get(leaf.name, ()) if lesson else ()
    before = leaf.before or learned_before or _implied_before(leaf)
    return before, leaf.until or learned_until or _implied_until(task, leaf)


def _implied_before(leaf: Primitive) -> Conditions:
    if (leaf.action.verb, leaf.action.way) == ("move", "approach"):
        return (Condition("hand", "open"),)
    return ()


def _implied_until(task: Task, leaf: Primitive) -> Conditions:
    thing = leaf.action.object
    match (leaf.action.verb, leaf.action.way):
        case ("move", "approach") if thing:
            return (Condition("docked", thing),)
        case ("hand", "close"):
            return (Condition("held", thing),) if thing else (Condition("hand", "closed"),)
        case ("hand", "open"):
            carried = _carried_into(task, leaf)
            if thing and carried and thing != carried:
                return (Condition("on", carried, thing),)
            return (Condition("hand", "open"),)
        case _:
            return ()


def _carried_into(task: Task, leaf: Primitive) -> str | None:
    """Return what was grasped last before a primitive."""
    carried: str | None = None
    for other in primitives(task.tree):
        if other.name == leaf.name:
            return carried
        if (other.action.verb, other.action.way) == ("hand", "close"):
            carried = other.action.object
    return carried


def missing(known: Knowledge, run: Run) -> tuple[str, ...]:
    """Return the primitives whose until-conditions the arm should have seen, but did not."""
    seen = set(run.perceived)
    lacking: list[str] = []
    for leaf in primitives(known.task.tree):
        wanted = [one for one in expected(known, leaf)[1] if one.kind in SEEN]
        if any((one.kind, one.object or "") not in seen for one in wanted) and not leaf.optional:
            lacking.append(leaf.name)
    return tuple(lacking)


def plain_conditions(conditions: Conditions) -> list[dict[str, Any]]:
    """Return conditions as files write them."""
    return [plain_condition(one) for one in conditions]
