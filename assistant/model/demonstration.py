"""What a teacher shows: sampled motion of the hand, with what was said meanwhile (paper II-B)."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from assistant.geometry import Array
from assistant.model.setup import Setup


def frozen_array(values: Array) -> Array:
    """Return a read-only copy, of the same shape, so that a frozen value stays what it was.

    An array that is read-only already, and no view of another that is not, is taken itself.
    """
    owner = values if values.base is None else values.base
    shared = isinstance(owner, np.ndarray) and not owner.flags.writeable
    if shared and not values.flags.writeable and values.dtype == float:
        return values
    copy = np.array(values, dtype=float)
    copy.setflags(write=False)
    return copy


def sealed(values: Array) -> Array:
    """Return an array that nobody else has as read-only, with what it is a view of; no copy."""
    if isinstance(values.base, np.ndarray):
        values.base.setflags(write=False)
    values.setflags(write=False)
    return values


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """Samples of the hand.

    Parameters
    ----------
    t_s : array, shape (n,)
        Increasing times.
    path : array, shape (n, 7)
        The flange in the base frame: xyz in m, quaternion xyzw.
    gripper_m : array, shape (n,), or None
        Opening of the gripper; None if the hand was not recorded.
    """

    t_s: Array
    path: Array
    gripper_m: Array | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "t_s", frozen_array(self.t_s))
        object.__setattr__(self, "path", frozen_array(self.path))
        if self.gripper_m is not None:
            object.__setattr__(self, "gripper_m", frozen_array(self.gripper_m))


@dataclass(frozen=True, slots=True)
class Spoken:
    """Words said at an instant of a demonstration, in s on the recording's clock."""

    at_s: float
    say: str


@dataclass(frozen=True, slots=True, eq=False)
class Demonstration:
    """One showing of a task (demonstration/1).

    Parameters
    ----------
    recording : Recording
    cues : tuple of Spoken
        Organisational markers: "first step", "then".
    key_states : tuple of Spoken
        States the teacher called attention to.
    setup : Setup
        Where things were; places may be missing.
    approach_axis : str
        Of the hand: "x", "y", "z", or with a minus sign.
    source : str
        Where it came from: a file's name or what was live.
    """

    recording: Recording
    cues: tuple[Spoken, ...] = ()
    key_states: tuple[Spoken, ...] = ()
    setup: Setup = field(default_factory=Setup)
    approach_axis: str = "x"
    source: str = ""
