"""What a hand has to do for a task: the legs of its way, from the tree and where things are.

Each primitive becomes reaches, rests and gripper commands, as a person would go about it:
dock before a body, go in straight, close; lift; come in from above, go down straight, open,
back off.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from assistant.geometry import Array, compose, quat_from_rotvec
from assistant.model.directions import WAYS
from assistant.model.placing import place_on, told_bodies
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Primitive, Task, primitives
from sim.a465 import GRIPPER

DOCK_BACK_M = 0.07
DOCK_ABOVE_M = 0.04
DOCK_OVER_HOLE_M = 0.02
OVER_MARK_M = (0.0, 0.0, 0.03)
COME_FROM_M = (-0.06, 0.0, 0.07)
"""On the way to a docking pose, seen from it: further back and higher."""
OVER_M = 0.09
LIFT_M = 0.12
STEP_M = 0.08
POUR_RAD = np.deg2rad(125.0)
TURN_RAD = np.deg2rad(20.0)

TURN_AXES = {
    "left": (0.0, 0.0, 1.0),
    "right": (0.0, 0.0, -1.0),
    "up": (0.0, -1.0, 0.0),
    "down": (0.0, 1.0, 0.0),
    "forward": (0.0, 1.0, 0.0),
    "backward": (0.0, -1.0, 0.0),
    "clockwise": (1.0, 0.0, 0.0),
    "counterclockwise": (-1.0, 0.0, 0.0),
}


@dataclass(frozen=True, slots=True, eq=False)
class Leg:
    """One stretch of the way.

    Parameters
    ----------
    primitive : int
        Position among the tree's leaves.
    goal : array, shape (7,)
        Flange at its end.
    opening_m : float
        Of the gripper at its end.
    kind : str
        ``reach`` (free), ``pass`` (free, to go on from), ``careful`` (straight, slow),
        ``grip`` (the gripper acts at rest), ``rest``.
    says : str
        What a teacher may point out at its end; may be empty.
    """

    primitive: int
    goal: Array
    opening_m: float
    kind: str
    says: str = ""


@dataclass(slots=True)
class _Way:
    """The way so far: where the hand is, what it holds, where the bodies stand."""

    scene: Scene
    setup: Setup
    hand: Array
    retreat_m: float
    opening_m: float = GRIPPER.open_m
    held: str = ""
    near: str = ""
    primitive: int = 0
    bodies: dict[str, Array] = field(default_factory=dict)
    legs: list[Leg] = field(default_factory=list)

    def go(self, goal: Array, kind: str, says: str = "") -> None:
        """Add a leg."""
        self.legs.append(Leg(self.primitive, goal, self.opening_m, kind, says))
        self.hand = goal

    def grasp_pose(self, name: str) -> Array:
        """Return the flange when it grasps a body where that now stands."""
        if name not in self.bodies or name not in self.scene.bodies:
            return self.scene.hand_pose(name, self.setup.places[name])
        return compose(self.bodies[name], self.scene.bodies[name].hand_in_body)

    def release_pose(self, target: str) -> Array:
        """Return the flange when it lets the held body go on a target."""
        place = place_on(self.scene, self.setup, self.held, target, self.bodies)
        body = self.scene.bodies.get(self.held)
        return compose(place, body.hand_in_body) if body else place


def route(task: Task, scene: Scene, setup: Setup, retreat_m: float) -> tuple[Leg, ...]:
    """Return the legs of the way through a task in a scene."""
    start = setup.robot_start.pose
    way = _Way(scene, setup, start, retreat_m, bodies=told_bodies(scene, setup))
    for position, primitive in enumerate(primitives(task.tree)):
        way.primitive = position
        _carry_out(way, primitive)
        way.go(way.hand, "rest")
    return tuple(way.legs)


def _carry_out(way: _Way, primitive: Primitive) -> None:
    verb, kind, name = primitive.action.verb, primitive.action.way, primitive.action.object or ""
    known = name if name in way.setup.places or name in way.bodies else ""
    match (verb, kind):
        case ("hand", "close"):
            _close(way, known or way.near)
        case ("hand", "open"):
            _open(way, known or way.near)
        case ("move", "approach" | "to" | "down") if known and known != way.held:
            _approach(way, known)
        case ("move", "depart"):
            way.go(compose(way.hand, _shift(-way.retreat_m, 0.0, 0.0)), "reach")
        case ("move", direction) if direction in WAYS:
            far_m = LIFT_M if direction == "up" else STEP_M
            x, y, z = WAYS[direction]
            way.go(_moved(way.hand, (far_m * x, far_m * y, far_m * z)), "reach")
        case ("turn", direction) if direction in TURN_AXES:
            turn = quat_from_rotvec(TURN_RAD * np.array(TURN_AXES[direction]))
            way.go(compose(way.hand, np.concatenate([np.zeros(3), turn])), "reach")
        case ("free", _) if known and way.held and known != way.held:
            _pour(way, known) if _is_cup(way, known) else _wipe(way, known)
        case ("free", _) if known and known != way.held:
            _push(way, known)
        case _:
            way.go(way.hand, "rest")


def _approach(way: _Way, name: str) -> None:
    way.near = name
    if way.held:
        body = way.scene.bodies.get(name)
        deep_m = body.hole_mm[2] / 1000.0 if body else 0.0
        above_m = deep_m + DOCK_OVER_HOLE_M if deep_m else DOCK_ABOVE_M
        above = way.scene.hand_pose(name, way.setup.places[name])
        above = above if _is_cup(way, name) else way.release_pose(name)
        docking = _moved(above, (0.0, 0.0, above_m))
        way.go(_moved(docking, (0.0, 0.0, OVER_M)), "pass")
        way.go(docking, "reach")
        return
    docking = compose(way.grasp_pose(name), _shift(-DOCK_BACK_M, 0.0, 0.0))
    way.go(compose(docking, _shift(*COME_FROM_M)), "pass")
    way.go(docking, "reach")


def _push(way: _Way, name: str) -> None:
    goal = way.scene.hand_pose(name, way.setup.places[name])
    way.go(goal, "careful", f"the {way.near} is at the {name}")


def _is_cup(way: _Way, name: str) -> bool:
    return name in way.scene.bodies and way.scene.bodies[name].shape == "cup"


def _pour(way: _Way, name: str) -> None:
    """Tilt what is held over a cup, wait, and put it upright again."""
    upright = way.scene.hand_pose(name, way.setup.places[name])
    tilt = np.concatenate([np.zeros(3), quat_from_rotvec(np.array([POUR_RAD, 0.0, 0.0]))])
    way.go(upright, "careful")
    way.go(compose(upright, tilt), "careful")
    way.go(way.hand, "rest")
    way.go(way.hand, "rest")
    way.go(upright, "careful", f"the {way.held} is empty now")


def _wipe(way: _Way, name: str) -> None:
    """Go over a mark in rows, there and back, what is held resting on it."""
    middle, mark, held = way.release_pose(name), way.scene.bodies[name], way.scene.bodies[way.held]
    reach = [max(mark.size_mm[k] - held.size_mm[k], 0.0) / 2000.0 for k in (0, 1)]
    rows = int(np.ceil(mark.size_mm[0] / held.size_mm[0]))
    lines = np.linspace(-reach[0], reach[0], rows) if rows > 1 else np.zeros(1)
    way.go(_moved(compose(middle, _shift(lines[0], -reach[1], 0.0)), OVER_MARK_M), "careful")
    side = -reach[1]
    for line in (*lines, *lines[::-1]):
        way.go(compose(middle, _shift(float(line), side, 0.0)), "careful")
        side = -side
        way.go(compose(middle, _shift(float(line), side, 0.0)), "careful")


def _close(way: _Way, name: str) -> None:
    if name:
        if way.near != name:
            _approach(way, name)
        way.go(way.grasp_pose(name), "careful")
    way.go(way.hand, "rest")
    way.opening_m = _width(way, name)
    way.go(way.hand, "grip", f"the {name} is in the hand now" if name else "")
    way.held = name


def _open(way: _Way, name: str) -> None:
    if way.held and name and name != way.held:
        if way.near != name:
            _approach(way, name)
        place = way.release_pose(name)
        way.go(place, "careful")
        way.bodies[way.held] = place_on(way.scene, way.setup, way.held, name, way.bodies)
    way.go(way.hand, "rest")
    way.opening_m = GRIPPER.open_m
    way.go(way.hand, "grip", f"the {way.held} is on the {name}" if way.held and name else "")
    if way.held:
        way.go(way.hand, "rest")
        way.go(compose(way.hand, _shift(-way.retreat_m, 0.0, 0.0)), "careful")
    way.held = ""


def _width(way: _Way, name: str) -> float:
    body = way.scene.bodies.get(name)
    return min(body.size_mm[1] / 1000.0, GRIPPER.open_m) if body else 0.0


def _shift(x: float, y: float, z: float) -> Array:
    return np.array([x, y, z, 0.0, 0.0, 0.0, 1.0])


def _moved(pose: Array, step: tuple[float, float, float]) -> Array:
    return np.concatenate([pose[:3] + np.array(step), pose[3:]])
