"""One carrying out of a setup, under way and when it is over."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assistant.model.motion import Alignment, Measure
from assistant.model.setup import Setup

Pace = Literal["slow", "normal"]


@dataclass(frozen=True, slots=True)
class Run:
    """One carrying out of a setup.

    Parameters
    ----------
    purpose : {"practice", "replay", "look", "dry"}
        ``look`` only checks, ``dry`` tells what it found.
    anew : bool
        Goes on from where the arm was halted.
    checked : bool
        The check of this run was accepted and its motion may be under way.
    interrupted : bool
        Stopped by the teacher on the way; it does not count toward agreement.
    note : str
        What was changed on the way.
    asked_s : float or None
        How long it would take at the speed asked for, where limits allow no such speed.
    pause_after : int
        The position of the primitive after which to pause; -1 for none.
    perceived : tuple of (condition, object)
    """

    setup: Setup
    pace: Pace
    purpose: Literal["practice", "replay", "look", "dry"] = "practice"
    anew: bool = False
    checked: bool = False
    corrected: bool = False
    interrupted: bool = False
    note: str = ""
    asked_s: float | None = None
    pause_after: int = -1
    primitive_at: int = -1
    perceived: tuple[tuple[str, str], ...] = ()
    held: str = ""
    height_mm: float | None = None


@dataclass(frozen=True, slots=True)
class RunResult:
    """How one carrying out went."""

    setup: Setup
    pace: Pace
    corrected: bool
    complete: bool
    missing: tuple[str, ...] = ()
    alignments: tuple[Alignment, ...] = ()
    measures: tuple[Measure, ...] = ()
