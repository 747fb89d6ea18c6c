"""Paths of the hand a session makes itself: as shown, the rest of a run, small steps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assistant.geometry import (
    Array,
    angle_between,
    compose,
    distance_between,
    interpolate,
    quat_from_rotvec,
    quat_multiply,
)
from assistant.model.demonstration import Demonstration
from assistant.model.motion import HandPath, HandStop, Indices
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task, primitives
from assistant.ports import ArmLook

STEP_S = 0.02
HAND_S = 1.0
"""For opening or closing the hand at rest."""
JOG_M_S, JOG_RAD_S = 0.05, 0.3
SHORTEST_S = 0.4
AROUND_M = 0.05
"""A shown grasp or release is constrained over so much of the way to and from it."""
OPENED_M = 1e-4
"""Fingers this close to where they open to have opened."""
NEAR_GRASP_M = 0.03
"""A hand this close to where it would grasp a body closes on it."""


def adapted(task: Task, scene: Scene, setup: Setup, speed: float) -> HandPath:
    """Return the learned path adapted to a setup (paper III-D a)."""
    from assistant.learning.adaptation import adapt, plan_adaptation

    path: HandPath = adapt(plan_adaptation(task), scene, setup, speed=speed)
    return path


def as_shown(task: Task, demonstration: Demonstration, speed: float) -> HandPath:
    """Return the demonstration's own path, with the primitives its episodes were assigned."""
    shown = demonstration.recording
    gripper = shown.gripper_m if shown.gripper_m is not None else np.zeros(len(shown.t_s))
    t_s = (shown.t_s - shown.t_s[0]) / speed
    primitive_at = _primitives_shown(task, shown.t_s)
    return HandPath(t_s, shown.path, gripper, primitive_at, _stops_shown(task, shown.path, gripper))


def _stops_shown(task: Task, path: Array, gripper_m: Array) -> tuple[HandStop, ...]:
    """Return where the hand acted: where its opening crosses half its travel."""
    stations = () if task.learned is None else task.learned.stations
    acted = [station for station in stations if station.kind != "touch"]
    closed = gripper_m < (np.min(gripper_m) + np.max(gripper_m)) / 2.0
    instants = np.flatnonzero(np.diff(closed.astype(int))) + 1
    return tuple(
        HandStop(int(at), station.kind, station.object, station.frame, *_around(path, int(at)))
        for at, station in zip(instants, acted, strict=False)
    )


def _around(path: Array, at: int) -> tuple[int, int]:
    """Return the samples between which a path stays near one of its samples."""
    far = np.flatnonzero(distance_between(path, path[at]) > AROUND_M)
    before, after = far[far < at], far[far > at]
    first = int(before[-1]) + 1 if len(before) else 0
    return first, int(after[0]) - 1 if len(after) else len(path) - 1


def _primitives_shown(task: Task, t_s: Array) -> Indices:
    found = np.full(len(t_s), -1, dtype=np.int64)
    if task.learned is None:
        return found
    names = [leaf.name for leaf in primitives(task.tree)]
    for episode in task.learned.segmentation.episodes:
        if episode.primitive in names:
            inside = (t_s >= episode.from_s) & (t_s <= episode.to_s)
            found[inside] = names.index(episode.primitive)
    return found


def rest_of(path: HandPath, look: ArmLook, primitive_at: int, scene: Scene) -> HandPath:
    """Return what is left of a path, led to from where the arm is.

    Parameters
    ----------
    path : HandPath
        The whole run.
    look : ArmLook
        Where the arm was halted.
    primitive_at : int
        The primitive it was in; -1 for none.
    scene : Scene
    """
    start = goes_on_at(path, look, primitive_at, scene)
    lead = _straight(look.hand, path.path[start])
    lead_t = STEP_S * np.arange(len(lead), dtype=float)
    t_s = np.concatenate([lead_t, lead_t[-1] + STEP_S + path.t_s[start:] - path.t_s[start]])
    return HandPath(
        t_s,
        np.concatenate([lead, path.path[start:]]),
        np.concatenate([np.full(len(lead), look.gripper_m), path.gripper_m[start:]]),
        np.concatenate([np.full(len(lead), primitive_at), path.primitive_at[start:]]),
        tuple(_moved(stop, len(lead) - start) for stop in path.stops if stop.at >= start),
    )


