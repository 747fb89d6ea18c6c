"""Taps: each is one fixed step, however fast they follow one another; a held key is many taps.

A terminal does not tell a key that is held from one that is tapped often: it repeats it. So each
time it is seen counts, and the hand goes one step for it, no more and no less.
"""

from __future__ import annotations

from collections import deque

import numpy as np

SIZES = ((0.001, 0.5), (0.002, 1.0), (0.005, 2.0), (0.010, 5.0), (0.020, 10.0))
"""What a tap does, m and degrees, from the finest."""
USUAL, FINE = 2, 1
LEAST, MOST, MOST_M = 3, 30, 0.06
"""Who holds a key that repeats faster than the hand goes is not to wait for it afterwards."""
AT_ONCE_TICKS = 1
"""What comes so soon behind another tap is typed ahead, or pasted: no key repeats so fast."""


class Steps:
    """Steps that are still to be gone, and how large one is."""

    def __init__(self) -> None:
        self.waiting: deque[str] = deque()
        self._level, self._tick = USUAL, -2

    @property
    def level(self) -> int:
        """Which of the sizes is chosen."""
        return self._level

    def size(self, *, near: bool) -> tuple[float, float]:
        """Return how large a step is, m and rad; near a thing it is a fine one."""
        step_m, deg = SIZES[min(self._level, FINE) if near else self._level]
        return step_m, float(np.deg2rad(deg))

    def change(self, by: int) -> None:
        """Choose a larger or a finer step."""
        self._level = min(max(self._level + by, 0), len(SIZES) - 1)

    def take(self, key: str, tick: int) -> None:
        """Take a tap; what is typed or pasted at once all counts."""
        step_m = SIZES[self._level][0]
        most = MOST if self._level <= USUAL else max(round(MOST_M / step_m), LEAST)
        if tick - self._tick <= AT_ONCE_TICKS or len(self.waiting) < most:
            self.waiting.append(key)
        self._tick = tick

    def clear(self) -> None:
        """Forget what is still to be gone."""
        self.waiting.clear()
