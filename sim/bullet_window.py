"""A window on the arm: a picture of the simulated world, renewed as the world goes on.

The world itself runs without a display and does the same with a window as without; however
long drawing takes, physics never waits for more than a picture to be handed over.
"""

from __future__ import annotations

import io
import os
import pickle
import subprocess
import sys
import weakref
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, Protocol

from assistant.geometry import Array
from assistant.model.scene import Scene
from sim.bullet_client import LostError
from sim.bullet_world import BulletWorld
from sim.world import Allowed, Fault

PICTURE_TICKS = 2
"""A new picture is shown after so many control ticks."""
PROGRAM = "sim.bullet_picture"


class Shown(Protocol):
    """What shows the world; whatever it is told raises LostError once its window is closed."""

    def arrange(self, scene: Scene, bodies: Mapping[str, Array], q: Array) -> None:
        """Show another arrangement."""
        ...

    def show(self, q: Array, opening_m: float, bodies: Mapping[str, Array]) -> None:
        """Show joints, shape (6,), fingers and bodies where they are now."""
        ...


class Window:
    """A picture shown by a program of its own.

    Parameters
    ----------
    hidden : bool
        Draw without a display.

    Attributes
    ----------
    process : Popen
    answers : file
        A byte comes for each picture that is drawn.
    owed : int
        How many are still to be drawn, as far as is known.
    """

    def __init__(self, *, hidden: bool = False) -> None:
        flags = ("--hidden",) if hidden else ()
        self.process = subprocess.Popen(
            [sys.executable, "-m", PROGRAM, *flags],
            bufsize=0,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            # Ctrl-C is for the arm, not for its picture.
            start_new_session=True,
        )
        self._leave = weakref.finalize(self, _ended, self.process)
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self._told, self.answers = self.process.stdin, self.process.stdout
        os.set_blocking(self.answers.fileno(), False)
        self.owed = 0

    def arrange(self, scene: Scene, bodies: Mapping[str, Array], q: Array) -> None:
        """Show another arrangement."""
        self.look()
        self._tell("arrange", scene, dict(bodies), q)

    def show(self, q: Array, opening_m: float, bodies: Mapping[str, Array]) -> None:
        """Show where everything is; nothing while the picture before is still being drawn."""
        self.look()
        if not self.owed:
            self._tell("show", q, opening_m, dict(bodies))

    def close(self) -> None:
        """Close the window; a second time does nothing."""
        self._leave()

    def look(self) -> None:
        """Take the answers that have come.

        Raises
        ------
        LostError
            If none can come any more.
        """
        try:
            answers = self.answers.read(1 << 16)
        except (OSError, ValueError) as error:
            raise LostError("the window is closed") from error
        if answers == b"":
            raise LostError("the window is closed")
        self.owed -= len(answers or b"")

    def _tell(self, name: str, *values: Any) -> None:
        try:
            self._told.write(packed((name, values)))
        except (OSError, ValueError) as error:
            raise LostError("the window is closed") from error
        self.owed += 1


def packed(told: Any) -> bytes:
    """Return values as they are sent to the program that draws; its views of mappings, too."""
    sent = io.BytesIO()
    pickler = pickle.Pickler(sent)
    pickler.dispatch_table = {MappingProxyType: lambda view: (viewed, (dict(view),))}
    pickler.dump(told)
    return sent.getvalue()


def viewed(told: dict[Any, Any]) -> MappingProxyType[Any, Any]:
    """Return a view of a mapping."""
    return MappingProxyType(told)


def _ended(process: subprocess.Popen[bytes]) -> None:
    process.kill()
    process.wait()
    for pipe in (process.stdin, process.stdout):
        if pipe is not None:
            pipe.close()


class WatchedWorld:
    """A world with a picture of it.

    Parameters
    ----------
    world : BulletWorld
        Without a window.
    picture : Shown
    closed : callable
        Called once when the picture's window is found to be closed.
    """

    def __init__(self, world: BulletWorld, picture: Shown, closed: Callable[[], None]) -> None:
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
