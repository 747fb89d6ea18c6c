"""An interrupt is told to the program, and ends nothing."""

from __future__ import annotations

import signal
from collections.abc import Iterator

import pytest

from assistant.shells.interrupting import interrupts


@pytest.fixture
def interruptible() -> Iterator[None]:
    """Take interrupts as usual, even where the tests were started so that they ignore them."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("interruptible")
def test_an_interrupt_is_taken_and_only_as_long_as_it_is_meant_to() -> None:
    told: list[str] = []
    with interrupts(lambda: told.append("stop")):
        signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)
    assert told == ["stop", "stop"]
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)
