"""A showing by keys from beginning to end, and from the beginning again for who wants that."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from typing import Any

from assistant.language.hints import page
from assistant.language.speech import in_words
from assistant.session.loop import Session
from assistant.session.stepping_in import step_in
from assistant.shells.keys import Driving

FORGOTTEN = "awaitingshow"
"""Where the dialogue stands when what was shown was thrown away."""


def lead(
    session: Session,
    lock: AbstractContextManager[Any],
    every_s: float,
    write: Callable[[str], None],
) -> None:
    """Let the teacher drive the hand until the task is shown, or something else is wanted.

    Parameters
    ----------
    session : Session
        Watching.
    lock : context manager
        Held while the session takes anything in.
    every_s : float
        Between recorded samples.
    write : callable
        Takes what is told beside the robot's lines.
    """
    words = page("terminal", session.language)
    while session.equipment.driver is not None:
        with lock:
            there = step_in(session)
        if session.equipment.stop_flag.is_set():
            session.equipment.stop_flag.clear()
            write(words["at_rest"])
            return
        if not there:
            write(words["driving"]["not_there"])
        if not _driven(session, lock, every_s, write):
            return
        with lock:
            session.hear(words["for_teacher"]["begin"])
        if session.watching is None:
            return
    write(words["no_keys"])


def _driven(
    session: Session,
    lock: AbstractContextManager[Any],
    every_s: float,
    write: Callable[[str], None],
) -> bool:
    """Show once; return whether it is to be shown anew."""
    words, mover, driver = (
        page("terminal", session.language),
        session.mover,
        session.equipment.driver,
    )
    assert driver is not None
    hand = driver(session.equipment.arm, session.equipment.planner, mover.scene, mover.setup)
    watching = session.watching
    write(words["driving"]["begin"])
    driving = Driving(session, hand, lock, every_s)
    driving.run()
    if session.dialogue_view["state"] == FORGOTTEN:
        return driving.anew
    if watching is not None:
        shown_s = in_words(round(watching.now_s, 1), session.language)
        write(words["driving"]["end"].format(seconds=shown_s))
    return False
