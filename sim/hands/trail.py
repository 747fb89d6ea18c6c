"""The way a driven hand came, move by move, so that it can be gone back."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from assistant.geometry import Array

SAME_RAD = 1e-7
PAUSE_S = 0.6
"""Taps of one key belong to one move unless the teacher pauses for longer."""


@dataclass(slots=True)
class Move:
    """What one key, or one drag of the mouse, did.

    Parameters
    ----------
    what : str
        The key; of a drag the clutch's.
    begin_s : float
        On the demonstration's clock.
    joints : list of array, shape (6,)
        One a tick in which the arm moved, the first before it did.
    """

    what: str
    begin_s: float
    joints: list[Array] = field(default_factory=list)
    last_s: float = 0.0


class Trail:
    """All moves that were not taken back."""

    def __init__(self) -> None:
        self._moves: list[Move] = []

    def begin(self, what: str, q: Array, now_s: float, *, single: bool = False) -> None:
        """Take note of what is done from now on; more of the same goes on with a move."""
        last = self._moves[-1] if self._moves else None
        same = last is not None and last.what == what and now_s - last.last_s < PAUSE_S
        if single or not same:
            self._moves.append(Move(what, now_s, [np.array(q)], now_s))

    def see(self, q: Array, now_s: float) -> None:
        """Take where the arm is now."""
        if self._moves and np.abs(q - self._moves[-1].joints[-1]).max() > SAME_RAD:
            self._moves[-1].joints.append(np.array(q))
            self._moves[-1].last_s = now_s

    def pop(self) -> Move | None:
        """Return the last move, which is taken back; None if there is none."""
        return self._moves.pop() if self._moves else None
