"""A hand driven live: a short checked motion that always ends at rest, renewed as it goes on.

Nothing is led around: the hand keeps the line that is asked for, or does not go. The point
between the fingers stays on that line exactly; the hand's turn may be off by `LEAVES_RAD` while
the wrist swings through its singularity, and is right again when the hand rests. What a joint
cannot keep up with is tried more gently, then more slowly, and refused only if that does not
help either.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from assistant.geometry import (
    Array,
    compose,
)
from assistant.model.motion import JointPath, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import ArmLook
from sim import a465
from sim.driving import TIP, Asked, Driven, Pace, driven, stepped
from sim.fine_path import FinePath
from sim.kinematics import (
    forward,
    limit_margin,
)
from sim.phases import Phase, phases
from sim.tracking import PATH, STANDS_RAD, seated, tour, tracked
from sim.world import CONTROL_S
from sim.wrist import ENDS

LEAVES_RAD = math.radians(0.85)
"""The hand's turn is never further off than this: 2 mm at the flange."""
SETTLE_TICKS = 70
"""The wrist is given so long to come right once the hand stands."""
LEAVES_M = 0.0005
"""The point between the fingers is never further off its line than this."""
SETTLED_RAD = 1e-3
"""A hand at rest is right to this, also where joint 4 is kept from its end."""

PACES = (
    Pace(1.0, 1.0, 15),
    Pace(1.0, 0.3, 15),
    Pace(0.7, 0.15, 15),
    Pace(0.4, 0.15, 10),
    Pace(0.4, 1.0, 5),
    Pace(0.2, 0.1, 10),
    Pace(0.08, 0.1, 5),
    Pace(0.03, 0.1, 2),
)

Asking = Callable[[Pace], Asked]
STEPS = tuple(pace for pace in PACES if pace.ticks > 5)
"""A step that cannot be made to its end is not begun: only its haste is tried."""
SMALL_M = 0.05
SMALL_STEPS = (*STEPS, Pace(0.08, 0.1, 10), Pace(0.03, 0.05, 10))
"""With the elbow nearly straight even a small step of the hand is a great one for it."""


@dataclass(frozen=True, slots=True, eq=False)
class Jog:
    """A checked motion of a driven arm, one sample a tick, the first where it is now."""

    q: Array
    tips: Array
    speeds: Array
    off_rad: Array

    def at(self, tick: int) -> Driven:
        """Return where the arm is after so many ticks."""
        tick = min(tick, len(self.q) - 1)
        over = tick == len(self.q) - 1
        gone = (self.q[tick] - self.q[max(tick - 1, 0)]) / CONTROL_S
        return Driven(
            self.q[tick], np.zeros(6) if over else gone, self.tips[tick], self.speeds[tick]
        )


