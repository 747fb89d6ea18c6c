"""Changes that may be made on a guess: they name known steps, move nothing, and can be undone."""

from __future__ import annotations

import re
from collections.abc import Sequence

from assistant.dialogue.naming import alike
from assistant.dialogue.sketch import names
from assistant.dialogue.state import Dialogue, Ready
from assistant.language.hints import hints
from assistant.model import teacher_acts as acts


def names_known(dialogue: Dialogue, meant: Sequence[acts.TeacherAct]) -> bool:
    """Whether all acts change the plan before it was learned, at steps named in full.

    Once something was learned a change may call for learning anew, and is asked about first.
    """
    if dialogue.known.lesson is not None or dialogue.pending is not None or not meant:
        return False
    known = names(dialogue.known.root)
    return all(_grounded(act, known) for act in meant)


def two_ways(dialogue: Dialogue, text: str, meant: Sequence[acts.TeacherAct]) -> bool:
    """Whether a word that is both a yes and a direction would set the arm in motion.

    "right" is a direction as often as a yes: the robot asks before it moves on it.
    """
    if not isinstance(dialogue.state, Ready) or dialogue.pending is not None:
        return False
    going = any(isinstance(act, acts.Affirm | acts.Start | acts.Approve) for act in meant)
    plain = " ".join(re.findall(r"\w+", text.lower()))
    return going and plain in hints("two_ways", dialogue.language)


def _grounded(act: acts.TeacherAct, known: Sequence[str]) -> bool:
    match act:
        case acts.Rename(old, new):
            return bool(new) and alike(old, known)
        case acts.Optional(name) | acts.Required(name):
            return alike(name, known)
        case acts.Ordered(one, other):
            return alike(one, known) and alike(other, known)
        case acts.Merge(named):
            return len(named) > 1 and all(alike(name, known) for name in named)
        case _:
            return False
