"""A correction the teacher spoke, kept with its words and the frame it belongs to (III-D b)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

When = Literal["before", "during", "after"]


@dataclass(frozen=True, slots=True)
class Feedback:
    """One correction.

    Parameters
    ----------
    kind : {"translate", "rotate", "speed", "hand"}
    words : str
        As the teacher said it.
    primitive : str
        The primitive it belongs to; empty for the whole task.
    when : {"before", "during", "after"}
        Relative to that primitive.
    frame : str
        Name of the object or target it moves with; empty for the world.
    offset_m, turn_rad : 3 numbers
        Displacement, and rotation vector, in axes of `frame` at the demonstration.
    factor : float
        For ``speed``.
    hand : {"open", "close"} or None
        For ``hand``.
    """

    kind: Literal["translate", "rotate", "speed", "hand"]
    words: str
    primitive: str = ""
    when: When = "during"
    frame: str = ""
    offset_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    turn_rad: tuple[float, float, float] = (0.0, 0.0, 0.0)
    factor: float = 1.0
    hand: Literal["open", "close"] | None = None
