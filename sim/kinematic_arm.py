"""An arm without physics, for fast transcripts and checks: what is grasped moves with the hand.

Everything else (conditions, stop, reports, correction) is the same as with contact.
"""

from __future__ import annotations

import threading
from collections.abc import Mapping

import numpy as np

from assistant.geometry import Array, compose, inverse, rotate_vector, transform_points
from assistant.model.scene import Body, Scene
from sim import a465
from sim.kinematics import forward
from sim.sensor import InHandSensor, PlaceNoise
from sim.simulated_arm import SimulatedArm
from sim.world import CONTROL_S, Allowed, Fault

REACHED_M = 0.004
"""How far outside a body the point between the pads may be for the pads to catch it."""


class KinematicWorld:
    """Joints that are where they are told to be, and bodies that stay or are carried."""

    def __init__(self) -> None:
        self._scene = Scene()
        self._q = np.array(a465.READY)
        self._hand = forward(self._q)
        self._opening_m = a465.GRIPPER.open_m
        self._bodies: dict[str, Array] = {}
        self._held = ""
        self._held_width_m = 0.0
        self._in_hand: Array = self._hand

    def arrange(self, scene: Scene, bodies: Mapping[str, Array], q: Array) -> None:
        """Put arm and bodies at their places, the hand open."""
        self._scene, self._bodies = scene, dict(bodies)
        self._q, self._hand = q, forward(q)
        self._opening_m, self._held = a465.GRIPPER.open_m, ""

    def seat(self, q: Array) -> None:
        """Put the joints elsewhere at once."""
        self._q, self._hand = q, forward(q)

    def step(self, q: Array, hand: Array, opening_m: float, allowed: Allowed) -> Fault | None:
        """Advance by one control tick: joints follow exactly."""
        self._q, self._hand = q, hand
        if opening_m != self._opening_m:
            self._move_fingers(opening_m)
        return None

    def joints(self) -> tuple[Array, float]:
        """Return joint angles, shape (6,), and opening in m."""
        return self._q, self._opening_m

    def bodies(self) -> dict[str, Array]:
        """Return the middle of each body's base, shape (7,) each."""
        if self._held:
            self._bodies[self._held] = compose(self._hand, self._in_hand)
        return dict(self._bodies)

    def held(self) -> str:
        """Return the name of the body between the fingers; empty for none."""
        return self._held

    def _move_fingers(self, opening_m: float) -> None:
        step = a465.GRIPPER.speed_m_s * CONTROL_S
        opening = self._opening_m + float(np.clip(opening_m - self._opening_m, -step, step))
        if self._held and opening > self._held_width_m:
            self._bodies = self.bodies()
            self._held = ""
        elif not self._held and opening < self._opening_m:
            self._catch(opening)
        if self._held:
            opening = max(opening, self._held_width_m)
        self._opening_m = opening

    def _catch(self, opening_m: float) -> None:
        name = between_pads(self._scene, self._bodies, self._hand)
        if not name:
            return
        pose = self._bodies[name]
        across = rotate_vector(self._hand[3:], np.array([0.0, 1.0, 0.0]))
        width = _width(self._scene.bodies[name], rotate_vector(inverse(pose)[3:], across))
        if opening_m <= width:
            self._held, self._held_width_m = name, width
            self._in_hand = compose(inverse(self._hand), pose)


def between_pads(scene: Scene, bodies: Mapping[str, Array], hand: Array) -> str:
    """Return the name of the body the pads would close on; empty for none.

    Parameters
    ----------
    scene : Scene
    bodies : mapping of name to array, shape (7,)
        Middle of each body's base.
    hand : array, shape (7,)
        The flange.
    """
    middle = transform_points(hand, np.array([a465.TCP_M, 0.0, 0.0]))
    for name, pose in bodies.items():
        body = scene.bodies.get(name)
        if body is None or body.mass_kg <= 0:
            continue
        if _inside(body, transform_points(inverse(pose), middle)):
            return name
    return ""


def _width(body: Body, axis: Array) -> float:
    """Return a body's extent along an axis of its own frame, in m."""
    size = np.array(body.size_mm) / 1000.0
    if body.shape == "box":
        # Pads turn a box until they lie flat on the sides they face.
        return float(size[int(np.argmax(np.abs(axis)))])
    return float(size[0] if abs(axis[2]) < 0.7 else size[2])


def _inside(body: Body, point: Array) -> bool:
    half = np.array(body.size_mm) / 2000.0
    middle = np.array([0.0, 0.0, half[2]])
    return bool(np.all(np.abs(point - middle) <= half + REACHED_M))


class KinematicArm(SimulatedArm):
    """The Arm port without physics."""

    def __init__(
        self,
        stop_flag: threading.Event | None = None,
        *,
        sensor: InHandSensor | None = None,
        noise: PlaceNoise | None = None,
    ) -> None:
        super().__init__(KinematicWorld(), stop_flag, sensor=sensor, noise=noise)
