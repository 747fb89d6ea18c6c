"""What the session needs from outside, as protocols of at most five methods."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

from assistant.geometry import Array
from assistant.model.motion import ArmReport, HandPath, JointPath, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup


@dataclass(frozen=True, slots=True, eq=False)
class ArmLook:
    """What is measured of the arm and what a sensor tells of the bodies.

    Parameters
    ----------
    q : array, shape (6,)
        Joint angles, rad.
    hand : array, shape (7,)
        Flange in the base frame.
    gripper_m : float
        Opening.
    held : str
        Name of the body between the fingers; empty for none.
    bodies : mapping of name to array, shape (7,)
        Middle of each body's base.
    moving : bool
    now_s : float
        Simulated time.
    """

    q: Array
    hand: Array
    gripper_m: float
    held: str
    bodies: dict[str, Array]
    moving: bool
    now_s: float


class Arm(Protocol):
    """A robot arm with a hand, moved one control tick at a time.

    `stop` latches: what was started is discarded and the grip kept, until `start` is called
    with a motion planned from where the arm now is. A stop flag given at construction is read
    by every tick, so that stopping never waits for anything else.
    """

    def arrange(self, scene: Scene, setup: Setup) -> None:
        """Put the arm at the robot start and every body at its place."""
        ...

    def look(self) -> ArmLook:
        """Return what is measured now."""
        ...

    def start(self, motion: JointPath) -> None:
        """Begin to carry out a checked motion."""
        ...

    def tick(self) -> tuple[ArmReport, ...]:
        """Advance by one control period and return what there is to tell."""
        ...

    def stop(self, why: str) -> None:
        """Brake now, keep the grip, discard what was started."""
        ...


class Planner(Protocol):
    """Turns a path of the hand into a checked motion of the joints, or says why not."""

    def plan(
        self, path: HandPath, scene: Scene, setup: Setup, look: ArmLook | None = None
    ) -> JointPath | Refusal:
        """Return a motion within reach, limits, speeds and free of collision.

        Without `look` the motion begins at the setup's robot start.
        """
        ...


@dataclass(frozen=True, slots=True, eq=False)
class HandSample:
    """One instant of the teacher's hand: flange pose, shape (7,), opening, and words said."""

    t_s: float
    pose: Array
    gripper_m: float | None
    said: str = ""


class Hand(Protocol):
    """The teacher's hand: a recording, a scripted hand, or keys at a terminal."""

    def samples(self) -> Iterator[HandSample]:
        """Yield samples in order of time until the demonstration is over."""
        ...


class Clock(Protocol):
    """Time, so that nothing else needs to know whether it is real."""

    def now_s(self) -> float:
        """Return seconds since the session began."""
        ...

    def pass_s(self, seconds: float) -> None:
        """Let time pass."""
        ...