def goes_on_at(path: HandPath, look: ArmLook, primitive_at: int, scene: Scene) -> int:
    """Return the sample of a path from which what is left of it is done."""
    apart = distance_between(path.path, look.hand) + 0.1 * angle_between(path.path, look.hand)
    if primitive_at >= 0:
        apart = np.where(path.primitive_at == primitive_at, apart, np.inf)
    for stop in path.stops:
        # A body in the hand was grasped already; one on the table has to be grasped yet.
        if stop.kind == "grasp" and stop.object == look.held:
            apart[: stop.at + 1] = np.inf
        if path.primitive_at[stop.at] == primitive_at and _lies_there(path, stop, look, scene):
            apart[stop.at + 1 :] = np.inf
        # What was let go where it belongs is not taken there again: the ways to and from a
        # place lie so close that the nearest sample may be one before.
        if path.primitive_at[stop.at] == primitive_at and _let_go(path, stop, look, scene):
            apart[: stop.at + _opened(path, stop, look)] = np.inf
            apart[stop.at + 1 :] += 0.0 if _opened(path, stop, look) else np.inf
    return int(np.argmin(apart))


def _opened(path: HandPath, stop: HandStop, look: ArmLook) -> bool:
    """Return whether the fingers are as far apart as a release leaves them."""
    return bool(look.gripper_m > path.gripper_m[stop.left_at] - OPENED_M)


def _let_go(path: HandPath, stop: HandStop, look: ArmLook, scene: Scene) -> bool:
    """Return whether a body is out of the hand and where a release leaves it."""
    return stop.kind == "release" and _beside(path, stop, look, scene)


def _lies_there(path: HandPath, stop: HandStop, look: ArmLook, scene: Scene) -> bool:
    """Return whether a body is out of the hand and still where it is to be grasped."""
    return stop.kind == "grasp" and _beside(path, stop, look, scene)


def _beside(path: HandPath, stop: HandStop, look: ArmLook, scene: Scene) -> bool:
    """Return whether a body is out of the hand, where the hand acts on it at a stop."""
    body, pose = scene.bodies.get(stop.object), look.bodies.get(stop.object)
    if body is None or pose is None or look.held == stop.object:
        return False
    left = path.path[stop.at]
    return float(distance_between(compose(pose, body.hand_in_body), left)) < NEAR_GRASP_M


def _moved(stop: HandStop, by: int) -> HandStop:
    return replace(
        stop,
        at=stop.at + by,
        docking_at=max(stop.docking_at + by, 0),
        left_at=stop.left_at + by,
    )


def hand_only(look: ArmLook, scene: Scene, command: str, open_m: float) -> HandPath:
    """Return a path that rests while the hand opens or closes.

    Parameters
    ----------
    look : ArmLook
    scene : Scene
    command : {"open", "close"}
    open_m : float
        How far the open hand is open.
    """
    count = round(HAND_S / STEP_S)
    closing = command == "close"
    name = look.held or (_between_fingers(look, scene) if closing else "")
    stop = HandStop(count // 2, "grasp" if closing else "release", name, "", 0, count - 1)
    gripper = np.where(np.arange(count) < stop.at, look.gripper_m, 0.0 if closing else open_m)
    path = np.tile(look.hand, (count, 1))
    return HandPath(STEP_S * np.arange(count, dtype=float), path, gripper, _none(count), (stop,))


def _between_fingers(look: ArmLook, scene: Scene) -> str:
    """Return the name of the body the hand would close on; empty if there is none."""
    for name, pose in look.bodies.items():
        body = scene.bodies.get(name)
        if body is None or body.mass_kg == 0.0:
            continue
        grasp = compose(pose, body.hand_in_body)
        if float(distance_between(grasp, look.hand)) < NEAR_GRASP_M:
            return name
    return ""


def step_by(look: ArmLook, offset_m: tuple[float, ...], turn_rad: tuple[float, ...]) -> HandPath:
    """Return a straight small step of the hand, in the base frame's axes."""
    goal = np.concatenate(
        [
            look.hand[:3] + np.asarray(offset_m),
            quat_multiply(quat_from_rotvec(np.asarray(turn_rad)), look.hand[3:]),
        ]
    )
    return straight_to(look, goal)


def straight_to(look: ArmLook, goal: Array) -> HandPath:
    """Return a straight path of the hand to a pose, shape (7,), the hand as open as it is."""
    path = _straight(look.hand, goal)
    count = len(path)
    return HandPath(
        STEP_S * np.arange(count, dtype=float), path, np.full(count, look.gripper_m), _none(count)
    )


def _straight(start: Array, goal: Array) -> Array:
    far = float(distance_between(start, goal)) / JOG_M_S
    turned = float(angle_between(start, goal)) / JOG_RAD_S
    # A minimum-jerk course peaks at 15/8 of its mean speed.
    count = max(round(1.875 * max(far, turned, SHORTEST_S) / STEP_S), 2)
    share = np.linspace(0.0, 1.0, count)
    return interpolate(start, goal, share**3 * (10.0 - 15.0 * share + 6.0 * share**2))


def _none(count: int) -> Indices:
    return np.full(count, -1, dtype=np.int64)
