"""Numbers the method depends on, each with its source."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal


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
    keep_out: float = 0.95
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
    """Of the demonstration's peak speed, which a moved setup never exceeds."""
    brake_s: float = 0.4
    """Slowing down and speeding up again spread over so long."""


@dataclass(frozen=True, slots=True)
class SignalSettings:
    """Where each signal proposes to cut (paper III-A, design "Candidates")."""

    turn_weight_m: float = 0.1
    """Metres that count like one radian, where place and turning are joined in one distance."""
    least_travel_m: float = 0.002
    """A gripper that moves less never opened or closed."""
    travel_band: float = 0.2
    """Half-travel crossings count once the opening is this share of travel beyond half."""
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
    longest_step_s: float = 0.1
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
class VoteSettings:
    """Weights and spreads of the votes, eqs. (1), (2).

    `weights` are the paper's reliabilities. A spread says how far, as a share of the path from
    one introduced cut to the next, a vote reaches; where `paper_spread` is set, eq. (1) uses
    c = 1/(spread V^2) with V the mean speed per second in m/s, as printed in the paper IV-B.
    """

    weights: Mapping[str, float] = field(
        default_factory=lambda: MappingProxyType(
            {"gripper": 0.52, "speed": 0.19, "cue": 0.29, "jolt": 0.29}
        )
    )
    spreads: Mapping[str, float] = field(
        default_factory=lambda: MappingProxyType(
            {"gripper": 0.02, "speed": 0.04, "cue": 0.08, "jolt": 0.02}
        )
    )
    paper_spread: bool = False


PAPER_VOTES = VoteSettings(
    weights=MappingProxyType({"gripper": 0.52, "speed": 0.19, "cue": 0.29}),
    spreads=MappingProxyType({"gripper": 2.0, "speed": 50.0, "cue": 800.0}),
    paper_spread=True,
)
"""Source: paper IV-B: c = 1/(2 V^2), 1/(50 V^2), 1/(800 V^2); w = 0.52, 0.19, 0.29."""


@dataclass(frozen=True, slots=True)
class ValiditySettings:
    """When an episode is valid, P(E) of paper III-A; the paper names factors, not numbers."""

    least_s: float = 0.3
    least_share: float = 0.02
    """Of the whole path: shorter episodes are hardly valid."""
    dominant: float = 0.7
    """Share of the motion along one axis from which on its character is clear."""
    fast: float = 2.0
    """Mean speeds; an episode that fast is valid whatever its direction."""
    false_below: float = 0.25


@dataclass(frozen=True, slots=True)
class CueSettings:
    """How teachers speak: late, not always, not only at transitions."""

    most_lag_s: float = 2.2
    step_s: float = 0.05
    usual_lag_s: float = 0.9
    usual_lag_spread_s: float = 0.6
    jitters_s: tuple[float, ...] = (0.08, 0.15, 0.25)
    false_share: float = 0.15
    least_missing: float = 0.08
    rounds: int = 1
    """How often the lag is told anew from the cuts it helped to find."""
    lates_s: tuple[float, ...] = (0.1, 0.2, 0.3, 0.4, 0.5)
    """How late a hand may follow the teacher who jogs it, by keys."""
    late_share: float = 0.5
    """Of jogging teachers whose hand follows late, by whichever of these."""


@dataclass(frozen=True, slots=True)
class DecodingSettings:
    """Weights of the evidence when cuts and assignment are decided together, in log odds.

    Those named by `tests.benchmarks.fit_decoding` are fitted by it, on made-up demonstrations and
    on people's; what too few of those show is set by hand: `turning`, `thing_astray`, `elsewhere`,
    `skip_optional`, `unled`, `nothing`, `reorder`. None are from the paper.
    """

    bias: float = -3.8
    slow: float = 0.43
    rest: float = 2.35
    bend: float = 1.3
    veer: float = 2.0
    gripper: float = 3.85
    jolt: float = 1.3
    part: float = 0.8
    heard: float = 0.8
    settling: float = 1.85
    direction: float = 1.0
    turning: float = 3.0
    clear_along: float = 0.5
    astray: float = 2.2
    thing_astray: float = 8.0
    still: float = 2.3
    straight: float = 2.3
    wide: float = 7.7
    turned: float = 3.1
    idle: float = 4.75
    nearing: float = 0.57
    elsewhere: float = 4.0
    at_thing_m: float = 0.05
    event: float = 2.9
    lasting: float = 0.1
    skip: float = 3.1
    skip_optional: float = 2.0
    unled: float = 6.0
    insert: float = 5.8
    nothing: float = 4.75
    reorder: float = 4.0


@dataclass(frozen=True, slots=True)
class SegmentationSettings:
    """All of cutting and assigning.

    Parameters
    ----------
    method : {"decode", "paper"}
        ``decode``: cuts and assignment together, with the introduction and the teacher's lag
        as evidence; it measures best. ``paper``: eqs. (1) to (4) as printed.
    """

    method: Literal["decode", "paper"] = "decode"
    smoothing: SmoothingSettings = field(default_factory=SmoothingSettings)
    signals: SignalSettings = field(default_factory=SignalSettings)
    jolts: JoltSettings = field(default_factory=JoltSettings)
    votes: VoteSettings = field(default_factory=VoteSettings)
    validity: ValiditySettings = field(default_factory=ValiditySettings)
    cues: CueSettings = field(default_factory=CueSettings)
    decoding: DecodingSettings = field(default_factory=DecodingSettings)


def paper() -> SegmentationSettings:
    """Return the method as printed: votes with the paper's constants, argmax of eq. (4)."""
    return SegmentationSettings(method="paper", votes=PAPER_VOTES)
