"""A yes or no that a line begins with, and what is wanted beside: "no, merge lift and carry".

Where the robot asked whether something is right, the no answers it, and the rest changes what is
wrong; a reading of the rest alone would leave the question open.
"""

from __future__ import annotations

from assistant.language.frames import classes_of
from assistant.language.parsing import Hearing
from assistant.language.words import Words
from assistant.model.teacher_acts import (
    AddSubtask,
    Affirm,
    Assign,
    Deny,
    Merge,
    MoveCut,
    Optional,
    Ordered,
    RemoveSubtask,
    Rename,
    Required,
    Split,
    TeacherAct,
    Unordered,
)

_ASKING = frozenset(("confirm_tree", "confirm_segmentation", "did_you_mean", "satisfied"))
_CHANGES = (AddSubtask, Assign, Merge, MoveCut, Optional, Ordered, RemoveSubtask, Rename)
_CHANGING = (*_CHANGES, Required, Split, Unordered)


def with_answer(
    acts: tuple[TeacherAct, ...], words: Words, hearing: Hearing
) -> tuple[TeacherAct, ...]:
    """Return acts that change the task with the yes or no their line begins with."""
    if hearing.listening.asked not in _ASKING or not all(isinstance(a, _CHANGING) for a in acts):
        return acts
    book = hearing.book
    least = 1
    while least < len(words) - 1 and words[least].text in book.no and words[0].text in book.no:
        least += 1
    if least >= len(words) or not (words[least].broken or least > 1):
        return acts
    if words[0].text in book.no:
        return (Deny(), *acts)
    return (Affirm(), *acts) if words[0].text in book.yes else acts


def without_nothing(acts: tuple[TeacherAct, ...], hearing: Hearing) -> tuple[TeacherAct, ...]:
    """Return "nothing may be left out" as the no it is where that was asked."""
    asked = hearing.listening.asked == "optional"
    return tuple(Deny() if asked and _names_nothing(act, hearing) else act for act in acts)


def _names_nothing(act: TeacherAct, hearing: Hearing) -> bool:
    if not isinstance(act, Optional | Required):
        return False
    words = tuple(act.subtask.lower().split())
    return len(words) == 1 and "no" in classes_of(words, hearing.language)
