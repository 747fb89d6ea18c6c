"""Steps called by their numbers, as the robot tells them: "step 1.2", "the second step"."""

from __future__ import annotations

import re
from functools import cache

from assistant.dialogue.sketch import at
from assistant.dialogue.state import Dialogue, Introducing, Watching
from assistant.language.hints import hints, mentions
from assistant.model.task import Index

NAMING = ("task_name", "goal", "subtask_count", "subtask_name", "objects", "actions")
"""Questions whose answers are new names: there a number refers to nothing, unless the words
change the plan: "the second step is called fetch it"."""


def by_name(dialogue: Dialogue, text: str) -> str:
    """Return what was said with the names of the steps that it numbers.

    Numbers are those of the tree as it is read back; "the second step" stands in its first row.
    In a tree without parts of parts a name and its number are the same to the understanding.
    """
    state = dialogue.state
    if not any(part.parts for part in dialogue.known.root.parts):
        return text
    naming = isinstance(state, Introducing) and state.asked in NAMING
    if isinstance(state, Watching) or (naming and not _changes_plan(dialogue, text)):
        return text
    return with_names(dialogue, text)


def with_names(dialogue: Dialogue, text: str) -> str:
    """Return a text with the names of the steps that it numbers, as far as there are such."""
    return _numbers(dialogue.language).sub(lambda found: _name(dialogue, found), text)


def lost_number(dialogue: Dialogue, text: str) -> str:
    """Return what is said of a numbered step that there is not, where the plan is changed."""
    state = dialogue.state
    if isinstance(state, Watching) or not _changes_plan(dialogue, text):
        return ""
    nested = any(part.parts for part in dialogue.known.root.parts)
    told = [
        found.group() for found in _numbers(dialogue.language).finditer(with_names(dialogue, text))
    ]
    return next((one for one in told if nested or "." in one), "")


def _changes_plan(dialogue: Dialogue, text: str) -> bool:
    """Whether words change a step that has a number: a list of numbered steps changes none."""
    numbered = len(_numbers(dialogue.language).findall(text))
    return 1 <= numbered <= 2 and mentions(text, hints("changes_plan", dialogue.language))


def _name(dialogue: Dialogue, found: re.Match[str]) -> str:
    told, ordinal = found.group("number"), found.group("ordinal")
    ordinals: dict[str, int] = hints("ordinals", dialogue.language)
    if told:
        index: Index = tuple(int(one) for one in told.split("."))
    else:
        index = (ordinals[ordinal.lower()],)
    node = dialogue.known.root
    for position in index:
        if not 1 <= position <= len(node.parts):
            return found.group()
        node = at(node, (position,))
    return node.name or found.group()


@cache
def _numbers(language: str) -> re.Pattern[str]:
    steps = "|".join(hints("step_words", language))
    articles = "|".join(hints("articles", language))
    ordinals = "|".join(hints("ordinals", language))
    return re.compile(
        rf"\b(?:(?:{steps})\s+)+(?P<number>\d+(?:\.\d+)*)(?![\w.]*\d)\b"
        rf"|\b(?:(?:{articles})\s+)?(?P<ordinal>{ordinals})\s+(?:{steps})\b",
        re.IGNORECASE,
    )
