"""What the understanding of the teacher's next words depends on."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import question, stage
from assistant.dialogue.doubting import is_guess
from assistant.dialogue.sketch import names
from assistant.dialogue.state import Dialogue
from assistant.language.hints import hints
from assistant.model.listening import Listening
from assistant.model.robot_acts import RobotAct


def listening(dialogue: Dialogue) -> Listening:
    """Return what the understanding of the next words depends on."""
    return _listening_for(dialogue, question(dialogue))


def beneath(dialogue: Dialogue) -> Listening | None:
    """Return what words are heard for that do not answer a guess; None if none was read back."""
    if not is_guess(dialogue.pending):
        return None
    free = replace(dialogue, pending=None)
    return _listening_for(free, question(free))


def _listening_for(dialogue: Dialogue, asked: RobotAct | None) -> Listening:
    known = dialogue.known
    things = tuple(one.name for one in known.objects or ()) or tuple(known.scene.bodies)
    own: dict[str, list[str]] = hints("things", known.language)
    things = tuple(own.get(name, [name])[0] for name in things)
    return Listening(
        stage(dialogue),
        asked.asked if asked is not None else None,
        dialogue.in_motion,
        known.name,
        things,
        names(known.root),
    )
