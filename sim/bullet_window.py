"""A window on the arm: a picture of the simulated world, renewed as the world goes on.

The world itself runs without a display and does the same with a window as without; however
long drawing takes, physics never waits for more than a picture to be handed over.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from assistant.geometry import Array, compose, inverse
from assistant.model.scene import Scene
from sim.bullet_client import LostError
from sim.bullet_world import BulletWorld
from sim.world import Allowed, Fault

PICTURE_TICKS = 2
"""A new picture is shown after so many control ticks."""


class Picture(BulletWorld):
    """The same arm and bodies, put where they are seen instead of being moved."""

    def show(self, q: Array, opening_m: float, bodies: Mapping[str, Array]) -> None:
        """Put joints, shape (6,), fingers and bodies where they are.

        Raises
        ------
        LostError
            If the window was closed.
        """
        client = self._client
        values = [[float(angle)] for angle in (*q, opening_m / 2, opening_m / 2)]
        client.resetJointStatesMultiDof(self._arm, [*self._joints, *self._fingers], values)
        for name, number in self._numbers.items():
            middle = compose(bodies[name], inverse(self._bases[name]))
            place, turn = middle[:3].tolist(), middle[3:].tolist()
            client.resetBasePositionAndOrientation(number, place, turn)


class WatchedWorld:
    """A world with a picture of it.

    Parameters
    ----------
    world : BulletWorld
        Without a window.
    picture : Picture
    closed : callable
        Called once when the picture's window is found to be closed.
    """

    def __init__(self, world: BulletWorld, picture: Picture, closed: Callable[[], None]) -> None:
        self._world, self._picture = world, picture
        self._closed = closed
        self._open, self._tick = True, 0

    def arrange(self, scene: Scene, bodies: Mapping[str, Array], q: Array) -> None:
        """Put arm and bodies at their places, the hand open."""
        self._world.arrange(scene, bodies, q)
        if self._open:
            self._shown(lambda: self._picture.arrange(scene, bodies, q))

    def seat(self, q: Array) -> None:
        """Put the joints elsewhere at once, before anything has moved."""
        self._world.seat(q)

    def step(self, q: Array, hand: Array, opening_m: float, allowed: Allowed) -> Fault | None:
        """Advance by one control tick; every other one is shown."""
        fault = self._world.step(q, hand, opening_m, allowed)
        self._tick += 1
        if self._open and self._tick % PICTURE_TICKS == 0:
            self._shown(lambda: self._picture.show(*self.joints(), self.bodies()))
        return fault

    def _shown(self, show: Callable[[], None]) -> None:
        try:
            show()
        except LostError:
            self._open = False
            self._closed()

    def joints(self) -> tuple[Array, float]:
        """Return measured joint angles, shape (6,), and opening in m."""
        return self._world.joints()

    def bodies(self) -> dict[str, Array]:
        """Return the middle of each body's base, shape (7,) each."""
        return self._world.bodies()

    def held(self) -> str:
        """Return the name of the body that both pads press on; empty for none."""
        return self._world.held()
