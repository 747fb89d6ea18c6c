"""Order and optional parts, as questions the robot asks to confirm (paper III-C c)."""

from __future__ import annotations

from collections.abc import Sequence
from types import MappingProxyType

from assistant.learning.conditions import Inferred
from assistant.model.lesson import Question, Segmentation
from assistant.model.task import Primitive, Subtask, Task, primitives, walk


def optional_questions(task: Task, found: Inferred, told: Sequence[str]) -> tuple[Question, ...]:
    """Return whether parts without a change of a key state may be skipped.

    Parameters
    ----------
    task : Task
    found : Inferred
    told : sequence of str
        Primitives shown.

    Notes
    -----
    Source: paper IV-B, "move up object" could be skipped.
    """
    return tuple(
        Question("optional", leaf.name, "no_key_state_change")
        for leaf in primitives(task.tree)
        if leaf.name in told and leaf.name not in found.changing and not leaf.optional
        # Approaching and leaving are never idle: they bring the hand to things and away.
        if not leaf.until and leaf.action.way not in ("approach", "to", "depart")
        if leaf.action.verb in ("move", "turn")
    )


def order_questions(task: Task, shown: Sequence[Segmentation]) -> tuple[Question, ...]:
    """Return whether parts told in sequence, but shown in another order, may come in any."""
    found = []
    for _, node in walk(task.tree):
        if isinstance(node, Subtask) and node.order == "sequential" and len(node.parts) > 1:
            orders = {_order(node, one) for one in shown}
            told = tuple(part.name for part in node.parts)
            if any(order != _kept(told, order) for order in orders):
                facts = MappingProxyType({"orders": tuple(sorted(orders))})
                found.append(Question("order", node.name, "shown_in_other_order", facts))
    return tuple(found)


def left_out_questions(task: Task, shown: Sequence[Segmentation]) -> tuple[Question, ...]:
    """Return whether parts left out in some of several demonstrations may be skipped."""
    found = []
    for leaf in primitives(task.tree):
        times = sum(any(part.primitive == leaf.name for part in one.episodes) for one in shown)
        if 0 < times < len(shown) and not leaf.optional:
            facts = MappingProxyType({"shown": times, "demonstrations": len(shown)})
            found.append(Question("optional", leaf.name, "left_out_once", facts))
    return tuple(found)


def _order(node: Subtask, shown: Segmentation) -> tuple[str, ...]:
    owner = {leaf.name: part.name for part in node.parts for leaf in _leaves(part)}
    seen = [owner[name] for part in shown.episodes if (name := part.primitive or "") in owner]
    return tuple(dict.fromkeys(seen))


def _kept(told: Sequence[str], shown: Sequence[str]) -> tuple[str, ...]:
    return tuple(name for name in told if name in shown)


def _leaves(part: Subtask | Primitive) -> tuple[Primitive, ...]:
    return primitives(part)
