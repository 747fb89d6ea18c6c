"""Success of tasks that corners and edges do not tell, one small function for each kind.

What is measured follows from what the target is: an object in a hole has a depth, one that was
pushed to a mark has an edge on it or not.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from assistant.geometry import Array, relative, transform_points
from assistant.model.motion import ArmReport, HandStop, Measure
from assistant.model.scene import Body, Scene
from assistant.model.setup import Setup
from sim.alignment import alignments, base_corners
from sim.touching import pushes

EDGE_WITHIN_MM = 3.0
"""An object is at a line if both corners of its nearest edge are this close to it."""
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
        seen = relative(at, bodies[stop.object])
        if stop.kind == "release" and target.hole_mm[2] > 0:
            found.append(depth(stop.object, target, seen))
        if pushes(stop) and target.size_mm[2] == 0:
            found.append(edge(scene.bodies[stop.object], target, seen))
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


def edge(body: Body, target: Body, in_target: Array) -> Measure:
    """Return how far an object's nearest edge is from the line x = 0 of a mark.

    Parameters
    ----------
    body, target : Body
    in_target : array, shape (7,)
        The object's base in the frame of the target's.
    """
    corners_mm = 1000.0 * transform_points(in_target, base_corners(body))[:, 0]
    nearest = np.sort(np.abs(corners_mm))[:2]
    off_mm = float(nearest[1])
    return Measure("edge", body.name, target.name, off_mm, "mm", off_mm <= EDGE_WITHIN_MM)


def finished(
    told: ArmReport,
    scene: Scene,
    setup: Setup,
    stops: Sequence[HandStop],
    bodies: Mapping[str, Array],
) -> ArmReport:
    """Return the report of an end with alignments and measures of what was let go or touched."""
    released = [stop for stop in stops if stop.kind == "release"]
    return replace(
        told,
        alignments=alignments(scene, setup, released, bodies),
        measures=measured(scene, setup, stops, bodies),
    )
