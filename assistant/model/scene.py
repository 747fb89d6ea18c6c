"""What things look like: bodies, tables, obstacles and speed limits (scene/1)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal

import numpy as np

from assistant.geometry import IDENTITY, Array, compose, inverse, pose_from_mm_deg
from assistant.model.setup import Place, Triple


@dataclass(frozen=True, slots=True)
class Body:
    """A thing on the table.

    Parameters
    ----------
    shape : {"box", "cylinder", "sphere", "cup"}
        A ``cup`` is an open cylinder.
    size_mm : 3 numbers
        Box: x, y, z. Cylinder and cup: diameter, diameter, height. Sphere: diameter thrice.
    mass_kg : float
        0 for a body that cannot be moved, such as a target.
    friction : float
    grasp_xyz_mm, grasp_rpy_deg : 3 numbers each
        The flange when it grasps (or releases at) the body, seen from the middle of the
        body's base.
    normal : 3 numbers
        The surface normal of a target, in its own frame.
    color : str
    hole_mm : 3 numbers
        Of a box with a hole from above, in its middle: x, y and depth; zeros for none.
    """

    name: str
    shape: Literal["box", "cylinder", "sphere", "cup"] = "box"
    size_mm: Triple = (60.0, 40.0, 100.0)
    mass_kg: float = 0.2
    friction: float = 0.9
    grasp_xyz_mm: Triple = (-134.1, 0.0, 60.0)
    grasp_rpy_deg: Triple = (0.0, 0.0, 0.0)
    normal: Triple = (0.0, 0.0, 1.0)
    color: str = ""
    hole_mm: Triple = (0.0, 0.0, 0.0)

    @property
    def hand_in_body(self) -> Array:
        """The flange at the grasp as seen from the middle of the body's base, shape (7,)."""
        return pose_from_mm_deg(self.grasp_xyz_mm, self.grasp_rpy_deg)


@dataclass(frozen=True, slots=True)
class Obstacle:
    """A box the arm must not touch: table, wall or post; `xyz_mm` is the middle of its base."""

    name: str
    size_mm: Triple
    xyz_mm: Triple
    rpy_deg: Triple = (0.0, 0.0, 0.0)
    color: str = ""


@dataclass(frozen=True, slots=True)
class Scene:
    """Everything around the arm.

    Parameters
    ----------
    bodies : mapping of name to Body
        Objects and targets by the names tasks use.
    tables : tuple of Obstacle
        Surfaces bodies may rest upon; the arm must not touch them.
    obstacles : tuple of Obstacle
        Bodies the arm and what it carries must not touch.
    hand_speed_m_s : float
        The greatest speed of the hand.
    """

    name: str = "table"
    bodies: Mapping[str, Body] = field(default_factory=lambda: MappingProxyType({}))
    tables: tuple[Obstacle, ...] = ()
    obstacles: tuple[Obstacle, ...] = ()
    hand_speed_m_s: float = 0.25

    def __post_init__(self) -> None:
        object.__setattr__(self, "bodies", MappingProxyType(dict(self.bodies)))

    def hand_pose(self, name: str, place: Place) -> Array:
        """Return the flange pose, shape (7,), when it grasps or releases at a place."""
        if place.kind == "hand":
            return place.pose
        return compose(place.pose, self._hand_in_body(name))

    def body_pose(self, name: str, place: Place) -> Array:
        """Return the pose, shape (7,), of the middle of the base of the body at a place."""
        if place.kind == "body":
            return place.pose
        return compose(place.pose, inverse(self._hand_in_body(name)))

    def _hand_in_body(self, name: str) -> Array:
        body = self.bodies.get(name)
        return body.hand_in_body if body else np.array(IDENTITY)
