"""Hand paths of pick and place made from minimum-jerk pieces, without any learning."""

from __future__ import annotations

from typing import Literal

import numpy as np

from assistant.geometry import IDENTITY, Array, compose, quat_blend
from assistant.model.lesson import Lesson, Segmentation, Station
from assistant.model.motion import HandPath, HandStop
from assistant.model.scene import Body, Obstacle, Scene
from assistant.model.setup import READY, Place, Setup, Triple
from assistant.model.task import Subtask, Task, TaskObject

STEP_S = 0.02
OPEN_M, CLOSED_M = 0.08, 0.04

TABLE = Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0))
MARK = Body("target", size_mm=(60.0, 40.0, 0.0), mass_kg=0.0)


def scene(*obstacles: Obstacle) -> Scene:
    """Return the practice table with a block and a marked target."""
    bodies = {"block": Body("block"), "target": MARK}
    return Scene("table", bodies, (TABLE,), obstacles)


def setup(
    block: Triple, block_yaw: float, target: Triple, target_yaw: float, start: Place = READY
) -> Setup:
    """Return a setup told as the paper does, in mm and degrees of the flange."""
    places = {
        "block": Place("hand", block, (0.0, 0.0, block_yaw)),
        "target": Place("hand", target, (0.0, 0.0, target_yaw)),
    }
    return Setup("test", "table", start, places)


TABLE1 = (
    setup((533.0, 270.0, 300.0), 0.0, (427.6, -230.3, 300.0), -15.0),
    setup((553.0, 190.0, 300.0), 0.0, (520.0, -248.6, 300.0), 40.0),
    setup((547.6, 275.5, 300.0), -35.0, (554.5, -187.4, 300.0), 55.0),
    setup(
        (533.0, 270.0, 300.0),
        0.0,
        (523.0, -239.9, 300.0),
        5.0,
        Place("hand", (510.0, -241.0, 300.0), (0.0, 0.0, 5.0)),
    ),
)


def back(pose: Array, by_m: float) -> Array:
    """Return a pose drawn back along the hand's approach."""
    return compose(pose, np.array([-by_m, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]))


def up(pose: Array, by_m: float) -> Array:
    """Return a pose lifted straight up."""
    return np.asarray(pose + np.array([0.0, 0.0, by_m, 0.0, 0.0, 0.0, 0.0]))


def pick_and_place(scene: Scene, setup: Setup) -> HandPath:
    """Return the path from the robot start over the block to the target, about 16 s."""
    start = setup.robot_start.pose
    grasp = scene.hand_pose("block", setup.places["block"])
    release = scene.hand_pose("target", setup.places["target"])
    pieces = [
        (start, start, 0.2, OPEN_M),
        (start, back(grasp, 0.05), 4.0, OPEN_M),
        (back(grasp, 0.05), grasp, 1.5, OPEN_M),
        (grasp, grasp, 0.6, CLOSED_M),
        (grasp, up(grasp, 0.10), 1.5, CLOSED_M),
        (up(grasp, 0.10), up(release, 0.08), 5.0, CLOSED_M),
        (up(release, 0.08), release, 1.5, CLOSED_M),
        (release, release, 0.6, OPEN_M),
        (release, back(release, 0.05), 1.5, OPEN_M),
        (back(release, 0.05), back(release, 0.05), 0.2, OPEN_M),
    ]
    ends = np.cumsum([round(piece[2] / STEP_S) for piece in pieces])
    path = np.concatenate([start[None], *(_piece(*piece[:3]) for piece in pieces)])
    gripper = np.concatenate([[OPEN_M], *(_opening(piece[2], piece[3]) for piece in pieces)])
    primitive = np.searchsorted(ends, np.arange(len(path)), side="left") // 2
    rest = int(0.3 / STEP_S)
    stops = (
        _stop("grasp", "block", ends[1], ends[2] + rest, ends[4]),
        _stop("release", "target", ends[5], ends[6] + rest, ends[8]),
    )
    t_s: Array = np.linspace(0.0, STEP_S * (len(path) - 1), len(path))
    return HandPath(t_s, path, gripper, primitive, stops)


def _stop(
    kind: Literal["grasp", "release"], frame: str, docking: int, at: int, left: int
) -> HandStop:
    return HandStop(int(at), kind, "block", frame, int(docking), int(left))


def _opening(lasts_s: float, opening: float) -> Array:
    return np.full(round(lasts_s / STEP_S), opening)


def _piece(first: Array, second: Array, lasts_s: float) -> Array:
    count = round(lasts_s / STEP_S)
    s = np.arange(1, count + 1) / count
    s = s**3 * (10.0 - 15.0 * s + 6.0 * s * s)
    turn = quat_blend(first[3:], second[3:], s)
    radius, azimuth = _polar(first), _polar(second)
    r = (1.0 - s) * radius[0] + s * azimuth[0]
    angle = (1.0 - s) * radius[1] + s * azimuth[1]
    z = (1.0 - s) * first[2] + s * second[2]
    straight = np.linalg.norm(first[:2] - second[:2]) < 0.15
    xy = (1.0 - s)[:, None] * first[:2] + s[:, None] * second[:2]
    if not straight:
        xy = np.stack([r * np.cos(angle), r * np.sin(angle)], axis=1)
    return np.concatenate([xy, z[:, None], turn], axis=1)


def _polar(pose: Array) -> tuple[float, float]:
    return float(np.hypot(pose[0], pose[1])), float(np.arctan2(pose[1], pose[0]))


def taught() -> Task:
    """Return pick and place with the stations of `pick_and_place`, nothing else learned."""
    stations = (
        _station("grasp", "block", (-0.05, 0.0, 0.0)),
        _station("release", "target", (0.0, 0.0, 0.08)),
    )
    lesson = Lesson(Segmentation((), (), None), None, stations)
    objects = (TaskObject("block", "object"), TaskObject("target", "target"))
    return Task("pick_and_place", Subtask("pick and place"), "", objects, lesson)


def _station(kind: Literal["grasp", "release"], frame: str, docking: Triple) -> Station:
    here = np.array(IDENTITY)
    away = np.concatenate([docking, here[3:]])
    return Station(kind, "block", frame, kind, 0, 0, 0, here, here, away)
