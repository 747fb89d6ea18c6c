"""Where the hand, the gripper and the teacher propose to cut."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class SignalSettings:
    """Where each signal proposes to cut (paper III-A, design "Candidates")."""

    turn_weight_m: float = 0.1
    """Metres that count like one radian, where place and turning are joined in one distance."""
    least_travel_m: float = 0.002
    """A gripper that moves less never opened or closed."""
    travel_band: float = 0.2
    """Half-travel crossings count once the opening is this share of travel beyond half."""
    least_held_s: float = 0.3
    """Nobody takes or lets go of a thing for less: the hand is where it was."""
    depth: float = 0.35
    """A minimum of speed must be this deep, in log speed, to be proposed."""
    floor: float = 0.06
    """Share of the mean speed that counts as rest."""
    rest: float = 0.25
    """Below this share of the mean speed the hand rests."""
    most_candidates: int = 100
    blur_of_rest: float = 0.08
    blur_steps: float = 0.8
    """The middle of a rest is known to this share of it, and to so many steps of the recording."""
    blur_least_s: float = 0.06
    blur_shallow_s: float = 0.35
    """A minimum without a stop tells of an instant only so well."""
    clear_depth: float = 3.0
    """A minimum so deep, in log speed, is a stop; one that is one less is none."""
    onset_step_s: float = 0.15
    """Recordings with shorter steps show rests themselves; else onsets of motion tell of them."""
    onset_share: float = 0.4
    """Of the way to the next rest: so much of it tells when the hand set off."""
    onset_off: float = 0.2
    """How far the way's first part strays from growing with the cube of time, by what it is."""
    onset_noise: float = 4e-4
    """Of the motion's extent: how much a hand at rest trembles and drifts."""
    correction: float = 0.015
    """Share of the motion's extent that a correction of a reach spans."""
    least_pace_m_s: float = 1e-4
    """A hand that never goes faster never moved."""


@dataclass(frozen=True, slots=True)
class JoltSettings:
    """How short turns of a resting wrist betray a gripper that is not recorded.

    Measured on people's teleoperation of a surgical arm; not from the paper.
    """

    least: float = 0.8
    """In local medians of the turning rate."""
    window_s: float = 1.5
    width_s: float = 0.05
    longest_step_s: float = 0.25
    """Recordings with longer steps cannot show a jolt."""
    most_samples: int = 20_000
    open_after_s: float = 0.15
    """Half of the travel comes this long after the jolt of letting go."""
    blur_s: float = 0.25
    close_before_s: float = 0.25
    """Half of the travel lies this long before the jolt of gripping.

    Both are half of what suits two teachers' recordings best: less is lost on others'.
    """


@dataclass(frozen=True, slots=True)
class CueSettings:
    """How teachers speak: late, not always, not only at transitions."""

    most_lag_s: float = 2.2
    step_s: float = 0.05
    usual_lag_s: float = 0.9
    usual_lag_spread_s: float = 0.6
    jitters_s: tuple[float, ...] = (0.08, 0.15, 0.25)
    false_share: float = 0.15
    least_missing: float = 0.12
    rounds: int = 1
    """How often the lag is told anew from the cuts it helped to find."""
    lates_s: tuple[float, ...] = (0.1, 0.2, 0.3, 0.4, 0.5)
    """How late a hand may follow the teacher who jogs it, by keys."""
    late_share: float = 0.5
    """Of jogging teachers whose hand follows late, by whichever of these."""
