"""The goal told anew, or called wrong, whatever is asked: "when it's done the jar is full"."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

from assistant.dialogue.asking import settle
from assistant.dialogue.doubting import is_guess, without_guess
from assistant.dialogue.naming import tidy_name
from assistant.dialogue.state import Dialogue, Introducing
from assistant.dialogue.turn import Turn, Words, changed, line
from assistant.language.asides import after
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts

_SENTENCE = re.compile(r"[^.!;]+")
SHORTEST = 3
"""Words of a goal that is told by the way."""


def regoaled(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Take the goal a sentence tells, or ask for it again; None for other talk."""
    state, pending, text = dialogue.state, dialogue.pending, words.text
    if dialogue.known.goal is None or "?" in text or (pending and not is_guess(pending)):
        return None
    introducing = isinstance(state, Introducing)
    if isinstance(state, Introducing) and state.asked in ("task_name", "goal"):
        return None
    named = mentions(text, hints("goal_words", dialogue.language))
    things = [one.name.lower() for one in dialogue.known.objects or ()]
    if re.search(r"\d", text) or (not introducing and (not named or mentions(text, things))):
        # "When it is done, go home" is no goal, nor is where a thing called "goal" stands.
        return None
    goal = _told(text, dialogue.language)
    free = without_guess(dialogue)
    if len(goal.split()) >= SHORTEST:
        known = replace(free.known, goal=goal)
        return settle(changed(free, "goal", known), line("done", "goal", goal=goal))
    if named and mentions(text, hints("goal_wrong", dialogue.language)):
        return settle(changed(free, "goal", replace(free.known, goal=None)))
    return None


def _told(text: str, language: str) -> str:
    """Return the goal of the sentence that tells one, opened or ended by what says so."""
    ends = "|".join(re.escape(one) for one in hints("goal_ends", language))
    for sentence in _SENTENCE.findall(text):
        opened = after(sentence, "goal_told", language)
        if opened:
            return tidy_name(opened)
        ended = re.match(rf"\W*(.+?)\s+(?:{ends})\W*$", sentence, re.IGNORECASE)
        if ended:
            return tidy_name(ended.group(1))
    return ""
