"""What was shown wrongly is forgotten for who says so; else all that was shown counts (II-B)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from assistant.dialogue.asking import learn, tell
from assistant.dialogue.doubting import without_guess
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.state import AwaitingShow, Dialogue, Ran, Ready, Reviewing
from assistant.dialogue.turn import Turn, Words, changed, first, line, say
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts


def shown_wrongly(
    dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()
) -> Turn | None:
    """Learn from what was shown last alone, or from what will be shown; None for other talk.

    Undo brings back what is forgotten, and the recordings stay.
    """
    free = without_guess(dialogue)
    known, language = free.known, free.language
    talked_over = isinstance(free.state, Reviewing | Ready | Ran | AwaitingShow)
    if not talked_over or free.pending is not None or not known.demonstrations:
        return None
    fresh = replace(known, cuts_s=None, assigned=(), reviewed=False)
    waiting = isinstance(free.state, AwaitingShow)
    if mentions(words.text, hints("newest_only", language)):
        if waiting:
            return _to_be_shown(free, replace(fresh, demonstrations=()))
        if len(known.demonstrations) == 1:
            return None
        newest = changed(
            free, "demonstration", replace(fresh, demonstrations=known.demonstrations[-1:])
        )
        return first(say(newest, line("told", "newest_only"))[1], learn(newest))
    wrong = mentions(words.text, hints("showed_wrongly", language))
    if wrong and (waiting or mentions(words.text, hints("shows", language))):
        return _to_be_shown(free, replace(fresh, demonstrations=()))
    return None


def _to_be_shown(dialogue: Dialogue, known: Knowledge) -> Turn:
    anew = replace(changed(dialogue, "demonstration", known), state=AwaitingShow(), arm="rest")
    return tell(anew, line("told", "shown_forgotten"))
