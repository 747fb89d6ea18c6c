"""What an arm acts upon: joints, fingers and bodies, one control tick at a time.

`sim.kinematic_arm` and `sim.bullet_arm` are an arm (`sim.simulated_arm`) with a world each.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

from assistant.geometry import Array
from assistant.model.scene import Scene

CONTROL_S = 0.02
EASE_S = 0.16
EASED = 0.02
"""Before opening, the grip fades so long to this share. Fingers that leave a body while they
press on it throw it by a millimetre, since one pad is always the first to let go."""
STILL_TICKS = 8
"""The opening has settled when it has not changed for this many ticks."""
STILL_M = 2e-5


@dataclass(frozen=True, slots=True)
class Fault:
    """What must halt a run: ``contact`` with a body, ``tracking``, ``slipped``, or a condition.

    By how much a body slipped is `amount`, in ``mm`` or ``deg``.
    """

    text: str
    body: str = ""
    target: str = ""
    amount: float | None = None
    unit: str = ""


@dataclass(frozen=True, slots=True)
class Allowed:
    """Contacts that belong to the plan, and how hard the fingers may press.

    Parameters
    ----------
    grasped : str
        The body the pads may touch.
    resting : bool
        Whether that body may touch what it stands on.
    grip : float
        Share of the full grip force; below 1 while the hand eases its grip before opening.
    """

    grasped: str = ""
    resting: bool = True
    grip: float = 1.0


class World(Protocol):
    """Joints, fingers and bodies."""

    def arrange(self, scene: Scene, bodies: Mapping[str, Array], q: Array) -> None:
        """Put arm and bodies at their places, the hand open."""
        ...

    def seat(self, q: Array) -> None:
        """Put the joints elsewhere at once, before anything has moved."""
        ...

    def step(self, q: Array, hand: Array, opening_m: float, allowed: Allowed) -> Fault | None:
        """Advance by one control tick towards commanded joints and opening."""
        ...

    def joints(self) -> tuple[Array, float]:
        """Return measured joint angles, shape (6,), and opening in m."""
        ...

    def bodies(self) -> dict[str, Array]:
        """Return the middle of each body's base, shape (7,) each."""
        ...

    def held(self) -> str:
        """Return the name of the body between the fingers; empty for none."""
        ...
