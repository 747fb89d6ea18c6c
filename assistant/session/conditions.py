"""Whether the conditions of primitives hold, judged by what is measured (paper III-C c, III-D b).

A condition is judged from the arm's look alone: joints, fingers and where a sensor sees the
bodies. What it refers to, such as the docking poses, is taken from the path the run follows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, assert_never

import numpy as np

from assistant.dialogue.conditions import Conditions, conditions_of
from assistant.geometry import (
    Array,
    angle_between,
    compose,
    distance_between,
    inverse,
    relative,
)
from assistant.model.conditions import Condition
from assistant.model.motion import HandPath, HandStop
from assistant.model.placing import in_line, is_above, place_of, place_on, rests_on
from assistant.model.scene import Body, Scene
from assistant.model.setup import Setup
from assistant.model.task import Task, primitives
from assistant.ports import ArmLook

When = Literal["before", "until"]
Expected = tuple[tuple[Conditions, Conditions], ...]
"""Before- and until-conditions by position among a tree's leaves."""

DOCKED_M, DOCKED_RAD = 0.010, float(np.deg2rad(5.0))
"""A hand this close to a docking stretch is docked: a correction by sensor moves it a little."""
TRAVEL_M = 0.005
"""A path whose opening changes by less does not tell how far open is."""
ENDING = 2
"""A primitive that ends so many samples before a docking pose ends there."""
AWAY_M = 0.03
"""A hand this far from where it would grasp a body is clear of it."""


@dataclass(frozen=True, slots=True, eq=False)
class Surroundings:
    """What conditions refer to in one run.

    Parameters
    ----------
    scene : Scene
    setup : Setup
    path : HandPath
        The whole path of the hand; only its geometry counts, not its times.
    open_m : float
        How far the hand opens.
    """

    scene: Scene
    setup: Setup
    path: HandPath
    open_m: float


@dataclass(frozen=True, slots=True)
class Unmet:
    """A condition that does not hold where it should.

    Parameters
    ----------
    condition : Condition
    primitive_at : int
        Whose condition it is.
    when : {"before", "until"}
    found : str
        For ``hand`` how the hand is instead; for ``held`` what it holds.
    """

    condition: Condition
    primitive_at: int
    when: When
    found: str = ""


def expectations(task: Task) -> Expected:
    """Return the conditions of all primitives of a task that are to hold.

    They are told, learned or implied.
    """
    return tuple(conditions_of(task, leaf) for leaf in primitives(task.tree))


def still_to_come(unmet: Unmet, next_at: int, path: HandPath) -> bool:
    """Return whether a condition comes true early in the next primitive, if all is as planned.

    A moved setup bends the free way that was shown, so that what is carried may be beside its
    place yet where the demonstration had it above. The way down to the place begins above it:
    the primitive then lasts until there.
    """
    about = ("release", unmet.condition.object, unmet.condition.target)
    ends = [s.docking_at for s in path.stops if (s.kind, s.object, s.frame) == about]
    # A step that ends docked may end a sample before.
    return unmet.condition.kind == "above" and any(
        next_at in path.primitive_at[max(end - ENDING, 0) : end + 1] for end in ends
    )


def first_unmet(
    conditions: Expected, primitive_at: int, when: When, around: Surroundings, look: ArmLook
) -> Unmet | None:
    """Return the first condition of a primitive that does not hold, None if all do."""
    if not 0 <= primitive_at < len(conditions):
        return None
    for condition in conditions[primitive_at][when == "until"]:
        if not holds(condition, around, look):
            found = _found(condition, around, look)
            return Unmet(condition, primitive_at, when, found)
    return None


def holds(condition: Condition, around: Surroundings, look: ArmLook) -> bool:
    """Return whether a condition holds now; one about things nobody placed does not."""
    name, target = condition.object or "", condition.target or ""
    match condition.kind:
        case "hand":
            return hand_state(around, look) == name
        case "held":
            return look.held == name
        case "docked":
            return _docked(name, around, look)
        case "clear":
            return look.held != name and _away(name, around, look)
        case "above":
            return _above(name, target, around, look)
        case "on" | "aligned":
            return _rests(name, target, around, look, in_line_too=condition.kind == "aligned")
        case _:
            assert_never(condition.kind)


