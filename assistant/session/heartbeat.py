"""A sign of life from whoever can stop the arm: when it stays out, the arm stops.

A shell whose loop hangs can no longer take a stop word or a key. So the loop itself beats, and
the arm's tick, which runs beside it, looks whether it still does (design, safety).
"""

from __future__ import annotations

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

    def beat(self) -> None:
        """Tell that the loop goes round; safe from any thread."""
        self._last_s = self._clock.now_s()

    @property
    def alive(self) -> bool:
        """Whether the last beat is not too long ago."""
        return self._clock.now_s() - self._last_s <= self._within_s
