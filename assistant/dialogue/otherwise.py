"""The other one was meant: the second-best reading, or the other of two candidates."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import tell
from assistant.dialogue.doubting import doubted, is_guess
from assistant.dialogue.going_back import resettled
from assistant.dialogue.listening import beneath
from assistant.dialogue.state import Dialogue, Other
from assistant.dialogue.turn import Turn, Words, line
from assistant.language.hints import hints, mentions
from assistant.language.second import second_reading


def wants_other(dialogue: Dialogue, text: str) -> bool:
    """Whether the teacher means the other of two things, and there is one."""
    there = is_guess(dialogue.pending) or dialogue.other is not None
    return there and mentions(text, hints("other_one", dialogue.language))


def guessed_other(dialogue: Dialogue) -> Turn:
    """Read back the second-best reading of a sentence whose best one was not meant."""
    pending, below = dialogue.pending, beneath(dialogue)
    free = replace(dialogue, pending=None, misses=1)
    second = None
    if pending is not None and below is not None and pending.words:
        second = pending.other or second_reading(
            pending.words, below, pending.acts, dialogue.language
        )
    if second is None or pending is None:
        return tell(free, line("told", "say_it_otherwise"))
    return doubted(free, second, Words(pending.words))


def taken_back(dialogue: Dialogue, other: Other) -> Turn:
    """Take back what was done with the first of two candidates."""
    free = replace(dialogue, pending=None, other=None)
    if len(dialogue.past) <= other.depth:
        return free, ()
    before = dialogue.past[other.depth]
    back = replace(free, known=before.known, past=dialogue.past[: other.depth], future=())
    turn = resettled(dialogue.known, back, line("done", "undone", what=before.label))
    return turn[0], tuple(turn[1][:1])


def remembered(before: Dialogue, turn: Turn) -> Turn:
    """Return the turn; what was the other candidate before it is forgotten."""
    after = turn[0]
    if after.other is None or after.other is not before.other:
        return turn
    return replace(after, other=None), turn[1]
