"""Bringing arm and things to where one step begins, so that the teacher can show it from there."""

from __future__ import annotations

from assistant.dialogue.effects import Replay
from assistant.dialogue.one_step import before_step
from assistant.dialogue.state import Watching
from assistant.session.loop import Session


def step_in(session: Session) -> bool:
    """Put everything where the demonstration to come begins; the arm is driven from there.

    Before a step that is shown again, what was shown before it is carried out, checked like any
    motion. Where that cannot be, or is stopped, the arm stays where it is.

    Returns
    -------
    bool
        Whether the hand is where it should be.
    """
    session.rest()
    mover, state = session.mover, session.dialogue.state
    ahead = None
    if isinstance(state, Watching) and state.step:
        ahead = before_step(session.dialogue.known, state.step)
    if ahead is None:
        mover.arrange(mover.scene, mover.setup)
        return True
    shown, setup = ahead
    if mover.replay(Replay(session.dialogue.known.task, shown, setup)) is not None:
        return False
    while mover.moving:
        mover.tick()
    return not session.equipment.stop_flag.is_set()
