"""A step split into parts that are named at once: "split lift it into raise it and hold it"."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

from assistant.dialogue import grouping
from assistant.dialogue.finding import find
from assistant.dialogue.naming import just_as_many, number_of, steps_in, tidy
from assistant.dialogue.referring import with_names
from assistant.dialogue.replying import in_state
from assistant.dialogue.sketch import at
from assistant.dialogue.state import Dialogue, Introducing
from assistant.dialogue.turn import Turn, Words, first
from assistant.language.hints import hints
from assistant.model import teacher_acts as acts

FEWEST = 2
"""Parts that are named; of fewer nothing is told but that there are some."""


def split_into(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Split a step into the parts a sentence names; None for other talk."""
    if dialogue.pending is not None or "?" in words.text:
        return None
    told = re.match(
        rf"\W*(?:\w+\s+){{0,2}}?(?:{_any('splits', dialogue)})\s+(.+?)\s+"
        rf"(?:{_any('splits_into', dialogue)})\s+(.+?)"
        rf"(?:\s+(?:{_any('splits_ends', dialogue)}))?\W*$",
        words.text,
        re.IGNORECASE,
    )
    index = find(dialogue.known, _called(dialogue, told.group(1))) if told else None
    if told is None or not index or at(dialogue.known.root, index).parts:
        return None
    parts = steps_in(told.group(2), FEWEST, dialogue.language)
    # "Lift and place" may be one name, but not of what something is split into.
    parts = parts if len(parts) > 1 else just_as_many(told.group(2), FEWEST, dialogue.language)
    if len(parts) < FEWEST or number_of(parts[0], dialogue.language) is not None:
        return None
    opened, effects = grouping.split(dialogue, at(dialogue.known.root, index).name)
    if not isinstance(opened.state, Introducing):
        return opened, effects
    naming = replace(opened, state=Introducing("subtask_name", (*index, 1)))
    return first(effects[:1], in_state(naming, acts.Inform(parts), words))


def _called(dialogue: Dialogue, text: str) -> str:
    """Return the name of the step a text calls by name or number."""
    return tidy(with_names(dialogue, text), dialogue.language)


def _any(part: str, dialogue: Dialogue) -> str:
    told: list[str] = hints(part, dialogue.language)
    return "|".join(map(re.escape, sorted(told, key=len, reverse=True)))
