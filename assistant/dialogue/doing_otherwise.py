"""What a step does, told anew: "in step 3 the hand goes down to the board" (paper II-A)."""

from __future__ import annotations

import re
from collections.abc import Iterable

from assistant.dialogue.answers import answer
from assistant.dialogue.asking import proceed
from assistant.dialogue.doubting import is_guess, without_guess
from assistant.dialogue.naming import number_of, steps_in
from assistant.dialogue.referring import with_names
from assistant.dialogue.sketch import names, walk
from assistant.dialogue.state import AwaitingShow, Dialogue, Introducing
from assistant.dialogue.turn import Turn, Words, changed, first, say
from assistant.language.actions import read_action
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts
from assistant.model.task import Index

MOST_LEAD = 4
"""Words between the name of a step and what is to be done there: "the hand should only"."""
_ONE = (acts.Unknown, acts.Inform, acts.Gripper, acts.Translate)
"""What a motion is heard as where a number of parts is asked for."""


def does_otherwise(
    dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()
) -> Turn | None:
    """Take what a step does, told of it by its name or number; None for other talk."""
    state, text = dialogue.state, words.text
    planned = isinstance(state, AwaitingShow) or (
        isinstance(state, Introducing) and state.asked == "confirm_tree"
    )
    between = dialogue.pending is not None and not is_guess(dialogue.pending)
    if not planned or between or "?" in text or dialogue.known.lesson is not None:
        return None
    index, does = _told_of(dialogue, with_names(dialogue, text))
    if not does:
        return None
    told = answer(dialogue.known, Introducing("actions", index), does)
    if told.known == dialogue.known:
        return None
    after = changed(without_guess(dialogue), "actions", told.known)
    return first(say(after, *told.lines)[1], proceed(after))


def does_at_once(
    dialogue: Dialogue, words: Words, meant: Iterable[acts.TeacherAct] = ()
) -> Turn | None:
    """Take what a step of no parts does, told when it is asked how many; None for other talk.

    "None, it goes down", and also just "open the hand at the board".
    """
    state, language = dialogue.state, dialogue.language
    between = dialogue.pending is not None and not is_guess(dialogue.pending)
    if not isinstance(state, Introducing) or state.asked != "subtask_count" or between:
        return None
    none = rf"\W*(?:{_any('nothing', language)})\s*[,.;:]\s*(?P<does>[^?]+)$"
    found = re.match(none, words.text, re.IGNORECASE)
    does = _plain((found.group("does") if found else words.text).rstrip(" ."), language)
    reading = read_action(does, (), language)
    one = reading.sure and "?" not in does and len(steps_in(does, 2, language)) == 1
    alone = one and number_of(does, language) is None and all(isinstance(a, _ONE) for a in meant)
    if not state.index or reading.action is None or not (found or alone):
        return None
    if alone and reading.action.way == "backward":
        # "Go back" is to the question before.
        return None
    single = answer(dialogue.known, state, 0).known
    told = answer(single, Introducing("actions", state.index), does)
    return proceed(changed(without_guess(dialogue), "actions", told.known))


def _told_of(dialogue: Dialogue, text: str) -> tuple[Index, str]:
    """Return a step of one motion and the words for what it does; no words where none do."""
    language, root = dialogue.language, dialogue.known.root
    leads, places = _any("leads", language), _any("in_step", language)
    steps, articles = _any("step_words", language), _any("articles", language)
    for index, node in walk(root):
        if not index or not node.name or node.parts:
            continue
        head = (
            rf"(?:(?:{leads})\b\W*)*(?:(?:{places})\s+)?(?:(?:{articles})\s+)?(?:(?:{steps})\s+)?"
        )
        found = re.match(rf"\W*{head}{re.escape(node.name)}\b(?P<rest>.+)$", text, re.IGNORECASE)
        does = _does(found.group("rest"), language) if found else ""
        others = [one for one in names(root) if one != node.name]
        if does and not mentions(does, others):
            return index, does
    return (), ""


def _does(rest: str, language: str) -> str:
    """Return the first clause of what is said of a step, if it tells what is done there."""
    clause = re.split(r"[,.;!]\s|[.!]$", rest.lstrip(" ,:"))[0].strip()
    begun = " ".join(clause.split()[:MOST_LEAD])
    led = rest.lstrip().startswith(":") or mentions(begun, hints("does", language))
    if not led or mentions(clause, hints("does_not", language)):
        return ""
    plain = _plain(clause, language)
    return plain if read_action(plain, (), language).action is not None else ""


def _plain(clause: str, language: str) -> str:
    """Return a clause with its verbs as they are told to somebody: "goes down" is "go down"."""
    bent: dict[str, str] = hints("third_person", language)
    return " ".join(bent.get(word.lower(), word) for word in clause.split())


def _any(part: str, language: str) -> str:
    return "|".join(re.escape(one) for one in sorted(hints(part, language), key=len, reverse=True))
