"""Corrections that tell one thing twice: "more, loads more" is one act."""

from __future__ import annotations

from collections.abc import Sequence

from assistant.model.teacher_acts import (
    AdjustLast,
    AdjustSpeed,
    Gripper,
    Rotate,
    TeacherAct,
    Translate,
    act_from_json,
    act_to_json,
)

CORRECTIONS = (Translate, Rotate, AdjustSpeed, Gripper, AdjustLast)


def merged(acts: Sequence[TeacherAct]) -> tuple[TeacherAct, ...]:
    """Return acts without those that others only tell more of: "more, loads more" is one."""
    found: list[TeacherAct] = []
    for act in acts:
        at = next((n for n, one in enumerate(found) if _same_change(one, act)), -1)
        if at < 0:
            found.append(act)
        else:
            found[at] = _united(found[at], act)
    return tuple(found)


def _same_change(one: TeacherAct, other: TeacherAct) -> bool:
    """Tell two corrections of which the second only tells more or less of the first."""
    if type(one) is not type(other) or not isinstance(one, CORRECTIONS):
        return False
    told, again = act_to_json(one), act_to_json(other)
    for key in ("direction", "command", "change"):
        if told.get(key) and again.get(key) and told[key] != again[key]:
            return False
    if isinstance(one, AdjustLast) and ("factor" in told) != ("factor" in again):
        return False
    if isinstance(one, AdjustSpeed) and ("factor" in told) != ("factor" in again):
        factor = float({**told, **again}["factor"])
        return ({**told, **again}["change"] == "faster") is (factor > 1)
    both = ("distance_m", "angle_deg", "factor", "where")
    return not any(key in told and key in again and told[key] != again[key] for key in both)


def _united(one: TeacherAct, other: TeacherAct) -> TeacherAct:
    """Return one change with what either tells; a measure counts more than a little or much."""
    told = {**act_to_json(one), **act_to_json(other)}
    if any(key in told for key in ("distance_m", "angle_deg")):
        told.pop("degree", None)
    if "factor" in told:
        told = {key: value for key, value in told.items() if key not in ("degree", "change")}
    return act_from_json(told)
