"""What a teacher says about motion: corrections, the hand, starting and stopping."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assistant.model.teacher_acts.words import Degree, MoveDirection, TurnDirection, Where


@dataclass(frozen=True, slots=True)
class AdjustSpeed:
    """Faster or slower, by a degree or to a factor of the present speed."""

    change: Literal["faster", "slower"] | None = None
    degree: Degree | None = None
    factor: float | None = None
    where: Where | None = None


@dataclass(frozen=True, slots=True)
class Translate:
    """Move the place of the hand, in the teacher's directions."""

    direction: MoveDirection
    degree: Degree | None = None
    distance_m: float | None = None
    where: Where | None = None


@dataclass(frozen=True, slots=True)
class Rotate:
    """Turn the hand, in the teacher's directions."""

    direction: TurnDirection
    degree: Degree | None = None
    angle_deg: float | None = None
    where: Where | None = None


@dataclass(frozen=True, slots=True)
class Gripper:
    """Open or close the hand."""

    command: Literal["open", "close"]
    where: Where | None = None


@dataclass(frozen=True, slots=True)
class Start:
    """Begin, or go on after a stop."""


@dataclass(frozen=True, slots=True)
class Pause:
    """Halt and keep what was planned."""


@dataclass(frozen=True, slots=True)
class Resume:
    """Go on after a pause."""


@dataclass(frozen=True, slots=True)
class Stop:
    """Halt at once, whatever is going on."""


@dataclass(frozen=True, slots=True)
class Again:
    """Do the practice once more with the same setup."""


@dataclass(frozen=True, slots=True)
class AdjustLast:
    """Change the last correction, where the sentence names no direction."""

    change: Literal["more", "less", "opposite"] | None = None
    degree: Degree | None = None
    factor: float | None = None


@dataclass(frozen=True, slots=True)
class SetPose:
    """Where a body is, in mm and degrees; `by_mm` is relative to where it was."""

    object: str
    position_mm: tuple[float, float, float] | None = None
    rpy_deg: tuple[float, float, float] | None = None
    by_mm: tuple[float, float, float] | None = None


@dataclass(frozen=True, slots=True)
class NewSetup:
    """Try another arrangement."""
