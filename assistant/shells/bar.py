"""The bottom bar: where the conversation stands and what the arm does."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from assistant.language.hints import page
from assistant.session.loop import Session


def bar(session: Session, left_s: float | None = None) -> str:
    """Return stage, node of the tree, what the arm does, and how long it still moves.

    Parameters
    ----------
    session : Session
    left_s : float, optional
        Of the motion, in real seconds; None where it is not known.
    """
    told = page("terminal", session.language)
    words, view = told["bar"], session.dialogue_view
    stage = session.listening.stage
    node = str(view.get("at") or session.listening.task or words["no_task"])
    parts = (str(told["stages"].get(stage, stage)), node, *_arm(session, view, words, left_s))
    return f" {' | '.join(parts)} "


def _arm(
    session: Session, view: Mapping[str, Any], words: Mapping[str, Any], left_s: float | None
) -> tuple[str, ...]:
    if session.watching is not None:
        return (str(words["watching"]).format(seconds=f"{session.watching.now_s:.0f}"),)
    if not session.moving:
        return (str(words.get(str(view.get("motion")), words["rest"])),)
    told = [str(words["paused" if view.get("motion") == "paused" else "moving"])]
    if left_s is not None:
        told.append(str(words["left"]).format(seconds=math.ceil(left_s)))
    return (*told, str(words["stop"]))
