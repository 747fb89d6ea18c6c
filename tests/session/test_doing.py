"""What takes long is told of, and can be stopped."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from assistant.session.doing import LONG_LOOKED
from assistant.session.loop import Session
from tests.session.lessons import Heard, hold, opened


def looking(session: Session, stop_at: int | None) -> list[int]:
    """Let a session find no arrangement; return how many it tries before it gives up."""
    tried: list[int] = []
    flag = session.equipment.stop_flag

    def none_found(
        task: Task, scene: Scene, setup: Setup, seed: int, goes_on: Callable[[int], bool]
    ) -> Setup | None:
        for drawn in range(2 * LONG_LOOKED):
            if drawn == stop_at:
                flag.set()
            if not goes_on(drawn):
                break
            tried.append(drawn)
        return None

    session.workplace.equipment = replace(session.equipment, new_setup=none_found)
    return tried


@pytest.mark.parametrize("stop_at", [None, LONG_LOOKED + 10])
def test_looking_long_for_a_setup_is_told_and_can_be_stopped(
    tmp_path: Path, stop_at: int | None
) -> None:
    heard = Heard()
    session = opened(tmp_path, heard)
    hold(session)
    where = session.dialogue.known.setup
    tried = looking(session, stop_at)
    heard.lines.clear()
    session.hear("new setup")
    assert len(tried) == (stop_at or 2 * LONG_LOOKED)
    why = "refuse.no_setup" if stop_at is None else "refuse.given_up"
    assert heard.topics[:2] == ["report.still_looking", why]
    assert heard.topics[-1].startswith("ask.")
    assert session.dialogue.known.setup == where
    # A start after that is obeyed.
    session.hear("go")
    assert session.moving
    session.close()
