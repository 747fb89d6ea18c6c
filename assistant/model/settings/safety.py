"""How far a sentence may move the arm, and how fast practice is."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class SafetySettings:
    """Bounds on what a sentence may do. Source: design, safety."""

    step_m: float = 0.005
    little_step_m: float = 0.002
    much_step_m: float = 0.015
    step_deg: float = 3.0
    little_step_deg: float = 1.0
    much_step_deg: float = 10.0
    speed_step: float = 0.2
    confirm_beyond_m: float = 0.020
    confirm_beyond_deg: float = 10.0
    act_confidence: float = 0.85
    """Below this confidence the robot reads back its best guess and asks."""
    heartbeat_s: float = 2.0
    """A shell that gives no sign of life for so long, while the arm moves, is lost."""


@dataclass(frozen=True, slots=True)
class PracticeSettings:
    """Speeds of practice as factors of the demonstration's. Source: paper III-D b, IV-C."""

    slow: float = 0.5
    normal: float = 1.0
    agreed_after: int = 2
    """Setups run uncorrected, with every until-condition perceived, before the robot agrees."""
