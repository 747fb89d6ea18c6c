"""How one demonstration becomes a path, and how that is carried to other setups."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True)
class SmoothingSettings:
    """How the tracked hand is smoothed. Source: design, "Smoothing"."""

    cutoff_hz: float = 3.0
    """Motion of people's hands lies below, tremor (8 to 12 Hz) and tracking noise above."""
    gap_s: float = 0.4
    gap_steps: float = 4.0
    """A stretch without samples is a gap if longer than both, the second in median steps."""
    most_samples: int = 20_000
    """Longer recordings are thinned."""


@dataclass(frozen=True, slots=True)
class GeneralizationSettings:
    """How one demonstration becomes a path to carry out. Source: paper III-C a, b; design."""

    step_s: float = 0.02
    """Sampling of the learned path."""
    most_samples: int = 2000
    """A longer demonstration is sampled more coarsely."""
    docking_near_m: float = 0.015
    docking_far_m: float = 0.12
    """A docking pose lies between these distances from its grasping or releasing pose."""
    docking_m: float = 0.05
    """Where it is put if the cut shows none between them."""
    settle_m: float = 0.10
    """Length of path before docking over which what docking forbids is taken out."""
    leave_m: float = 0.05
    """Length of path after a grasp or release that still belongs to its frame."""
    dwell_s: float = 0.4
    """The hand rests at least so long while the gripper acts."""
    rest_m_s: float = 0.015
    """A hand slower than this is taken to rest."""
    rest_rad_s: float = 0.1
    """And if it turns slower than this."""
    longest_rest_s: float = 2.0
    """A longer rest is cut to this: its teacher was thinking, or looking for a key."""
    rest_within_m: float = 0.002
    rest_within_rad: float = 0.02
    """A hand that strays further from where its rest began is creeping, not resting."""
    easing_s: float = 0.3
    """Stretch of demonstrated motion that is braked where the hand acted without resting."""
    least_travel_m: float = 0.003
    """A gripper that moves less than this never acted."""


@dataclass(frozen=True, slots=True)
class BlendingSettings:
    """How a learned path is carried to another setup. Source: paper III-D a; design."""

    scheme: Literal["smooth", "paper", "two_frame", "azimuth"] = "smooth"
    """``smooth``: a correction of least jerk between the stations; ``paper``: eq. (6);
    ``azimuth``: eq. (6) with the world path turned; ``two_frame``: no world path."""
    hold_m: float = 0.11
    """Length of path before a grasp or release that keeps its shape exactly."""
    most_held: float = 0.35
    """But no more than this share of the way between two stations."""
    least_radius_m: float = 0.10
    """Paths that come nearer to the base's axis are not turned with the azimuth."""
    keep_out: float = 0.87
    """A way to another azimuth stays so far out, as a share of the distances it leads between."""
    jerk_share: float = 1.05
    """Of the demonstration's jerk: a way that has more is evened out."""
    even_m: float = 0.010
    """But it is led no further than this from where it would be."""
    rise_from: float = 0.40
    """Share of the way between stations from which lambda1 rises to 1."""
    fall_by: float = 0.35
    """Share of the way by which lambda1 of the last station has fallen to 0."""
    depart_by: float = 0.20
    """Share of the way by which lambda2 has fallen to 0."""
    tool_m: float = 0.1341
    """The hand is turned about this point ahead of the flange (A465: the TCP)."""
    turn_rad_s: float = 1.6
    """The hand never turns faster, unless it was shown to,"""
    most_turn_rad_s: float = 2.8
    """and then not faster than this, which a wrist can follow (A465: 2.98)."""
    speed_share: float = 0.995
    """Of the demonstration's peak speed, which a moved setup never exceeds,"""
    least_m_s: float = 0.02
    """but a hand that hardly moved, or only turned, may go at this to things elsewhere."""
    hurry_share: float = 0.7
    """Where a way grew, a step lasts at least this share of its time. See `Hurry`."""
    brake_s: float = 0.4
    """Slowing down and speeding up again spread over so long."""
