"""The simulated A465 with contact physics: grasps by friction, places on what is there."""

from __future__ import annotations

import threading

from sim.bullet_settings import BulletSettings
from sim.bullet_window import WatchedWorld, Window
from sim.bullet_world import BulletWorld
from sim.sensor import InHandSensor, PlaceNoise
from sim.simulated_arm import SimulatedArm
from sim.world import World

CLOSED = "window"
"""Why the arm stopped when its window was closed."""


class BulletArm(SimulatedArm):
    """The Arm port in PyBullet.

    Parameters
    ----------
    stop_flag : threading.Event, optional
        Read by every tick.
    window : bool
        Show a window, which stops the arm when it is closed; without it no display is needed.
    sensor : InHandSensor or None
        The default looks with the stated noise; None leaves the release as planned.
    noise : PlaceNoise, optional
        Errors of the told places.
    settings : BulletSettings, optional
    """

    def __init__(
        self,
        stop_flag: threading.Event | None = None,
        *,
        window: bool = False,
        sensor: InHandSensor | None = None,
        noise: PlaceNoise | None = None,
        settings: BulletSettings | None = None,
    ) -> None:
        physics = BulletWorld(settings=settings)
        world: World = physics
        if window:
            world = WatchedWorld(physics, Window(), self._closed)
        super().__init__(world, stop_flag, sensor=sensor, noise=noise)

    def _closed(self) -> None:
        # Whoever closes the window wants the arm to stop, and whatever is about to move, too.
        self.stop(CLOSED)
        self._flag.set()
