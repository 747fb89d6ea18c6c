from __future__ import annotations

from pathlib import Path

import pytest
from prompt_toolkit.completion import CompleteEvent
from prompt_toolkit.document import Document

from assistant.session.loop import Session
from assistant.shells.bar import bar
from assistant.shells.completing import Sayable, named
from tests.session.lessons import lesson, opened


@pytest.fixture
def told(tmp_path: Path) -> Session:
    session = opened(tmp_path)
    for words in ("pick and place", "no goal", "the block and the target", "two"):
        session.hear(words)
    for words in ("pick up object", "place object"):
        session.hear(words)
    return session


def completed(session: Session, typed: str) -> list[str]:
    event = CompleteEvent(completion_requested=True)
    document = Document(typed)
    return [
        typed[: len(typed) + one.start_position] + one.text
        for one in Sayable(session).get_completions(document, event)
    ]


def test_names_of_the_task_complete_a_half_typed_sentence(told: Session) -> None:
    assert "remove pick up object" in completed(told, "remove pi")
    assert "where is the target" in completed(told, "where is the ta")
    assert completed(told, "pick up object") != ["pick up object"]
    told.close()


def test_a_name_is_completed_from_where_a_word_begins() -> None:
    (one,) = named("rename ap", ["approach object", "grasp"])
    assert (one.text, one.start_position) == ("approach object", -2)
    assert list(named("snap", ["approach"])) == []


def test_the_bar_tells_stage_task_and_arm(told: Session) -> None:
    assert bar(told) == " introduction | pick and place | arm at rest "
    told.close()


def test_the_bar_of_a_moving_arm_tells_the_time_left(tmp_path: Path) -> None:
    session = opened(tmp_path)
    for _ in lesson(session):
        if session.watching is not None:
            assert bar(session).endswith("| watching, 0 s ")
        if session.moving:
            session.pass_s(0.5)
            break
    left_s = session.mover.left_s
    assert 1.0 < left_s < 120.0
    assert f"MOVING | about {int(left_s) + 1} s left | Ctrl-C stops" in bar(session, left_s)
    assert "approach object" in bar(session)
    session.rest()
    assert session.mover.left_s == 0.0
    session.close()
