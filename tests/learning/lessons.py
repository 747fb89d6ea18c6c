"""A made demonstration of pick-and-place, and the lesson learned from it, for tests."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from assistant.geometry import (
    Array,
    angle_between,
    distance_between,
    pose_from_mm_deg,
    quat_blend,
    relative,
)
from assistant.learning.adaptation import AdaptationPlan, frames_in
from assistant.learning.lesson import learn
from assistant.learning.weights import least_jerk
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.feedback import Feedback
from assistant.model.lesson import Lesson
from assistant.model.motion import HandPath
from assistant.model.scene import Scene
from assistant.model.setup import Place, Setup
from assistant.model.task import Action, Primitive, Subtask, Task, TaskObject

BLOCK = Place("hand", (560.3, 196.8, 396.7))
TARGET = Place("hand", (588.8, -201.7, 403.0), (0.0, 0.0, 34.7))
NAMES = ("approach object", "grasp object", "move up object", "move down", "place object")
CUTS_S = (4.0, 6.0, 8.0, 12.0)
SCENE = Scene(hand_speed_m_s=1.0)
SHOWN = Setup("shown", places={"block": BLOCK, "target": TARGET})


def task() -> Task:
    actions = (
        Action("move", "approach", "block"),
        Action("hand", "close", "block"),
        Action("move", "up", "block"),
        Action("move", "down", "target"),
        Action("hand", "open", "target"),
    )
    leaves = tuple(Primitive(name, act) for name, act in zip(NAMES, actions, strict=True))
    tree = Subtask(
        "pick and place",
        (Subtask("pick up", leaves[:3]), Subtask("place", leaves[3:])),
    )
    objects = (TaskObject("block", "object"), TaskObject("target", "target"))
    return Task("pick_and_place", tree, "", objects)


def poses() -> tuple[Array, Array]:
    """Return when the hand is where: knots of a person's motion, shapes (k,) and (k, 7)."""
    knots = [
        (0.0, (406.4, 0.0, 635.0), (0.0, 0.0, 0.0)),
        (3.6, (490.0, 200.0, 415.0), (2.0, -3.0, 4.0)),
        (4.4, (490.0, 200.0, 415.0), (2.0, -3.0, 4.0)),
        (5.5, (560.3, 196.8, 396.7), (0.0, 0.0, 0.0)),
        (6.5, (560.3, 196.8, 396.7), (0.0, 0.0, 0.0)),
        (7.8, (555.0, 190.0, 520.0), (0.0, 0.0, 5.0)),
        (8.2, (555.0, 190.0, 520.0), (0.0, 0.0, 5.0)),
        (11.7, (590.0, -195.0, 445.0), (1.0, 2.0, 30.0)),
        (12.3, (590.0, -195.0, 445.0), (1.0, 2.0, 30.0)),
        (13.5, (588.8, -201.7, 403.0), (0.0, 0.0, 34.7)),
        (14.5, (588.8, -201.7, 403.0), (0.0, 0.0, 34.7)),
        (16.0, (470.0, -280.0, 410.0), (0.0, 0.0, 34.7)),
    ]
    times = np.array([knot[0] for knot in knots])
    return times, np.array([pose_from_mm_deg(xyz, rpy) for _, xyz, rpy in knots])


def demonstration(
    noise_m: float = 0.0, seed: int = 0, *, gripper: bool = True, hasty: bool = False
) -> Demonstration:
    """Return a demonstration; `hasty` closes the hand while it still moves."""
    times, knots = poses()
    t_s = np.arange(0.0, 16.0001, 0.02)
    after = np.clip(np.searchsorted(times, t_s, side="right"), 1, len(times) - 1)
    share = least_jerk((t_s - times[after - 1]) / (times[after] - times[after - 1]))
    first, second = knots[after - 1], knots[after]
    xyz = first[:, :3] + share[:, None] * (second[:, :3] - first[:, :3])
    path = np.hstack([xyz, quat_blend(first[:, 3:], second[:, 3:], share)])
    path[:, :3] += np.random.default_rng(seed).normal(0.0, noise_m, (len(t_s), 3))
    closes = 5.0 if hasty else 6.0
    opening = np.interp(t_s, [closes - 0.15, closes + 0.15, 13.85, 14.15], [0.08, 0.04, 0.04, 0.08])
    recording = Recording(t_s, path, opening if gripper else None)
    setup = Setup("shown", "table", places={"block": BLOCK, "target": TARGET})
    return Demonstration(recording, setup=setup, source="made")


def sliding_in() -> Demonstration:
    """Return a demonstration in which the block comes to its target at the target's height."""
    shown = demonstration()
    t_s, path = shown.recording.t_s, shown.recording.path.copy()
    carried, last = least_jerk((t_s - 8.2) / 3.5), least_jerk((t_s - 12.3) / 1.2)
    path[:, 1] -= 0.06 * carried * (1.0 - last)
    path[:, 2] -= 0.042 * carried * (1.0 - last)
    return replace(shown, recording=replace(shown.recording, path=path))


@lru_cache
def lesson(noise_m: float = 0.0, seed: int = 0, *, hasty: bool = False) -> Lesson:
    return learn([demonstration(noise_m, seed, hasty=hasty)], task(), cuts_s=CUTS_S, scene=Scene())


def learned(feedback: Sequence[Feedback] = (), noise_m: float = 0.0) -> Task:
    return replace(task(), learned=replace(lesson(noise_m), feedback=tuple(feedback)))


def moved(rng: np.random.Generator, name: str = "moved") -> Setup:
    """Return a setup with block, target and start somewhere else."""

    def place(x: float, y: float, z: float, yaw: float) -> Place:
        turn = (0.0, 0.0, float(yaw + rng.uniform(-30.0, 30.0)))
        at = (x + rng.uniform(-80, 60), y + rng.uniform(-80, 80), z + rng.uniform(-90, 30))
        return Place("hand", at, turn)

    start = Place("hand", (406.4, float(rng.uniform(-100, 100)), 635.0))
    places = {"block": place(560, 197, 397, 0.0), "target": place(589, -202, 403, 10.0)}
    return Setup(name, "table", start, places)


def around(rng: np.random.Generator) -> Setup:
    """Return a setup with block, target and start anywhere around the base."""

    def place(z_mm: float) -> Place:
        azimuth, radius_mm = rng.uniform(-165.0, 165.0), rng.uniform(400.0, 620.0)
        ray, yaw = np.deg2rad(azimuth), azimuth + rng.uniform(-60.0, 60.0)
        at = (float(radius_mm * np.cos(ray)), float(radius_mm * np.sin(ray)), z_mm)
        return Place("hand", at, (0.0, 0.0, float(yaw)))

    places = {"block": place(400.0), "target": place(400.0)}
    return Setup("around", "table", place(float(rng.uniform(380.0, 700.0))), places)


def errors(plan: AdaptationPlan, path: HandPath, setup: Setup) -> list[float]:
    """Return how far the hand is from where it should be at each station, in m and rad."""
    found = []
    for frame, one in zip(frames_in(plan, SCENE, setup), plan.stations, strict=True):
        seen = relative(frame, path.path[one.at])
        found.append(float(distance_between(seen, one.hand_in_frame)))
        found.append(float(angle_between(seen, one.hand_in_frame)))
    return found
