"""Where things are when a task starts: the paper's task setup (Table I)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal

from assistant.geometry import Array, pose_from_mm_deg

Triple = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Place:
    """A pose as it was told, in mm and degrees about fixed x, y, z.

    Parameters
    ----------
    kind : {"hand", "body"}
        ``hand``: the flange when it grasps or releases there, as the paper tells places
        (keys ``hand_xyz_mm``, ``hand_rpy_deg``). ``body``: the middle of the body's base, as
        people measure (keys ``xyz_mm``, ``rpy_deg``). The scene says how the two relate.
    """

    kind: Literal["hand", "body"]
    xyz_mm: Triple
    rpy_deg: Triple = (0.0, 0.0, 0.0)

    @property
    def pose(self) -> Array:
        """The pose told, shape (7,), in m and quaternion xyzw, of whichever frame was told."""
        return pose_from_mm_deg(self.xyz_mm, self.rpy_deg)


READY = Place("hand", (406.4, 0.0, 635.0))
"""The flange of the A465 at q = (0, 0, 90, 0, 0, 0) degrees; the paper's robot start."""


@dataclass(frozen=True, slots=True)
class Setup:
    """Where the robot starts and where every object and target is."""

    name: str = "setup"
    scene: str = "table"
    robot_start: Place = READY
    places: Mapping[str, Place] = field(default_factory=lambda: MappingProxyType({}))

    def __post_init__(self) -> None:
        object.__setattr__(self, "places", MappingProxyType(dict(self.places)))
