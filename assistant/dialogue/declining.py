"""What follows a no to a question in between."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue import heard_names
from assistant.dialogue.asking import tell
from assistant.dialogue.doubting import is_guess
from assistant.dialogue.grouping import SHOW_AGAIN
from assistant.dialogue.otherwise import guessed_other
from assistant.dialogue.replying import in_state
from assistant.dialogue.spots import SPOT
from assistant.dialogue.state import Dialogue, Pending
from assistant.dialogue.turn import Turn, Words, line
from assistant.dialogue.undoing import undo
from assistant.model import teacher_acts as acts


def denied(dialogue: Dialogue, pending: Pending) -> Turn:
    """Take a no to a question in between; where there is another reading, read that back."""
    free = replace(dialogue, pending=pending.over)
    if pending.line.topic == heard_names.TOPIC:
        return tell(free, line("told", "say_or_spell"))
    if pending.line.topic == SHOW_AGAIN:
        # What is not shown anew cannot be done anew.
        return undo(free)
    if pending.line.topic == SPOT:
        # No to a place that was offered leaves it to the showing.
        return in_state(free, acts.Deny(), Words(""))
    if is_guess(pending) and pending.other:
        return guessed_other(dialogue)
    if is_guess(pending):
        return tell(replace(free, misses=1), line("told", "say_it_otherwise"))
    return tell(free, line("told", "as_it_was"))
