"""What a teacher's words mean where the dialogue stands."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from assistant.dialogue.machine import beneath, listening
from assistant.dialogue.referring import by_name
from assistant.dialogue.state import Dialogue
from assistant.language.hints import hints
from assistant.language.stopping import has_stop_word
from assistant.language.understanding import understand
from assistant.model.listening import Listening, Understanding
from assistant.model.settings import SafetySettings
from assistant.model.teacher_acts import Affirm, Deny, Inform, Stop, Unknown

SAFETY = SafetySettings()
MOST_SENTENCES, LONG = 6, 12
"""Sentences that are looked at one by one, and words of a text that is no short answer."""
NOTHING, GUESSED = 0.3, 0.8
"""Below the one nothing is guessed at; above the other nothing said among much else is."""
_SENTENCE = re.compile(r".+?(?:[.!?;]+(?=\s)|$)")
_IDLE = (Unknown, Affirm, Deny)


def printable(text: str) -> str:
    """Return words with a blank for each control sign: names of them could not be read again."""
    return "".join(sign if sign.isprintable() else " " for sign in text)


def meant(dialogue: Dialogue, text: str, sure: float, language: str) -> Understanding:
    """Return what words mean; while the arm moves a stop word means stop.

    Who does not answer a guess with yes or no is heard as answering what was asked before it:
    "15 cm wide" says how wide. Words that were not surely recognized mean nothing more surely
    than that.
    """
    now = listening(dialogue)
    if now.moving and has_stop_word(text, language):
        return Understanding((Stop(),), 1.0, text)
    letters: Mapping[str, str] = hints("letters", language)
    # Who types in a hurry types one letter for yes and one for no.
    told = by_name(dialogue, letters.get(text.strip(" .!").lower(), text))
    found = understand(told, now, language)
    if found.confidence < SAFETY.act_confidence and _calls_a_step(found, now, told, language):
        # "Merge step 2 and 3" changes the plan and does not answer "how many?".
        found = understand(told, replace(now, asked="confirm_tree"), language)
    below = beneath(dialogue)
    if below is not None and not _clear(found):
        found = understand(told, below, language)
    if found.confidence < SAFETY.act_confidence:
        found = _among_sentences(told, found, below or now, language)
    return replace(found, confidence=min(found.confidence, sure))


def _calls_a_step(found: Understanding, now: Listening, text: str, language: str) -> bool:
    """Whether what was taken for a number of steps calls one of them by its number."""

    def any_of(part: str) -> str:
        return "|".join(map(re.escape, hints(part, language)))

    counts = [act for act in found.acts if isinstance(act, Inform) and isinstance(act.value, int)]
    step = any_of("step_words")
    by_number = rf"(?:{step})\s+(?:\d+|{any_of('numbers')})"
    called = rf"\b(?:{by_number}|(?:{any_of('ordinals')})\s+(?:{step}))\b"
    plain = now.asked == "subtask_count" and len(counts) == len(found.acts)
    return plain and re.search(called, text.lower()) is not None


def _among_sentences(
    text: str, whole: Understanding, now: Listening, language: str
) -> Understanding:
    """Return the one sentence of a talkative teacher that means something, as a guess.

    What is said at length and means nothing clearly means nothing.
    """
    sentences = [one.strip() for one in _SENTENCE.findall(text) if len(one.split()) > 1]
    if not 1 < len(sentences) <= MOST_SENTENCES:
        return whole
    told = (understand(one, now, language) for one in sentences)
    found = [one for one in told if not all(isinstance(act, _IDLE) for act in one.acts)]
    # A question of the teacher's own is no answer.
    found = [one for one in found if not (one.heard.endswith("?") and _answers(one))]
    best = max((*found, whole), key=lambda one: one.confidence)
    if best.confidence < NOTHING and len(text.split()) >= LONG:
        return Understanding((Unknown(),), best.confidence, whole.heard)
    return replace(best, confidence=min(best.confidence, GUESSED), heard=whole.heard)


def _answers(found: Understanding) -> bool:
    return all(isinstance(act, Inform) for act in found.acts)


def _clear(found: Understanding) -> bool:
    vague = any(isinstance(act, Inform | Unknown) for act in found.acts)
    return found.confidence >= SAFETY.act_confidence and not vague
