"""What the fingers are told, one control tick at a time: to close or open, to press, to ease."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sim.a465 import GRIPPER
from sim.world import CONTROL_S, EASE_S, EASED, STILL_M, STILL_TICKS

ACTING_S = 3.0
"""The gripper is done within this time, or something is wrong."""
PRESSED_M = 1e-3
"""Fingers that hold a body are told to close by so much more than they are: enough to press with
all their force, while they follow a body that gives way no faster than 40 mm/s."""
PARTED_M = 4e-4
"""Fingers that leave a body which stands already are told so much more than they are open."""


@dataclass(slots=True)
class Grip:
    """Commands to the fingers.

    Parameters
    ----------
    opening_m : float
        The opening they are to have.
    share : float
        Of the full force; below 1 while the grip is eased before opening.
    acting_s : float
        How long they have been closing or opening; 0 while nothing is done.
    """

    opening_m: float = GRIPPER.open_m
    share: float = 1.0
    acting_s: float = 0.0
    _still: int = 0
    _last_m: float = np.inf

    def rest(self) -> None:
        """Be done with closing or opening; what is commanded stays."""
        self.share, self.acting_s, self._still, self._last_m = 1.0, 0.0, 0, np.inf

    def press(self, measured_m: float) -> None:
        """Hold on to what is between the fingers."""
        self.opening_m = max(measured_m - PRESSED_M, 0.0)

    def part(self, measured_m: float) -> None:
        """Leave what stands between the fingers: pads that rest on it turn it to lie along them."""
        self.opening_m = min(measured_m + PARTED_M, GRIPPER.open_m)

    def ease(self) -> None:
        """Press less hard, by one tick's share."""
        self.share = max(EASED, self.share - CONTROL_S / EASE_S)

    def act(self, measured_m: float, *, closing: bool) -> bool:
        """Close or open by one tick and return whether the fingers have come to rest."""
        if self.acting_s == 0.0:
            # From where the fingers are, not from where a closed hand without a body would be.
            self.opening_m = measured_m
        self.acting_s += CONTROL_S
        if not closing and self.share > EASED:
            self.ease()
            return False
        # The command is a ramp, so that the fingers meet the body slowly.
        step, goal = GRIPPER.speed_m_s * CONTROL_S, 0.0 if closing else GRIPPER.open_m
        self.opening_m += float(np.clip(goal - self.opening_m, -step, step))
        moved, self._last_m = abs(measured_m - self._last_m), measured_m
        self._still = self._still + 1 if moved < STILL_M else 0
        return self._still >= STILL_TICKS or self.acting_s >= ACTING_S
