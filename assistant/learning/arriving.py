"""Where a way ends and what is done at its end begins, though one step tells of both.

"Wipe the tray" may begin where the sponge was grasped: what is done at the tray keeps its
shape with the tray, but the way there has to lead from wherever the sponge stands.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from assistant.geometry import Array, compose, inverse
from assistant.learning.docking import way_end
from assistant.model.motion import Indices
from assistant.model.scene import Scene
from assistant.model.settings import GeneralizationSettings

_SLOW = 0.5
"""Of the greatest speed on the way so far: a hand slower than this, and slowest there, has come
somewhere."""


@dataclass(frozen=True, slots=True, eq=False)
class Site:
    """A place where something is done with what is in the hand.

    Parameters
    ----------
    world_in_place : array, shape (7,)
        The world, seen from the middle of the place's base.
    held_in_hand : array, shape (7,)
        The base of what is held, seen from the flange.
    half_m : array, shape (2,)
        Half of the place's length and width.
    """

    world_in_place: Array
    held_in_hand: Array
    half_m: Array

    def reached(self, path: Array, beside_m: float) -> NDArray[np.bool_]:
        """Return where on a path, shape (m, 7), what is held is over the place, or so near."""
        seen = compose(self.world_in_place, compose(path, self.held_in_hand))
        return np.asarray(np.all(np.abs(seen[:, :2]) <= self.half_m + beside_m, axis=1))


def site_of(held: str, place: str, frame: Array, scene: Scene | None) -> Site | None:
    """Return a place whose frame, shape (7,), is a flange's; None if either size is unknown."""
    bodies = scene.bodies if scene else {}
    if held not in bodies or place not in bodies:
        return None
    below = bodies[place]
    return Site(
        compose(below.hand_in_body, inverse(frame)),
        inverse(bodies[held].hand_in_body),
        np.array(below.size_mm[:2]) / 2000.0,
    )


def arrival(
    path: Array,
    earliest: int,
    begin: int,
    at: int,
    site: Site | None,
    given: GeneralizationSettings,
) -> int:
    """Return the sample from which on a motion belongs to the place where it is done.

    That is where its step begins, if there is a way before it; else where the hand first comes
    to rest at the place, or anywhere where the place's size is not known.

    Parameters
    ----------
    path : array, shape (n, 7)
        Evenly sampled.
    earliest, begin, at : int
        Where the hand has left the station before, where the step begins, and where it ends.
    site : Site, optional
        The place, if its size is known.
    given : GeneralizationSettings
    """
    if np.linalg.norm(path[begin, :3] - path[earliest, :3]) > given.docking_far_m:
        return begin
    rests = earliest + _rests(path[earliest : at + 1, :3])
    away = np.linalg.norm(path[rests, :3] - path[earliest, :3], axis=1)
    rests = rests[away > given.docking_far_m]
    if site is not None:
        there = site.reached(path[earliest : at + 1], given.docking_m)
        inside = rests[there[rests - earliest]]
        entered = earliest + np.flatnonzero(there)
        rests = inside if len(inside) else entered
    # Without a rest, and without a place to come to, some of it has to be a way all the same.
    return int(rests[0]) if len(rests) else way_end(path[:, :3], earliest, at)


def _rests(xyz: Array) -> Indices:
    """Return where the hand is slow and slowest, as seen from its way so far."""
    speed = np.linalg.norm(np.diff(xyz, axis=0), axis=1)
    if len(speed) < 3:
        return np.zeros(0, dtype=np.int64)
    least = (speed[1:-1] <= speed[:-2]) & (speed[1:-1] < speed[2:])
    slow = speed[1:-1] < _SLOW * np.maximum.accumulate(speed)[1:-1]
    return 1 + np.flatnonzero(least & slow)
