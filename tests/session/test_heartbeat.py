"""A shell that gives no sign of life while the arm moves stops it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from assistant.session.heartbeat import SAFETY, Heartbeat
from assistant.session.loop import Session
from tests.session.lessons import Heard, opened, until_it_moves

TICK_S = 0.02


class HandClock:
    """Time that passes by hand."""

    def __init__(self) -> None:
        self.at_s = 100.0

    def now_s(self) -> float:
        return self.at_s

    def pass_s(self, seconds: float) -> None:
        self.at_s += seconds


@pytest.fixture
def clock() -> HandClock:
    return HandClock()


@pytest.fixture
def moving(tmp_path: Path) -> Iterator[tuple[Session, Heard]]:
    """A session whose arm has just begun to move."""
    heard = Heard()
    session = opened(tmp_path, heard)
    until_it_moves(session)
    heard.lines.clear()
    yield session, heard
    session.close()


def test_a_heart_is_alive_for_as_long_as_it_says(clock: HandClock) -> None:
    heart = Heartbeat(clock)
    clock.pass_s(SAFETY.heartbeat_s)
    assert heart.alive()
    clock.pass_s(0.01)
    assert not heart.alive()
    heart.beat()
    assert heart.alive()


def test_a_program_that_was_slow_to_begin_is_not_lost(clock: HandClock) -> None:
    heart = Heartbeat(clock)
    clock.pass_s(5.0)
    heart.beat()
    clock.pass_s(0.1)
    assert heart.alive()


def test_a_heart_that_was_away_while_it_was_watched_was_lost(clock: HandClock) -> None:
    heart = Heartbeat(clock)
    assert heart.alive()
    clock.pass_s(5.0)
    heart.beat()
    assert not heart.alive()
    assert heart.alive()


def test_who_thinks_for_long_at_rest_is_not_lost_when_it_moves(clock: HandClock) -> None:
    heart = Heartbeat(clock)
    assert heart.alive()
    clock.pass_s(0.5)
    heart.beat()
    clock.pass_s(30.0)
    heart.beat()
    assert heart.alive()


def test_an_arm_whose_shell_hangs_stops_and_tells_why(
    moving: tuple[Session, Heard], clock: HandClock
) -> None:
    session, heard = moving
    heart = Heartbeat(clock)
    session.in_touch = heart.alive
    for _ in range(200):
        clock.pass_s(TICK_S)
        heart.beat()
        session.tick()
    assert session.moving
    hung_s, began_s = clock.now_s(), session.mover.now_s
    while session.moving and session.mover.now_s - began_s < 5.0:
        clock.pass_s(TICK_S)
        session.tick()
    assert clock.now_s() - hung_s <= SAFETY.heartbeat_s + 0.25
    assert heard.topics.count("stopped.stop") == 1
    assert "lost touch" in heard.lines[-1][1]


def test_after_a_lost_heartbeat_only_a_new_start_moves(
    moving: tuple[Session, Heard], clock: HandClock
) -> None:
    session, heard = moving
    heart = Heartbeat(clock)
    session.in_touch = heart.alive
    clock.pass_s(10.0)
    session.rest()
    assert session.dialogue.arm == "stopped"
    heart.beat()
    session.pass_s(1.0)
    assert not session.moving
    session.hear("start")
    assert session.moving
    session.rest()
    # Nobody beat any more, but no time passed on the clock either.
    assert "done.run" in heard.topics


def test_at_rest_a_lost_heartbeat_is_nothing(tmp_path: Path) -> None:
    heard = Heard()
    session = opened(tmp_path, heard)
    session.in_touch = lambda: False
    heard.lines.clear()
    session.tick()
    session.close()
    assert heard.lines == []
    assert not session.equipment.stop_flag.is_set()
