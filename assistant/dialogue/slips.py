"""A teacher who slips in the introduction: a mistake told of, no more steps, begun anew.

Such talk is no name, however much the question asks for one.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from assistant.dialogue.asking import ask, proceed, tell
from assistant.dialogue.introduction import all_understood
from assistant.dialogue.naming import is_nothing
from assistant.dialogue.sketch import at, counted, put
from assistant.dialogue.state import Dialogue, Introducing, Pending
from assistant.dialogue.turn import Turn, Words, changed, first, line, say
from assistant.dialogue.undoing import undo
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts

_NAMING = ("goal", "objects", "subtask_count", "subtask_name", "actions")
"""Questions whose answers are taken as they are said."""
BEGIN_ANEW = "begin_introduction"


def slip(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct]) -> Turn | None:
    """Answer a teacher who has made a mistake, or has no more to tell."""
    state = dialogue.state
    if not isinstance(state, Introducing) or dialogue.pending is not None:
        return None
    if dialogue.known.name and _tells(dialogue, words, "start_over"):
        return _begun_anew(dialogue)
    if state.asked not in _NAMING:
        return None
    if state.asked == "subtask_name":
        fewer = _fewer(dialogue, state, words)
        if fewer is not None:
            return fewer
    if _tells(dialogue, words, "slip_undone"):
        return undo(dialogue)
    return tell(dialogue, line("told", "slip")) if _tells(dialogue, words, "slip") else None


def _tells(dialogue: Dialogue, words: Words, part: str) -> bool:
    return mentions(words.text, hints(part, dialogue.language))


def _begun_anew(dialogue: Dialogue) -> Turn:
    """Ask whether all that was told of the task is to be forgotten."""
    task = dialogue.known.name
    question = line("confirm", BEGIN_ANEW, asked="did_you_mean", task=task)
    return ask(replace(dialogue, pending=Pending("did_you_mean", question)))


def _fewer(dialogue: Dialogue, state: Introducing, words: Words) -> Turn | None:
    """Take it that there are no more steps than were named, or none below the step."""
    known, parent, named = dialogue.known, state.index[:-1], state.index[-1] - 1
    # Of the parts of a step "none" tells that there are no more; the task itself was counted.
    none = bool(parent) and is_nothing(words.text, dialogue.language)
    no_more = none or _tells(dialogue, words, "no_more_steps")
    if named and no_more:
        root = put(known.root, parent, counted(at(known.root, parent), named))
        told = line("done", "counted", count=named)
        after = changed(dialogue, "subtask_count", replace(known, root=root))
        return first(say(after, told)[1], proceed(after))
    if parent and not named and _tells(dialogue, words, "single_motion"):
        root = put(known.root, parent, counted(at(known.root, parent), 0))
        more = all_understood(replace(known, root=root))
        return proceed(changed(dialogue, "subtask_count", more))
    return None
