"""A picture of the simulated world, and the program that shows it in a window.

The window belongs to a program of its own: whoever closes it ends what draws it, in whatever way
a desktop does that, and nothing else. It is told what to show on stdin and answers each message
by a byte on stdout.
"""

from __future__ import annotations

import os
import pickle
import sys
from collections.abc import Callable, Mapping
from typing import IO

from assistant.geometry import Array, compose, inverse
from sim.bullet_world import BulletWorld

DONE = b"."


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


def draw(picture: Picture, told: IO[bytes], answers: int) -> None:
    """Show what is told until nothing is told any more; answer to a file descriptor."""
    doing: dict[str, Callable[..., None]] = {"arrange": picture.arrange, "show": picture.show}
    while True:
        try:
            name, values = pickle.load(told)
        except EOFError:
            return
        doing[name](*values)
        os.write(answers, DONE)


if __name__ == "__main__":
    # The library says on stdout what it likes.
    answers = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    draw(Picture(window="--hidden" not in sys.argv), sys.stdin.buffer, answers)
