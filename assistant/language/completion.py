"""What can be said now, with the task's own names: for help and for completing lines."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from assistant.language.answers import OPEN
from assistant.language.phrasebook import phrasebook
from assistant.model.listening import Listening


def suggestions(listening: Listening, language: str = "english") -> tuple[str, ...]:
    """Return sentences that are understood now, the likeliest first."""
    told = phrasebook(language).suggestions
    asked = told.get(listening.asked or "", ())
    staged = () if listening.asked in OPEN else told.get(listening.stage, ())
    return filled((*asked, *staged, *told["always"]), listening)


def filled(lines: Iterable[str], listening: Listening) -> tuple[str, ...]:
    """Return lines with the task's own names where they have a slot, each once."""
    return tuple(dict.fromkeys(one for line in lines for one in _filled(line, listening)))


@cache
def _parts(line: str) -> tuple[str, str, str]:
    before, slot, behind = line.partition("{subtask}")
    if not slot:
        before, slot, behind = line.partition("{object}")
    return before, slot, behind


def _filled(line: str, listening: Listening) -> tuple[str, ...]:
    before, slot, behind = _parts(line)
    if not slot:
        return (line,)
    names = listening.subtasks if slot == "{subtask}" else listening.objects
    return tuple(f"{before}{name}{behind}" for name in names)
