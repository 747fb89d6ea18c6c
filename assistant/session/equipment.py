"""What a session is given by whoever starts it: arm, planner, hands, where new setups come from.

The session knows these as ports only; the command line picks the adapters.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Protocol

from assistant.geometry import Array
from assistant.model.motion import ArmReport, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from assistant.model.transcript import Demonstrate
from assistant.ports import Arm, Hand, HandSample, Planner

HandMaker = Callable[[Demonstrate, Task, Scene, Setup], Hand]
"""Makes the hand a ``demonstrate`` step asks for; a recording's path is absolute by then."""

SetupMaker = Callable[[Task, Scene, Setup, int, Callable[[int], bool]], Setup | None]
"""Returns a reachable setup drawn with a seed, or None where none was found."""


class DrivenState(Protocol):
    """What a display of a driven hand shows."""

    @property
    def step_mm(self) -> float:
        """How far a tap moves the hand now."""
        ...

    @property
    def step_deg(self) -> float:
        """How far a tap turns it now."""
        ...

    @property
    def clutched(self) -> bool:
        """Whether the keys move nothing now."""
        ...

    @property
    def blocked(self) -> Refusal | ArmReport | None:
        """Why the last motion was not begun, or what ended it."""
        ...

    @property
    def touching(self) -> str:
        """Which part of the arm or the hand that is in the way of."""
        ...

    @property
    def gave_way_mm(self) -> float:
        """How far the hand went aside in the last step: its reach ends there."""
        ...

    @property
    def returning(self) -> bool:
        """Whether what was done last is being taken back; none of that is shown."""
        ...

    @property
    def lowest(self) -> tuple[str, float] | None:
        """What of hand and arm (fingers, palm, arm) is nearest above a table, and how far, mm."""
        ...


class DrivenHand(Protocol):
    """A hand driven by keys, one sample a period."""

    @property
    def tip(self) -> Array:
        """The point between the fingers, about which the hand turns, seen from the flange."""
        ...

    @property
    def state(self) -> DrivenState:
        """What a display shows."""
        ...

    def press(self, key: str) -> bool:
        """Take a key; return whether it means anything."""
        ...

    def lead(self, move_m: tuple[float, float, float]) -> None:
        """Move on by so much along the base's axes, as a mouse does that drags the hand."""
        ...

    def release(self) -> None:
        """End all motion."""
        ...

    def say(self, text: str) -> None:
        """Attach words to the next sample."""
        ...

    def tick(self) -> HandSample:
        """Let one period pass."""
        ...


Driver = Callable[[Arm, Planner, Scene, Setup], DrivenHand]
"""Makes a hand that is driven by keys."""


@dataclass(frozen=True, slots=True)
class Equipment:
    """The outside of one session.

    Parameters
    ----------
    arm : Arm
    planner : Planner
    hand : callable
        See `HandMaker`.
    new_setup : callable
        See `SetupMaker`.
    stop_flag : threading.Event
        Read by every tick of the arm; set by raw input, before and beside everything else.
    driver : callable, optional
        See `Driver`.
    """

    arm: Arm
    planner: Planner
    hand: HandMaker
    new_setup: SetupMaker
    stop_flag: threading.Event = field(default_factory=threading.Event)
    driver: Driver | None = None


EquipmentMaker = Callable[[str], Equipment]
"""Returns the equipment around the arm of that name, ``kinematic`` or ``pybullet``."""
