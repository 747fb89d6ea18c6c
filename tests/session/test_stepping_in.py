"""Before a step is shown again, arm and things are where it began."""

from __future__ import annotations

from pathlib import Path

import pytest

from assistant.dialogue.one_step import ended_at, stretch
from assistant.geometry import distance_between
from assistant.model.transcript import Demonstrate
from assistant.session.acting import demonstrate
from assistant.session.loop import Session
from assistant.session.stepping_in import step_in
from tests.session.lessons import Heard, lesson, opened

STEP = "move up object"


def asked_again(tmp_path: Path, heard: Heard) -> Session:
    """Return a session that watches one step for the second time."""
    session = opened(tmp_path, heard)
    for _ in lesson(session):
        if session.dialogue.known.reviewed:
            break
    session.hear("let me show you moving up again")
    session.hear("yes")
    return session


def test_the_arm_holds_what_it_held_where_the_step_began(tmp_path: Path) -> None:
    session = asked_again(tmp_path, Heard())
    known = session.dialogue.known
    found = stretch(known, STEP)
    assert found is not None
    assert session.dialogue_view["step_shown"] == STEP
    assert step_in(session)
    look, shown = session.mover.look, known.demonstrations[-1].recording
    began = shown.path[int((shown.t_s < found.from_s).sum()) - 1]
    assert look.held == "block"
    assert float(distance_between(look.hand, began)) < 2e-3
    ended = ended_at(known, STEP)
    assert ended is not None
    assert ended[2] > look.hand[2] + 0.02
    session.close()


def test_a_stop_on_the_way_there_is_obeyed(tmp_path: Path) -> None:
    session = asked_again(tmp_path, Heard())
    session.equipment.stop_flag.set()
    assert not step_in(session)
    assert not session.moving
    session.close()


def test_a_whole_scripted_showing_gives_just_that_step(tmp_path: Path) -> None:
    heard = Heard()
    session = asked_again(tmp_path, heard)
    before = session.dialogue.known.lesson
    demonstrate(session, Demonstrate(seed=3, cues=None), tmp_path)
    assert "done.step_shown" in heard.topics
    after = session.dialogue.known.lesson
    assert before is not None
    assert after is not None
    olds, news = before.segmentation.episodes, after.segmentation.episodes
    assert [one.primitive for one in news] == [one.primitive for one in olds]
    at = [one.primitive for one in olds].index(STEP)
    assert [one.to_s for one in news[:at]] == pytest.approx([one.to_s for one in olds[:at]])
    lasts = [[one.to_s - one.from_s for one in found[at + 1 :]] for found in (olds, news)]
    assert lasts[1] == pytest.approx(lasts[0], abs=0.05)
    session.close()
