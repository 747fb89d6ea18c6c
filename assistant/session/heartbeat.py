"""A sign of life from whoever can stop the arm: when it stays out, the arm stops.

A shell whose loop hangs can no longer take a stop word or a key. So the loop itself beats, and
the arm's tick, which runs beside it, looks whether it still does (design, safety).
"""

from __future__ import annotations

import math

from assistant.model.settings import SafetySettings
from assistant.ports import Clock

SAFETY = SafetySettings()


class Heartbeat:
    """Beaten by a shell's loop, read by the arm's tick.

    Parameters
    ----------
    clock : Clock
    within_s : float
        A loop that has not beaten for longer is lost.
    """

    def __init__(self, clock: Clock, within_s: float = SAFETY.heartbeat_s) -> None:
        self._clock, self._within_s = clock, within_s
        self._last_s = clock.now_s()
        # However long a program takes to begin, nothing moved meanwhile.
        self._looked_s = -math.inf
        self._missed: tuple[float, float] | None = None

    def beat(self) -> None:
        """Tell that the loop goes round; safe from any thread."""
        now_s = self._clock.now_s()
        if now_s - self._last_s > self._within_s:
            self._missed = (self._last_s, now_s)
        self._last_s = now_s

    def alive(self) -> bool:
        """Return whether the loop has beaten all the time since this was last asked.

        A program that was suspended as a whole is back before anyone can look: that it was away
        counts, if there was something to look after when it went.
        """
        now_s = self._clock.now_s()
        looked_s, self._looked_s = self._looked_s, now_s
        missed, self._missed = self._missed, None
        if missed is not None and missed[0] <= looked_s < missed[1]:
            return False
        return now_s - self._last_s <= self._within_s
