"""Lines of input with a beating heart: whoever waits for them shows that it still waits."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable, Iterable, Iterator

BEAT_S = 0.2
"""Between beats while nothing is typed."""


def beating(
    lines: Iterable[str], beat: Callable[[], None], see: Callable[[str], object]
) -> Iterator[str]:
    """Yield lines as they come, beating while there are none.

    Parameters
    ----------
    lines : iterable of str
        Read in a thread of its own, since reading waits.
    beat : callable
        Called a few times a second by whoever takes the lines.
    see : callable
        Shown each line as soon as it is there, while the one before is still being answered.

    Raises
    ------
    Exception
        Whatever reading raised.
    """
    read: queue.Queue[str | None] = queue.Queue()
    failed: list[Exception] = []

    def fetch() -> None:
        try:
            for line in lines:
                see(line)
                read.put(line)
        except Exception as error:
            failed.append(error)
        finally:
            read.put(None)

    threading.Thread(target=fetch, name="input", daemon=True).start()
    while True:
        beat()
        try:
            line = read.get(timeout=BEAT_S)
        except queue.Empty:
            continue
        if line is None:
            break
        yield line
        beat()
    if failed:
        raise failed[0]
