"""A stop that is typed while the robot is at work is taken then; other lines wait their turn."""

from __future__ import annotations

import os
import threading

from assistant.shells.overhearing import Overhearing


def overheard(lines: str, stops: str) -> tuple[list[str], list[str]]:
    """Return what was taken at once and what waits, of lines typed during a piece of work."""
    taken: list[str] = []
    all_read = threading.Event()

    def take(text: str) -> bool:
        if text == "end":
            all_read.set()
        elif text == stops:
            taken.append(text)
        return text in (stops, "end")

    source, typed = os.pipe()
    with Overhearing(source, take) as beside:
        os.write(typed, f"{lines}end\n".encode())
        assert all_read.wait(5.0)
    os.close(typed)
    os.close(source)
    return taken, beside.lines


def test_a_stop_is_taken_while_the_work_goes_on_and_nothing_else_is_lost() -> None:
    assert overheard("what takes so long?\nstop\nyes\n", "stop") == (
        ["stop"],
        ["what takes so long?", "yes"],
    )


def test_where_no_terminal_is_nothing_is_read() -> None:
    with Overhearing(None, lambda text: True) as beside:
        pass
    assert beside.lines == []


def test_an_input_that_ends_ends_the_reading() -> None:
    source, typed = os.pipe()
    os.close(typed)
    with Overhearing(source, lambda text: True) as beside:
        pass
    os.close(source)
    assert beside.lines == []


def test_a_line_that_is_not_ended_is_kept_for_the_next_prompt() -> None:
    all_read = threading.Event()
    source, typed = os.pipe()

    def take(text: str) -> bool:
        all_read.set()
        return text == "end"

    with Overhearing(source, take) as beside:
        os.write(typed, b"end\rthe tea ")
        assert all_read.wait(5.0)
    os.close(typed)
    os.close(source)
    assert (beside.lines, beside.begun) == ([], "the tea ")
