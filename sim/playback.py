"""Where an arm is along its motion: full pace, resting at a station, or braking on the path.

Braking slows time along the checked path instead of leaving it, so that nothing new has to be
checked while stopping; the pace falls as fast as the joints' accelerations allow.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from assistant.geometry import Array, interpolate
from assistant.model.motion import ArmReport, HandStop, JointPath
from sim import a465
from sim.kinematics import forward
from sim.world import CONTROL_S

STANDS_RAD = 1e-4
"""A tenth of a millimetre or less from its station the hand counts as standing there."""
RESTS_RAD = 1e-5
"""Closer than this it does not matter whether what is let go comes along."""


@dataclass(slots=True)
class Playback:
    """A motion being carried out.

    Parameters
    ----------
    motion : JointPath
        Sampled once a control tick.
    """

    motion: JointPath
    at: float = 0.0
    pace: float = 1.0
    hands: Array = field(init=False)
    pending: list[HandStop] = field(init=False)
    _slowing: float = 0.0

    def __post_init__(self) -> None:
        self.hands = forward(self.motion.q)
        acting = [stop for stop in self.motion.stops if stop.kind != "touch"]
        self.pending = sorted(acting, key=lambda stop: stop.at)

    @property
    def sample(self) -> int:
        """The last sample reached."""
        return int(self.at)

    @property
    def stands(self) -> bool:
        """Whether the hand already rests at the next station, waiting for the gripper's time.

        It waits for its primitive, too: what has to hold before that is held until it has begun.
        """
        return self._within(STANDS_RAD)

    @property
    def rests(self) -> bool:
        """Whether it is so close to the next station that it may let go already."""
        return self._within(RESTS_RAD)

    def _within(self, most_rad: float) -> bool:
        if not self.pending or self.sample >= self.pending[0].at:
            return bool(self.pending)
        primitive = self.motion.primitive_at
        if primitive[max(self.sample - 1, 0)] != primitive[self.pending[0].at]:
            return False
        way = self.motion.q[self.sample : self.pending[0].at + 1]
        return bool(np.max(np.abs(way - way[-1])) < most_rad)

    @property
    def over(self) -> bool:
        """Whether the end of the motion is reached."""
        return self.sample >= len(self.motion.t_s) - 1

    @property
    def at_station(self) -> bool:
        """Whether the hand stands where the gripper is to act next."""
        return bool(self.pending) and self.sample >= self.pending[0].at

    def replace(self, motion: JointPath) -> None:
        """Go on along a corrected motion of the same samples."""
        self.motion, self.hands = motion, forward(motion.q)

    def brake(self) -> None:
        """Begin to slow down, as fast as the joints allow."""
        if not self._slowing:
            speed = np.abs(self._speed()) * self.pace
            longest = float(np.max(speed / a465.ACCELERATIONS))
            self._slowing = CONTROL_S / max(longest, CONTROL_S)

    @property
    def braking(self) -> bool:
        """Whether the motion is being brought to rest."""
        return self._slowing > 0.0

    @property
    def at_rest(self) -> bool:
        """Whether braking has ended."""
        return self.braking and self.pace <= 0.0

    def advance(self) -> None:
        """Move on by one control tick, but not past a station or the end."""
        self.pace = max(0.0, self.pace - self._slowing)
        last = len(self.motion.t_s) - 1
        bound = min(self.pending[0].at, last) if self.pending else last
        self.at = min(self.at + self.pace, float(max(bound, self.sample)))

    def now(self) -> tuple[Array, Array]:
        """Return joint angles, shape (6,), and flange pose, shape (7,), to be at."""
        low = self.sample
        share = self.at - low
        if share == 0.0:
            return self.motion.q[low], self.hands[low]
        q = (1.0 - share) * self.motion.q[low] + share * self.motion.q[low + 1]
        return q, interpolate(self.hands[low], self.hands[low + 1], np.array(share))

    def _speed(self) -> Array:
        low = min(self.sample, len(self.motion.t_s) - 2)
        if low < 0 or math.isclose(self.at, len(self.motion.t_s) - 1):
            return np.zeros(a465.JOINTS)
        return np.asarray((self.motion.q[low + 1] - self.motion.q[low]) / CONTROL_S)


def planned_reports(motion: JointPath) -> list[tuple[int, ArmReport]]:
    """Return what is to be told when the samples of a motion are reached, in order."""
    told: list[tuple[int, ArmReport]] = []
    for stop in motion.stops:
        if not stop.frame:
            continue
        told.append((stop.docking_at, ArmReport("perceived", 0.0, -1, "docked", stop.frame)))
        if stop.kind == "release":
            told.append((stop.left_at, ArmReport("perceived", 0.0, -1, "clear", stop.object)))
    return sorted(told, key=lambda pair: pair[0])
