"""What is typed while the hand is driven: markers are for the robot, questions for the keys."""

from __future__ import annotations

import re
from typing import Literal

from assistant.model import teacher_acts as acts
from assistant.session.loop import Session

Wish = Literal["say", "help", "back", "anew"]
"""To tell the robot, to be helped, to take the last move back, to show it from the beginning."""
SURE = 0.6
PARTS = re.compile(r"[,.;:!?]+\s*|\s+(?:but|so|and|aber|also|und)\s+")


def wish(session: Session, text: str) -> tuple[Wish, str]:
    """Return what words ask for, and the part of them that does.

    A complaint may come before what is wanted: "I closed it too high, can I start over".
    """
    parts = [part for part in PARTS.split(text) if part.strip()]
    for part in (text, *reversed(parts)):
        found = _asked(session, part)
        if found is not None:
            return found, part
    # Whoever asks something does not tell what is being shown.
    return ("help" if text.rstrip().endswith("?") else "say"), text


def _asked(session: Session, text: str) -> Wish | None:
    understood = session.understood(text)
    for act in understood.acts:
        match act:
            case acts.GoBack("demonstration") | acts.Again() if understood.confidence >= SURE:
                return "anew"
            case acts.Undo() if understood.confidence >= SURE:
                return "back"
            case acts.Help() | acts.Explain():
                return "help"
            case _:
                pass
    return None
