"""What is typed while the robot is at work: a stop is taken at once, the rest waits its turn."""

from __future__ import annotations

import os
import select
import sys
import threading
from collections.abc import Callable
from types import TracebackType

GLANCE_S = 0.1
CHUNK = 4096


class Overhearing:
    """Reads lines beside long work; a context of one piece of work.

    Between two prompts the terminal hands over whole lines by itself, and what is not read here
    is there for the next prompt.

    Parameters
    ----------
    source : int or None
        The file descriptor typed lines come from; with None nothing is read.
    take : callable
        Looks at a line before anything else does; returns whether that was all it wanted.
    """

    def __init__(self, source: int | None, take: Callable[[str], bool]) -> None:
        self._source, self._take = source, take
        self._over = threading.Event()
        self._thread: threading.Thread | None = None
        self._rest = b""
        self.lines: list[str] = []

    def __enter__(self) -> Overhearing:
        if self._source is not None:
            self._thread = threading.Thread(target=self._read, name="overhearing", daemon=True)
            self._thread.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        where: TracebackType | None,
    ) -> None:
        self._over.set()
        if self._thread is not None:
            self._thread.join()

    @property
    def begun(self) -> str:
        """What was typed of a line that is not ended yet."""
        return "".join(one for one in self._rest.decode("utf-8", "replace") if one.isprintable())

    def _read(self) -> None:
        assert self._source is not None
        while not self._over.is_set():
            ready, _, _ = select.select([self._source], [], [], GLANCE_S)
            if not ready or self._over.is_set():
                continue
            chunk = os.read(self._source, CHUNK)
            if not chunk:
                return
            *lines, self._rest = (self._rest + chunk).replace(b"\r", b"\n").split(b"\n")
            for line in lines:
                text = line.decode("utf-8", "replace").strip()
                if text and not self._take(text):
                    self.lines.append(text)


def typed_lines() -> int | None:
    """Return where whole lines come from between two prompts; None if that is no terminal."""
    return sys.stdin.fileno() if sys.stdin.isatty() else None
