"""Real time for a live conversation: the arm ticks beside the teacher's typing."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

from assistant.model.motion import ArmReport, JointPath
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import Arm, ArmLook, Clock
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


class PacedArm:
    """An arm that can be watched: no tick of it ends before its time on the wall.

    Parameters
    ----------
    arm : Arm
    clock : Clock
    """

    def __init__(self, arm: Arm, clock: Clock) -> None:
        self._arm, self._clock = arm, clock
        self._due_s = clock.now_s()

    def arrange(self, scene: Scene, setup: Setup) -> None:
        """Put arm and bodies at their places."""
        self._arm.arrange(scene, setup)

    def look(self) -> ArmLook:
        """Return what is measured now."""
        return self._arm.look()

    def start(self, motion: JointPath) -> None:
        """Begin to carry out a checked motion, from now on."""
        self._arm.start(motion)
        self._due_s = self._clock.now_s()

    def tick(self) -> tuple[ArmReport, ...]:
        """Advance by one control period, in real time; what took longer is not made up for."""
        told = self._arm.tick()
        now_s = self._clock.now_s()
        self._due_s = max(self._due_s + PERIOD_S, now_s)
        self._clock.pass_s(self._due_s - now_s)
        return told

    def stop(self, why: str) -> None:
        """Brake now."""
        self._arm.stop(why)


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
