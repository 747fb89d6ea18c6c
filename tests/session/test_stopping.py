"""Stopping goes beside language and the queue, and latches."""

from __future__ import annotations

from pathlib import Path

import pytest

from assistant.model.task import primitives
from assistant.session import halting
from assistant.session.loop import Session
from assistant.session.opening import resume_session
from tests.session.lessons import Heard, opened, opening

REST_S = 0.25


@pytest.mark.parametrize("words", ["stop", "STOP!", "don't stop", "please stop it now", "halt"])
def test_raw_input_stops_before_it_is_understood(moving: tuple[Session, Heard], words: str) -> None:
    session, heard = moving
    session.raw(words)
    begun_s = session.mover.now_s
    session.rest()
    assert session.mover.now_s - begun_s <= REST_S
    assert heard.topics[-1] == "stopped.stop"
    session.hear("resume")
    assert not session.moving


@pytest.mark.parametrize("words", ["go on", "nice", "slower", "what is next?"])
def test_other_words_stop_nothing(moving: tuple[Session, Heard], words: str) -> None:
    session, _ = moving
    session.raw(words)
    assert not session.equipment.stop_flag.is_set()


def test_only_a_new_start_moves_again(moving: tuple[Session, Heard]) -> None:
    session, heard = moving
    session.hear("stop")
    session.rest()
    where = session.mover.look.hand.copy()
    session.pass_s(2.0)
    assert (session.mover.look.hand == where).all()
    session.hear("start")
    assert session.moving
    session.rest()
    assert "done.run" in heard.topics


def test_a_key_and_a_closed_window_stop_with_the_reason(moving: tuple[Session, Heard]) -> None:
    session, heard = moving
    session.halt(halting.KEY)
    session.rest()
    assert [text for line, text in heard.lines if line.act == "stopped"] != []
    assert "Ctrl-C" in heard.lines[-1][1]
    assert session.dialogue.arm == "stopped"


def test_at_rest_a_stop_word_blocks_no_later_start(tmp_path: Path) -> None:
    session = opened(tmp_path)
    session.halt(halting.KEY)
    session.hear("my bus stop is near")
    assert not session.equipment.stop_flag.is_set()
    session.close()


def test_on_the_way_home_a_stop_is_obeyed_and_told(moving: tuple[Session, Heard]) -> None:
    session, heard = moving
    for words in ("stop", "go home"):
        session.hear(words)
        session.pass_s(1.0)
    assert session.moving
    session.hear("stop")
    assert heard.topics[-2:] == ["stopped.stop.home", "ask.ready_slow"]
    begun_s = session.mover.now_s
    session.rest()
    assert session.mover.now_s - begun_s <= REST_S
    where = session.mover.look.hand.copy()
    session.pass_s(2.0)
    assert (session.mover.look.hand == where).all()
    session.hear("start")
    assert session.moving


def test_the_end_of_an_announcement_moves_nothing_that_was_halted(
    moving: tuple[Session, Heard],
) -> None:
    session, _ = moving
    session.hear("stop")
    session.rest()
    session.mover.go_on(anew=False)
    assert not session.moving


def test_a_session_taken_up_again_while_going_home_stands(
    tmp_path: Path, moving: tuple[Session, Heard]
) -> None:
    session, _ = moving
    for words in ("stop", "go home"):
        session.hear(words)
        session.pass_s(1.0)
    assert session.moving
    session.close()
    heard = Heard()
    again = resume_session(opening(tmp_path, heard), session.journal.name)
    assert not again.moving
    assert "stopped.stop.home" in heard.topics
    again.hear("start")
    assert again.moving
    again.close()


def test_what_was_let_go_is_not_let_go_again_after_a_halt(
    moving: tuple[Session, Heard],
) -> None:
    session, heard = moving
    look = session.mover.look
    for wanted in ("block", ""):
        # Until the hand has closed on it, then until the fingers are on their way apart.
        while look.held != wanted or (not wanted and look.gripper_m < 0.06):
            assert session.moving
            session.tick()
            look = session.mover.look
    heard.lines.clear()
    session.hear("pause")
    session.rest()
    session.hear("slower")
    session.hear("resume")
    session.rest()
    assert "done.run" in heard.topics
    assert not any(topic.startswith("stopped") for topic in heard.topics)
    assert session.dialogue.runs[-1].missing == ()


def test_what_was_let_go_by_a_word_is_not_gone_on_without(moving: tuple[Session, Heard]) -> None:
    session, heard = moving
    lift = [leaf.name for leaf in primitives(session.dialogue.known.task.tree)].index(
        "move up object"
    )
    while session.mover._primitive_at < lift or session.mover.look.hand[2] < 0.42:
        assert session.moving
        session.tick()
    for words in ("stop", "open the hand", "yes"):
        session.hear(words)
        session.rest()
    assert not session.mover.look.held
    where = session.mover.look.hand.copy()
    for way in ("start", "slower"):
        session.hear(way)
        if way == "slower":
            # What was corrected since is checked anew, and held back for the same reason.
            session.hear("start")
        session.rest()
        assert heard.topics[-1] == "stopped.unmet.held_anew"
        assert (session.mover.look.hand == where).all()
    session.hear("again")
    session.rest()
    assert heard.topics[-2:] == ["done.run", "ask.satisfied"]
