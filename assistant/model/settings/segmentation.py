"""How proposals are weighed into cuts, and episodes assigned."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal

from assistant.model.settings.paths import SmoothingSettings
from assistant.model.settings.signals import CueSettings, JoltSettings, SignalSettings


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
class DecodingSettings:
    """Weights of the evidence when cuts and assignment are decided together, in log odds.

    Those named by `tests.benchmarks.fit_decoding` are fitted by it, on made-up demonstrations and
    on people's; what too few of those show is set by hand: `nearing`, `turning`, `thing_astray`,
    `elsewhere`, `skip_optional`, `unled`, `untold`, `nothing`, `reorder`. None are from the paper.
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
    nearing: float = 1.5
    elsewhere: float = 4.0
    at_thing_m: float = 0.05
    event: float = 2.9
    lasting: float = 0.1
    skip: float = 3.1
    skip_optional: float = 2.0
    unled: float = 6.0
    insert: float = 5.8
    untold: float = 4.0
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
