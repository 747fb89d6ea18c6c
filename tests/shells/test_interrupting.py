"""An interrupt is told to the program, and ends nothing."""

from __future__ import annotations

import signal

import pytest

from assistant.shells.interrupting import interrupts


def test_an_interrupt_is_taken_and_only_as_long_as_it_is_meant_to() -> None:
    told: list[str] = []
    with interrupts(lambda: told.append("stop")):
        signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)
    assert told == ["stop", "stop"]
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)
