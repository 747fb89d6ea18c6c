"""Real time for a live conversation: the arm ticks beside the teacher's typing."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

from assistant.session.loop import Session

PERIOD_S = 0.02
"""The control period; a tick that took longer is not made up for."""


class RealClock:
    """The clock on the wall, as the session's Clock port."""

    def __init__(self) -> None:
        self._began_s = time.monotonic()

    def now_s(self) -> float:
        """Return seconds since the session began."""
        return time.monotonic() - self._began_s

    def pass_s(self, seconds: float) -> None:
        """Wait."""
        time.sleep(max(seconds, 0.0))


class Ticker:
    """Ticks a session's arm in real time while it moves.

    Words and ticks take turns by `lock`; the stop flag waits for neither.

    Parameters
    ----------
    session : Session
    failed : callable
        Told an error that ended the ticking.
    pace : float
        How many simulated seconds pass in a real one.
    """

    def __init__(
        self, session: Session, failed: Callable[[BaseException], None], pace: float = 1.0
    ) -> None:
        self._period_s = PERIOD_S / pace
        self.lock = threading.RLock()
        self._session = session
        self._failed = failed
        self._over = threading.Event()
        self._clock = RealClock()
        self._thread = threading.Thread(target=self._run, name="ticker", daemon=True)

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def stop(self) -> None:
        """End, and wait until the last tick is over."""
        self._over.set()
        if self._thread.is_alive() and self._thread is not threading.current_thread():
            self._thread.join()

    def _run(self) -> None:
        try:
            while not self._over.is_set():
                began_s = self._clock.now_s()
                if self._session.moving:
                    with self.lock:
                        self._session.tick()
                self._clock.pass_s(self._period_s - (self._clock.now_s() - began_s))
        except BaseException as error:
            self._failed(error)
