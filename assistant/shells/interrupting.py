"""Ctrl-C while no line is being typed: the program is told, and goes on."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType


@contextmanager
def interrupts(take: Callable[[], None]) -> Iterator[None]:
    """Hand each interrupt to `take` instead of ending the program.

    Between two lines the terminal itself turns Ctrl-C into an interrupt: whoever wants the arm to
    stop presses it whether a line is open or not. For the main thread.
    """

    def taken(number: int, frame: FrameType | None) -> None:
        take()

    before = signal.signal(signal.SIGINT, taken)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
