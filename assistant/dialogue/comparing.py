"""How the present task differs from a kept one: steps, order, goal, corrections, what was shown."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from assistant.dialogue.correcting import plain_feedback
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.sketch import Sketch, from_tree, leaves, names, walk
from assistant.dialogue.turn import line
from assistant.model.lesson import Lesson
from assistant.model.robot_acts import RobotAct
from assistant.model.task import Task

PLACES = 6
"""Decimal places to which two paths of the same demonstration agree in files."""


def comparison(known: Knowledge, name: str, other: Task) -> RobotAct:
    """Return the line that tells how the present task differs from a kept one."""
    here, there = known.root, from_tree(other.tree)
    mine, theirs = _corrections(known.lesson), _corrections(other.learned)
    told: dict[str, Any] = {
        "added": _missing(names(here), names(there)),
        "removed": _missing(names(there), names(here)),
        "order": _order(here, there),
        "optional": _missing(_optional(here), _optional(there)),
        "required": _missing(_optional(there), _optional(here)),
        "unordered": _missing(_unordered(here, known.name), _unordered(there, other.name)),
        "ordered": _missing(_unordered(there, other.name), _unordered(here, known.name)),
        "goal": other.goal if other.goal != (known.goal or "") else "",
        "corrected": [one["words"] for one in mine if one not in theirs],
        "uncorrected": [one["words"] for one in theirs if one not in mine],
        "speed": _speed(known.lesson, other.learned),
    }
    if any(told.values()):
        return line("told", "comparison", name=name, **told)
    shown = _same_path(known.lesson, other.learned)
    return line("told", "comparison_same" if shown else "comparison_shown", name=name)


def _corrections(lesson: Lesson | None) -> list[dict[str, Any]]:
    return [plain_feedback(one) for one in lesson.feedback] if lesson is not None else []


def _missing(ones: Sequence[str], others: Sequence[str]) -> list[str]:
    return [one for one in ones if one not in others]


def _order(here: Sketch, there: Sketch) -> list[str]:
    """Return the single motions in the other's order where the same ones come in another."""
    mine = [node.name for _, node in leaves(here)]
    theirs = [node.name for _, node in leaves(there)]
    return theirs if mine != theirs and sorted(mine) == sorted(theirs) else []


def _optional(root: Sketch) -> list[str]:
    return [node.name for index, node in walk(root) if index and node.optional]


def _unordered(root: Sketch, task: str) -> list[str]:
    return [node.name or task for _, node in walk(root) if node.order == "any"]


def _speed(mine: Lesson | None, theirs: Lesson | None) -> float | None:
    """Return the other's speed in percent of what was shown, if it is another."""
    if mine is None or theirs is None or round(mine.speed, 4) == round(theirs.speed, 4):
        return None
    return round(100.0 * theirs.speed)


def _same_path(mine: Lesson | None, theirs: Lesson | None) -> bool:
    """Whether both were learned from the same demonstration, cut alike."""
    if mine is None or theirs is None:
        return mine is theirs
    cut = [(one.primitive, round(one.to_s, 3)) for one in mine.segmentation.episodes]
    if cut != [(one.primitive, round(one.to_s, 3)) for one in theirs.segmentation.episodes]:
        return False
    one, other = mine.path, theirs.path
    if one is None or other is None:
        return one is other
    alike = one.path.shape == other.path.shape
    return alike and bool(np.allclose(one.path, other.path, atol=10.0**-PLACES))
