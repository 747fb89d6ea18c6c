"""A new task is begun with the same things on the table."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import ask
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.state import Dialogue, Introducing
from assistant.dialogue.turn import Turn, changed, first, line, say


def fresh(dialogue: Dialogue) -> Turn:
    """Begin another task with the same things on the table; undo brings the old one back."""
    known = dialogue.known
    empty = Knowledge(
        scene=known.scene,
        setup=known.setup,
        facing=known.facing,
        shaped=known.shaped,
        language=known.language,
    )
    begun = replace(
        changed(dialogue, "fresh", empty),
        state=Introducing("task_name"),
        arm="rest",
        pace="slow",
        run=None,
        runs=(),
        refusal=None,
        pending=None,
        saved_as="",
        unsaved=False,
        agreed=False,
    )
    return first(say(begun, line("told", "fresh"))[1], ask(begun))
