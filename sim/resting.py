"""What is carried, and where it may rest on what bears it: where it is taken up and put down.

Elsewhere it is kept as clear of tables as of everything else; on its way from one to the other
it rises and sinks steadily.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from assistant.geometry import IDENTITY, Array, compose, rotate_vector
from assistant.model.placing import is_round
from assistant.model.scene import Scene
from sim.kinematics import Flags
from sim.shapes import Boxes, body_box, box_at, boxes_apart

CLEARANCE_M = 0.003
"""Arm, hand and what is carried keep at least this far from everything."""
SLACK_M = 0.0015
"""What rests may touch, not sink in."""
RISE = 0.25
"""What rested gains so much distance for its own way, until it is as clear as everything else."""
TOLD_APART_M = 5e-5
"""Distances from what a body rests on are told from one another down to this."""


@dataclass(frozen=True, slots=True, eq=False)
class Standing:
    """A thing the arm must not touch.

    Parameters
    ----------
    name : str
    box : Boxes
        At one place.
    beside_m : float
        How far what is carried keeps from it.
    bears : bool
        Whether what is carried may rest on it.
    """

    name: str
    box: Boxes
    beside_m: float = CLEARANCE_M
    bears: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Rest:
    """Where a body is taken up or put down.

    Parameters
    ----------
    middle : array, shape (3,)
        Of the box around it.
    gaps : mapping of name to float
        How far it then is from what bears it.
    """

    middle: Array
    gaps: Mapping[str, float]


@dataclass(frozen=True, slots=True, eq=False)
class Carried:
    """A body in the hand: its box and where its base's middle is, seen from the flange."""

    name: str
    in_hand: Array
    middle: Array
    size: Array
    rests: tuple[Rest, ...] = ()
    upright: bool = False
    """Whether what is in it would be spilled: what is round may be a cup."""

    def tilt(self, hands: Array) -> Array:
        """Return how far it leans for flange poses, shape (m, 7), in rad, shape (m,)."""
        turned = compose(hands, self.in_hand)[..., 3:]
        up = rotate_vector(turned, np.array([0.0, 0.0, 1.0]))[..., 2]
        return np.asarray(np.arccos(np.clip(up, -1.0, 1.0)))

    def box(self, hands: Array) -> Boxes:
        """Return the box around it for flange poses, shape (m, 7) or (7,)."""
        return box_at(compose(hands, self.in_hand), self.middle, self.size)

    def rested(self, hands: Array, things: tuple[Standing, ...]) -> Carried:
        """Return it as taken up and put down with the flange at poses, shape (k, 7)."""
        return replace(self, rests=tuple(self._rest(hand, things) for hand in hands))

    def _rest(self, hand: Array, things: tuple[Standing, ...]) -> Rest:
        box = self.box(hand)
        gaps = {t.name: float(boxes_apart(box, t.box)[0]) for t in things if t.bears}
        return Rest(box.center[0], gaps)

    def keeps(self, middle: Array, thing: Standing, resting: Flags | None = None) -> Array:
        """Return how far it has to keep from a thing, shape (m,).

        Parameters
        ----------
        middle : array, shape (m, 3)
            Of the box around it.
        thing : Standing
        resting : flags, shape (m,), optional
            Where it may rest on what bears it, however it came there.
        """
        least = np.full(len(middle), thing.beside_m)
        if not thing.bears:
            return least
        for rest in self.rests:
            away = np.linalg.norm(middle - rest.middle, axis=1)
            gap = rest.gaps.get(thing.name, np.inf)
            least = np.minimum(least, gap - TOLD_APART_M + RISE * away)
        return least if resting is None else np.where(resting, -SLACK_M, least)


def carried_body(scene: Scene, name: str, in_hand: Array) -> Carried | None:
    """Return a body of the scene as carried, its base at `in_hand`; None if it has no shape."""
    body = scene.bodies.get(name)
    if body is None:
        return None
    box = body_box(body, IDENTITY)
    return Carried(name, in_hand, box.center[0], 2 * box.half, upright=is_round(body))
