"""Waiting for input is a sign of life."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest

from assistant.shells.beating import beating


def nothing(line: str = "") -> None:
    pass


def test_lines_come_in_order_and_end() -> None:
    assert list(beating(["a", "b"], nothing, nothing)) == ["a", "b"]


def test_it_beats_while_nothing_is_typed() -> None:
    typed, beats = threading.Event(), 0

    def lines() -> Iterator[str]:
        assert typed.wait(20.0)
        yield "hello"

    def beat() -> None:
        nonlocal beats
        beats += 1
        if beats == 3:
            typed.set()

    assert list(beating(lines(), beat, nothing)) == ["hello"]
    assert beats >= 3


def test_a_line_is_seen_while_the_one_before_is_answered() -> None:
    seen = threading.Event()

    def see(line: str) -> None:
        if line == "stop":
            seen.set()

    for line in beating(["go", "stop"], nothing, see):
        if line == "go":
            assert seen.wait(20.0)


def test_who_answers_for_long_does_not_beat_meanwhile() -> None:
    beats = 0

    def beat() -> None:
        nonlocal beats
        beats += 1

    taken = iter(beating(["go", "on"], beat, nothing))
    next(taken)
    before = beats
    threading.Event().wait(0.0)
    assert beats == before


def test_input_that_breaks_is_told_after_what_came_before() -> None:
    def lines() -> Iterator[str]:
        yield "a"
        raise OSError("unplugged")

    taken = beating(lines(), nothing, nothing)
    assert next(taken) == "a"
    with pytest.raises(OSError, match="unplugged"):
        next(taken)
