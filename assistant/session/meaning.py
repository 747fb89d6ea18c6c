"""What a teacher's words mean where the dialogue stands."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.machine import beneath, listening
from assistant.dialogue.referring import by_name
from assistant.dialogue.state import Dialogue
from assistant.language.stopping import has_stop_word
from assistant.language.understanding import understand
from assistant.model.listening import Understanding
from assistant.model.settings import SafetySettings
from assistant.model.teacher_acts import Inform, Stop, Unknown

SAFETY = SafetySettings()


def meant(dialogue: Dialogue, text: str, sure: float, language: str) -> Understanding:
    """Return what words mean; while the arm moves a stop word means stop.

    Who does not answer a guess with yes or no is heard as answering what was asked before it:
    "15 cm wide" says how wide. Words that were not surely recognized mean nothing more surely
    than that.
    """
    now = listening(dialogue)
    if now.moving and has_stop_word(text, language):
        return Understanding((Stop(),), 1.0, text)
    told = by_name(dialogue, text)
    found = understand(told, now, language)
    below = beneath(dialogue)
    if below is not None and not _clear(found):
        found = understand(told, below, language)
    return replace(found, confidence=min(found.confidence, sure))


def _clear(found: Understanding) -> bool:
    vague = any(isinstance(act, Inform | Unknown) for act in found.acts)
    return found.confidence >= SAFETY.act_confidence and not vague