def hand_state(around: Surroundings, look: ArmLook) -> Literal["open", "closed"]:
    """Return whether the hand is open: a hand that holds something, however wide, is not.

    The bound is half the travel, as for the instants of a recorded gripper.
    """
    low, high = float(np.min(around.path.gripper_m)), float(np.max(around.path.gripper_m))
    if high - low < TRAVEL_M:
        low, high = 0.0, around.open_m
    return "open" if not look.held and look.gripper_m > (low + high) / 2.0 else "closed"


def _found(condition: Condition, around: Surroundings, look: ArmLook) -> str:
    if condition.kind == "hand":
        return hand_state(around, look)
    return look.held if condition.kind == "held" else ""


def _docked(name: str, around: Surroundings, look: ArmLook) -> bool:
    """Return whether the hand is between a docking pose and where it acts then."""
    stretches = [_stretch(stop, around.path) for stop in around.path.stops if stop.frame == name]
    if not stretches:
        return _at_grasp(name, around, look, AWAY_M)
    way = np.concatenate(stretches)
    near = (distance_between(way, look.hand) < DOCKED_M) & (
        angle_between(way, look.hand) < DOCKED_RAD
    )
    return bool(np.any(near))


def _stretch(stop: HandStop, path: HandPath) -> Array:
    last = stop.left_at if stop.kind == "touch" else stop.at
    return path.path[stop.docking_at : last + 1]


def _away(name: str, around: Surroundings, look: ArmLook) -> bool:
    """Return whether the hand has left the place where it let a body go."""
    path = around.path
    released = [stop for stop in path.stops if stop.kind == "release" and stop.object == name]
    if not released:
        return not _at_grasp(name, around, look, AWAY_M)
    gone = (path.path[released[-1].left_at], look.hand)
    left_m, now_m = (float(distance_between(path.path[released[-1].at], one)) for one in gone)
    return now_m > min(left_m / 2.0, AWAY_M)


def _at_grasp(name: str, around: Surroundings, look: ArmLook, within_m: float) -> bool:
    body, pose = around.scene.bodies.get(name), look.bodies.get(name)
    if body is None or pose is None:
        return False
    return float(distance_between(compose(pose, body.hand_in_body), look.hand)) < within_m


def _above(name: str, target: str, around: Surroundings, look: ArmLook) -> bool:
    """Return whether a body is over its place on a target, or on its way down to it."""
    if name not in look.bodies:
        return False
    place = _place(name, target, around, look)
    if place is None:
        return False
    return bool(is_above(relative(place, look.bodies[name])[:3]))


def _rests(
    name: str, target: str, around: Surroundings, look: ArmLook, *, in_line_too: bool
) -> bool:
    body, pose = around.scene.bodies.get(name), look.bodies.get(name)
    place = _place(name, target, around, look)
    if body is None or pose is None or place is None:
        return False
    if not rests_on(around.scene, name, target, pose, place):
        return False
    if not in_line_too or in_line(body, pose, place, target):
        return True
    # What was shown just in line is so again if it lies where it was shown.
    shown = _shown(body, target, around)
    if shown is None or not in_line(body, shown, place, target):
        return False
    return in_line(body, pose, shown, target)


def _shown(body: Body, target: str, around: Surroundings) -> Array | None:
    """Return where the path lets a body go if all is as told; None where it does not."""
    stops = around.path.stops
    last = next((s for s in reversed(stops) if (s.object, s.frame) == (body.name, target)), None)
    if last is None or last.kind != "release":
        return None
    in_hand = inverse(body.hand_in_body)
    grasps = [s for s in stops if (s.kind, s.object) == ("grasp", body.name) and s.at < last.at]
    if len(grasps) == 1 and body.name in around.setup.places:
        told = around.scene.body_pose(body.name, around.setup.places[body.name])
        in_hand = compose(inverse(around.path.path[grasps[0].at]), told)
    return compose(around.path.path[last.at], in_hand)


def _place(name: str, target: str, around: Surroundings, look: ArmLook) -> Array | None:
    """Return where a body belongs on a target, as the teacher corrected it."""
    scene, setup = around.scene, around.setup
    if target not in setup.places or name not in scene.bodies:
        return None
    stops: Sequence[HandStop] = [
        stop
        for stop in around.path.stops
        if stop.kind == "release" and (stop.object, stop.frame) == (name, target)
    ]
    if stops:
        return place_of(scene, setup, stops[-1], look.bodies)
    return place_on(scene, setup, name, target, look.bodies)
