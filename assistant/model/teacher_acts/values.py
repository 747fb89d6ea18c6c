"""Acts as the mappings that files and programs read, and back.

The act's name is the class's in snake case; absent slots are left out.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import fields
from functools import cache
from typing import Any, get_args

from assistant.errors import BadInput
from assistant.model.teacher_acts.union import TeacherAct
from assistant.model.teacher_acts.words import Where


def act_name(act: TeacherAct | type[TeacherAct]) -> str:
    """Return the act's name in files and programs, such as ``adjust_speed``."""
    return _snake((act if isinstance(act, type) else type(act)).__name__)


@cache
def _snake(name: str) -> str:
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


ACTS: Mapping[str, type[TeacherAct]] = {act_name(kind): kind for kind in get_args(TeacherAct)}
_SLOTS: Mapping[str, tuple[str, ...]] = {
    name: tuple(field.name for field in fields(kind)) for name, kind in ACTS.items()
}


def act_to_json(act: TeacherAct) -> dict[str, Any]:
    """Return the act as a mapping, absent slots left out, tuples as lists."""
    name = act_name(act)
    slots = ((slot, getattr(act, slot)) for slot in _SLOTS[name])
    told = {slot: _plain(value) for slot, value in slots if value is not None}
    return {"act": name, **told}


def act_from_json(mapping: Mapping[str, Any]) -> TeacherAct:
    """Return the act a mapping stands for.

    Raises
    ------
    BadInput
        If the act or one of its slots is not known, or a slot is missing.
    """
    slots = dict(mapping)
    name = slots.pop("act", None)
    kind = ACTS.get(str(name))
    if kind is None:
        raise BadInput.one("act", f"unknown act {name!r}", f"one of {', '.join(sorted(ACTS))}")
    if isinstance(slots.get("where"), Mapping):
        slots["where"] = Where(**slots["where"])
    try:
        return kind(**{key: _frozen(value) for key, value in slots.items()})
    except TypeError as error:
        known = ", ".join(_SLOTS[str(name)]) or "none"
        raise BadInput.one("act", f"wrong slots for {name}", f"its slots are: {known}") from error


def _plain(value: Any) -> Any:
    if isinstance(value, Where):
        return {"subtask": value.subtask, "when": value.when}
    return list(value) if isinstance(value, tuple) else value


def _frozen(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value