class Jogger:
    """Checks short motions of a driven arm where things stand as they are seen now.

    Parameters
    ----------
    scene : Scene
    setup : Setup
    look : ArmLook
    """

    def __init__(self, scene: Scene, setup: Setup, look: ArmLook) -> None:
        self._most_m_s = scene.hand_speed_m_s
        self._gripper_m = look.gripper_m
        self._phase = _around(scene, setup, look)
        self._tour = tour(scene, look)
        self.touching = ""
        """What of the arm, the hand or what it holds met something in the last try."""

    def towards(self, now: Driven, speed: Array, *, seats: bool = False) -> Jog | Refusal:
        """Return a motion that takes up a speed, shape (6,), and ends at rest.

        With `seats` the arm was only just put where it is: a singular wrist may begin in
        whatever split of joints 4 and 6 suits the motion.
        """
        return self._tried(now, PACES, lambda pace: driven(now, speed, pace), seats)

    def to(
        self, now: Driven, goal: Array, most: tuple[float, float], *, seats: bool = False
    ) -> Jog | Refusal:
        """Return a motion of the tip to a pose, at no more than so many m/s and rad/s."""
        far = float(np.linalg.norm(goal[:3] - now.tip[:3])) > SMALL_M
        paces = STEPS if far else SMALL_STEPS
        return self._tried(now, paces, lambda pace: stepped(now, goal, most, pace), seats)

    def halting(self, now: Driven) -> Jog | Refusal:
        """Return a motion that brakes."""
        return self._checked(now, driven(now, np.zeros(6), Pace(1.0, 1.0, 1)))

    def _tried(
        self, now: Driven, paces: tuple[Pace, ...], asked: Asking, seats: bool
    ) -> Jog | Refusal:
        now = seated(now, asked(paces[0])[0], self._tour) if seats else now
        found = self._checked(now, asked(paces[-1]))
        hard = isinstance(found, Refusal) and found.reason != "speed"
        if hard and (paces is not PACES or not now.speed.any()):
            # What even the gentlest motion meets is met by all: the answer is given at once.
            return found
        # The wrist takes the side that suits later ways if that costs no time now.
        tries = [(paces[0], self._tour), *((pace, ()) for pace in paces[:-1])]
        for pace, later in tries:
            tried = self._checked(now, asked(pace), later)
            if isinstance(tried, Jog):
                return tried
        return found

    def _checked(self, now: Driven, asked: Asked, later: Sequence[float] = ()) -> Jog | Refusal:
        tips, speeds = asked
        still = np.repeat(tips[-1:], SETTLE_TICKS, axis=0)
        resting = np.arange(len(tips) + SETTLE_TICKS) >= len(tips) - 1
        tips = np.concatenate([tips, still])
        speeds = np.concatenate([speeds, np.zeros((SETTLE_TICKS, 6))])
        found = tracked(now, tips, resting, later)
        if isinstance(found, Refusal):
            return found
        q, off = found
        settled = np.abs(q - q[-1]).max(axis=1) < STANDS_RAD
        end = max(int(np.flatnonzero(~settled)[-1]) + 2 if not settled.all() else 1, 2)
        end = max(end, len(tips) - SETTLE_TICKS)
        jog = Jog(q[:end], tips[:end], speeds[:end], off[:end])
        return self._refused(now, jog) or jog

    def _refused(self, now: Driven, jog: Jog) -> Refusal | None:
        margin = limit_margin(jog.q)
        if margin.min() < 0.0:
            joint = int(np.argmax(np.abs(jog.q[int(np.argmin(margin))]) - a465.LIMITS))
            return Refusal("joint_limit", PATH, f"joint {joint + 1}")
        return self._met(jog.q) or _too_fast(now, jog, self._most_m_s)

    def _met(self, q: Array) -> Refusal | None:
        opening = np.full(len(q), self._gripper_m)
        touch = self._phase.touches(q, opening, np.zeros(len(q), dtype=np.int64))
        self.touching = "" if touch.free else touch.part
        return None if touch.free else Refusal("collision", PATH, touch.thing)

    def along(self, q: Array) -> Jog | Refusal:
        """Return a motion through joints, shape (n, 6), one a tick, if nothing is in its way."""
        tips = compose(forward(q), TIP)
        jog = Jog(np.array(q), tips, np.zeros((len(q), 6)), np.zeros(len(q)))
        return self._met(jog.q) or jog


def _around(scene: Scene, setup: Setup, look: ArmLook) -> Phase:
    two = np.zeros(2)
    here = FinePath(two, np.stack([look.hand] * 2), two, np.full(2, -1), ())
    around = phases(here, scene, setup, look)[0]
    # Nobody knows yet what the teacher will put a body on: it may come to rest on any other.
    known = scene.bodies
    things = [replace(t, bears=True) if t.name in known else t for t in around.things]
    return replace(around, things=tuple(things))


def _too_fast(now: Driven, jog: Jog, most_m_s: float) -> Refusal | None:
    speeds = np.diff(jog.q, axis=0) / CONTROL_S
    gains = np.diff(np.concatenate([now.q_speed[None], speeds]), axis=0) / CONTROL_S
    load = np.maximum(np.abs(speeds) / a465.SPEEDS, np.abs(gains) / a465.ACCELERATIONS).max(axis=0)
    if load.max() > 1.0:
        joint = int(np.argmax(load))
        return Refusal("speed", PATH, f"joint {joint + 1}")
    hand = forward(jog.q)
    tips = compose(hand, TIP)
    steps = max(_longest(hand[:, :3]), _longest(tips[:, :3]))
    if steps > most_m_s * CONTROL_S:
        return Refusal("speed", PATH)
    aside = np.linalg.norm(tips[:, :3] - jog.tips[:, :3], axis=1).max()
    if aside > LEAVES_M or jog.off_rad.max() > LEAVES_RAD or jog.off_rad[-1] > SETTLED_RAD:
        wound = np.abs(jog.q[:, 3]).max() > ENDS - SETTLED_RAD
        return Refusal("joint_limit" if wound else "speed", PATH, "joint 4")
    return None


def _longest(places: Array) -> float:
    return float(np.linalg.norm(np.diff(places, axis=0), axis=1).max(initial=0.0))


def joint_path(jog: Jog, gripper_m: float) -> JointPath:
    """Return a jog as a motion to be started."""
    count = len(jog.q)
    speeds = np.abs(np.diff(jog.q, axis=0)) / CONTROL_S / a465.SPEEDS
    return JointPath(
        CONTROL_S * np.arange(count, dtype=float),
        jog.q,
        np.full(count, gripper_m),
        np.full(count, -1, dtype=np.int64),
        (),
        math.degrees(float(limit_margin(jog.q).min())),
        float(speeds.max(initial=0.0)),
        _longest(forward(jog.q)[:, :3]) / CONTROL_S,
    )
