"""Success of tasks that corners and edges do not tell, one small function for each kind.

What is measured follows from what the target is: an object in a hole has a depth, one that was
pushed to a mark has an edge on it or not, one moved over a mark in the hand covers it, and what
is poured lies in a cup or not.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from assistant.geometry import Array, inverse, relative, transform_points
from assistant.model.motion import ArmReport, HandStop, Measure
from assistant.model.placing import alignments, base_corners
from assistant.model.scene import Body, Scene
from assistant.model.setup import Setup
from sim.touching import Trace, lies_in, pushes

EDGE_WITHIN_MM = 3.0
"""An object is at a line if both corners of its nearest edge are this close to it."""
COVERED_PERCENT = 90.0
INSIDE_PERCENT = 90.0
CLOSE_MM = 2.0
"""A mark is wiped where a base was so close to it."""
GRID_MM = 4.0
DEPTH_WITHIN_MM = 1.0
"""An object is in a hole if its base is this close to the bottom."""


def measured(
    scene: Scene,
    setup: Setup,
    stops: Sequence[HandStop],
    bodies: Mapping[str, Array],
    trace: Trace,
) -> tuple[Measure, ...]:
    """Return what there is to measure after a run, in the order of its stops."""
    found = []
    for stop in stops:
        target = scene.bodies.get(stop.frame)
        if target is None or stop.object not in bodies or stop.frame not in setup.places:
            continue
        at = bodies.get(stop.frame, scene.body_pose(stop.frame, setup.places[stop.frame]))
        seen = relative(at, bodies[stop.object])
        if stop.kind == "release" and target.hole_mm[2] > 0:
            found.append(depth(stop.object, target, seen))
        body, moved = scene.bodies.get(stop.object), trace.poses.get(stop.frame, [])
        known = {n: pose for n, pose in bodies.items() if n in scene.bodies}
        balls = {n: pose for n, pose in known.items() if scene.bodies[n].shape == "sphere"}
        if pushes(stop) and target.shape == "cup" and balls:
            found.append(inside(stop.object, target, at, balls))
        if pushes(stop) and body is not None and target.size_mm[2] == 0:
            wiped = covered(body, target, relative(at, np.array(moved))) if moved else None
            found.append(wiped or edge(body, target, seen))
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


def covered(body: Body, target: Body, in_target: Array) -> Measure:
    """Return the share of a mark an object's base has been over, close to it, in percent.

    Parameters
    ----------
    body, target : Body
    in_target : array, shape (n, 7)
        Where the object's base was, in the frame of the target's.
    """
    x, y = (np.arange(-size / 2.0 + GRID_MM / 2.0, size / 2.0, GRID_MM) for size in _flat(target))
    grid = np.stack([*np.meshgrid(x, y), np.zeros((len(y), len(x)))], axis=-1).reshape(-1, 3)
    wiped = np.zeros(len(grid), dtype=bool)
    half = np.array([*_flat(body), 2.0 * CLOSE_MM]) / 2.0
    for pose in in_target:
        seen_mm = 1000.0 * transform_points(inverse(pose), grid / 1000.0)
        wiped |= np.all(np.abs(seen_mm) <= half, axis=1)
    percent = 100.0 * float(np.mean(wiped))
    return Measure("covered", body.name, target.name, percent, "%", percent >= COVERED_PERCENT)


def inside(name: str, target: Body, at: Array, balls: Mapping[str, Array]) -> Measure:
    """Return how many balls lie in a cup, in percent.

    Parameters
    ----------
    name : str
        What they were poured from.
    target : Body
    at : array, shape (7,)
        The cup's base.
    balls : mapping of name to array, shape (7,)
        Their lowest points.
    """
    lie = [name for name, pose in balls.items() if lies_in(target, relative(at, pose))]
    percent = 100.0 * len(lie) / max(len(balls), 1)
    return Measure("inside", name, target.name, percent, "%", percent >= INSIDE_PERCENT)


def _flat(body: Body) -> tuple[float, float]:
    return body.size_mm[0], body.size_mm[1]


def finished(
    told: ArmReport,
    scene: Scene,
    setup: Setup,
    stops: Sequence[HandStop],
    bodies: Mapping[str, Array],
    trace: Trace,
) -> ArmReport:
    """Return the report of an end with alignments and measures of what was let go or touched."""
    released = [stop for stop in stops if stop.kind == "release"]
    return replace(
        told,
        alignments=alignments(scene, setup, released, bodies),
        measures=measured(scene, setup, stops, bodies, trace),
    )
