"""Success of tasks that corners and edges do not tell, one small function for each kind.

What is measured follows from what the target is: an object in a hole has a depth.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from assistant.geometry import Array, relative
from assistant.model.motion import HandStop, Measure
from assistant.model.scene import Body, Scene
from assistant.model.setup import Setup

DEPTH_WITHIN_MM = 1.0
"""An object is in a hole if its base is this close to the bottom."""


def measured(
    scene: Scene, setup: Setup, released: Sequence[HandStop], bodies: Mapping[str, Array]
) -> tuple[Measure, ...]:
    """Return what there is to measure after a run, in the order of its stops."""
    found = []
    for stop in released:
        target = scene.bodies.get(stop.frame)
        if target is None or stop.object not in bodies or stop.frame not in setup.places:
            continue
        at = bodies.get(stop.frame, scene.body_pose(stop.frame, setup.places[stop.frame]))
        if stop.kind == "release" and target.hole_mm[2] > 0:
            found.append(depth(stop.object, target, relative(at, bodies[stop.object])))
    return tuple(found)


def depth(name: str, target: Body, in_target: Array) -> Measure:
    """Return how far the middle of an object's base is below the rim of a hole.

    Parameters
    ----------
    name : str
    target : Body
    in_target : array, shape (7,)
        The object's base in the frame of the target's.
    """
    deep_mm = target.size_mm[2] - 1000.0 * float(in_target[2])
    beside = max(abs(1000.0 * float(in_target[k])) - target.hole_mm[k] / 2.0 for k in (0, 1))
    good = deep_mm >= target.hole_mm[2] - DEPTH_WITHIN_MM and beside < 0.0
    return Measure("depth", name, target.name, deep_mm, "mm", good)
