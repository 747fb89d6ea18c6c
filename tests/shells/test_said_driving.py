"""Words typed while the hand is driven: told to the robot, or asked of the keys."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from assistant.session.loop import Session
from assistant.shells.said_driving import wish
from tests.session.lessons import lesson, opened


@pytest.fixture(scope="module")
def watching(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Session]:
    session = opened(Path(tmp_path_factory.mktemp("home")))
    for _ in lesson(session):
        if session.watching is not None:
            break
    yield session
    session.close()


@pytest.mark.parametrize(
    ("text", "asked"),
    [
        ("next step", "say"),
        ("first step", "say"),
        ("finished", "say"),
        ("look, the block is in the hand now", "say"),
        ("help", "help"),
        ("how do i open it?", "help"),
        ("what can i do here", "help"),
        ("where am i going wrong?", "help"),
        ("start over", "anew"),
        ("can i start over", "anew"),
        ("can i start over?", "anew"),
        ("i closed the hand too high, can i start over", "anew"),
        ("oh no that was wrong. let me start over", "anew"),
        ("undo", "back"),
        ("take that back", "back"),
        ("too far, take that back", "back"),
    ],
)
def test_what_is_typed_is_told_or_asked(watching: Session, text: str, asked: str) -> None:
    assert wish(watching, text)[0] == asked
