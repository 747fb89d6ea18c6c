"""Stretches in which the hand, or what it holds, touches things without grasping them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from assistant.geometry import Array, compose, inverse, relative, transform_points
from assistant.model.motion import HandStop
from assistant.model.scene import Body, Scene
from sim.a465 import GRIPPER
from sim.shapes import Boxes
from sim.world import Allowed, World

LOW_M = 0.003


def in_touch(stops: Sequence[HandStop]) -> tuple[HandStop, ...]:
    """Return the stops, the hand staying at what it pushes until that has arrived.

    A body the empty hand reached, and that the next stop brings to another place, is touched
    all the way between the two.
    """
    kept = [
        replace(stop, left_at=max(stop.left_at, later.docking_at))
        if stop.kind == "touch" and pushes(later) and later.object == stop.object
        else stop
        for stop, later in pairwise(stops)
    ]
    return (*kept, *stops[-1:])


def lies_in(cup: Body, in_cup: Array) -> bool:
    """Return whether a place, shape (7,), in a cup's frame lies between its walls."""
    radius_m, height_m = cup.size_mm[0] / 2000.0, cup.size_mm[2] / 1000.0
    beside = float(np.hypot(in_cup[0], in_cup[1])) < radius_m
    return cup.shape == "cup" and beside and -LOW_M < float(in_cup[2]) < height_m


def contents(scene: Scene, bodies: Mapping[str, Array]) -> frozenset[str]:
    """Return the balls that lie in cups: they go where those go."""
    cups = [name for name in bodies if name in scene.bodies and scene.bodies[name].shape == "cup"]
    return frozenset(
        name
        for name, pose in bodies.items()
        if name in scene.bodies
        and scene.bodies[name].shape == "sphere"
        and any(lies_in(scene.bodies[cup], relative(bodies[cup], pose)) for cup in cups)
    )


def pushes(stop: HandStop) -> bool:
    """Return whether a stop is where a body is brought without the gripper."""
    return stop.kind == "touch" and stop.object != stop.frame


def allowed_at(stops: Sequence[HandStop], sample: int, carried: str, grip: float) -> Allowed:
    """Return which contacts belong to the plan at a sample of a motion."""
    near = [stop for stop in stops if stop.docking_at <= sample <= stop.left_at]
    name = near[0].object if near else carried
    return Allowed(name, bool(near) or not carried, grip)


@dataclass(slots=True)
class Trace:
    """Where a body in the hand has been while something was done with it at a target.

    Parameters
    ----------
    poses : dict of target to list of array, shape (7,)
        Of the body's base, once a control tick.
    """

    poses: dict[str, list[Array]] = field(default_factory=dict)

    def see(self, stops: Sequence[HandStop], sample: int, carried: str, world: World) -> None:
        """Add where the body is now, if this is such a place."""
        for stop in stops:
            if pushes(stop) and stop.object == carried and stop.docking_at <= sample <= stop.at:
                self.poses.setdefault(stop.frame, []).append(world.bodies()[carried])


def push_begin(stops: Sequence[HandStop], push: HandStop) -> int:
    """Return the sample from which on a body is pushed: where the hand reached it."""
    before = [stop for stop in stops if stop.at < push.at and stop.object == push.object]
    return before[-1].at if before and before[-1].kind == "touch" else push.docking_at


def pushed(body: Array, box: Boxes, before: Array, after: Array) -> Array:
    """Return where a body is after the fingertips went through it, shape (7,).

    Parameters
    ----------
    body : array, shape (7,)
        Its base before.
    box : Boxes
        Around it.
    before, after : array, shape (7,)
        The flange.
    """
    signs = np.array(np.meshgrid(*[[-1.0, 1.0]] * 3)).reshape(3, -1).T
    corners = box.center[0] + (signs * box.half) @ box.turn[0].T
    tips_m = GRIPPER.palm_m[0] + GRIPPER.finger_m[0]
    gap = float(transform_points(inverse(before), corners)[:, 0].min()) - tips_m
    seen = relative(before, body)
    seen[0] -= max(gap, 0.0)
    # What the hand has not come up to stays where it is.
    met = float(relative(before, after)[0]) > gap
    return np.asarray(compose(after, seen)) if met else body
