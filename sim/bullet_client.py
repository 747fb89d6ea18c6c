"""PyBullet, imported without its greeting, and a connection that is closed with its owner."""

from __future__ import annotations

import contextlib
import ctypes
import os
import sys
import tempfile
import weakref
from collections.abc import Iterator
from typing import Any

GREETING = b"pybullet build time"
"""Begins the library's line about itself, which it writes to stderr."""


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Keep the library's talk from stdout, and its greeting from stderr; errors are passed on.

    Its words are written by C code straight to the file descriptors.
    """
    sys.stdout.flush()
    sys.stderr.flush()
    kept = os.dup(1), os.dup(2)
    with tempfile.TemporaryFile() as said:
        try:
            with open(os.devnull, "wb") as nowhere:
                os.dup2(nowhere.fileno(), 1)
                os.dup2(said.fileno(), 2)
            yield
        finally:
            # C keeps what it wrote in a buffer of its own where stdout is no terminal.
            ctypes.CDLL(None).fflush(None)
            for descriptor, copy in enumerate(kept, start=1):
                os.dup2(copy, descriptor)
                os.close(copy)
            said.seek(0)
            told = [line for line in said if not line.startswith(GREETING)]
            os.write(2, b"".join(told))


with _quiet():
    import pybullet as bullet

LostError: type[Exception] = bullet.error
"""What calls raise once a server is gone, such as a window that was closed."""


class Client:
    """One physics server; attributes are PyBullet's functions bound to it.

    Parameters
    ----------
    window : bool
        Show it; otherwise it runs without any display.
    """

    def __init__(self, *, window: bool = False) -> None:
        with _quiet():
            self.id: int = bullet.connect(bullet.GUI if window else bullet.DIRECT)
            # At the latest when the program ends, while it still can be done in silence.
            self._leave = weakref.finalize(self, _left, self.id)
            if window:
                self.configureDebugVisualizer(bullet.COV_ENABLE_GUI, 0)
                self.resetDebugVisualizerCamera(1.5, 55.0, -25.0, (0.35, 0.0, 0.4))
                # It tells of its graphics with the first picture, from a thread of its own.
                self.getCameraImage(8, 8)

    def __getattr__(self, name: str) -> Any:
        function = getattr(bullet, name)
        if not callable(function):
            return function

        def bound(*args: Any, **named: Any) -> Any:
            return function(*args, physicsClientId=self.id, **named)

        setattr(self, name, bound)
        return bound

    def close(self) -> None:
        """Leave the server; a second time does nothing."""
        self._leave()


def _left(number: int) -> None:
    # A window says good-bye on stdout, too.
    with _quiet(), contextlib.suppress(bullet.error):
        bullet.disconnect(physicsClientId=number)
