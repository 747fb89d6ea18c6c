"""Random setups over the whole annulus the arm can reach, for practice and evaluation.

Places of objects and targets, their turn and the robot start are drawn; what overlaps, or what
a plain check (`sim.feasibility`) says cannot be reached, is drawn again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import count
from typing import Literal

import numpy as np

from assistant.errors import WorkFailed
from assistant.geometry import Array, compose, interpolate, inverse
from assistant.model.lesson import Station
from assistant.model.scene import Scene
from assistant.model.setup import READY, Place, Setup, Triple
from assistant.model.task import Task
from sim.a465 import GRIPPER
from sim.arranging import arranged
from sim.feasibility import Posture, reachable

Sector = Literal["front", "all"]

FRONT_DEG, ALL_DEG = 70.0, 180.0
TRIES = 4000
BETWEEN = 9
"""Postures looked at from docking to grasp or release."""
ALONG = 25
"""Postures looked at along a push."""
EVERY = 20
"""Samples of a learned path between the postures of a pour or a wipe."""


def random_setup(
    task: Task,
    scene: Scene,
    seed: int,
    number: int,
    sector: Sector = "all",
    *,
    random_start: bool = True,
) -> Setup:
    """Return a reachable setup; the same seed and number give the same one.

    Parameters
    ----------
    task : Task
        Learned: its stations say which poses must be held.
    scene : Scene
        Bodies stand on its tables, where those reach.
    seed, number : int
        Not negative.
    sector : {"front", "all"}
        Azimuths within 70 degrees of straight ahead, or all around.
    random_start : bool
        Draw the robot start, too; else it is READY.

    Raises
    ------
    WorkFailed
        If no setup is found among thousands drawn.
    """
    random = np.random.default_rng([seed, number])
    for _ in range(TRIES):
        start = drawn_start(random, _half_deg(sector)) if random_start else READY
        setup = drawn_setup(task, scene, random, sector, start)
        if setup is not None and reachable(postures(task, scene, setup), scene):
            return replace(setup, name=f"random_{number}")
    raise WorkFailed(f"no reachable setup among {TRIES} drawn for {task.name}")


def random_setups(
    task: Task,
    scene: Scene,
    seed: int,
    sector: Sector = "all",
    *,
    random_start: bool = True,
) -> Iterator[Setup]:
    """Yield reachable setups 1, 2, .. without end, see `random_setup`."""
    for number in count(1):
        yield random_setup(task, scene, seed, number, sector, random_start=random_start)


def new_setup(
    task: Task,
    scene: Scene,
    setup: Setup,
    seed: int,
    goes_on: Callable[[int], bool] = lambda drawn: True,
) -> Setup | None:
    """Return a new reachable setup ahead of the robot, which starts where it did; else None.

    `goes_on` is asked before each draw, with how many there have been.
    """
    random = np.random.default_rng(seed)
    for drawn_before in range(TRIES):
        if not goes_on(drawn_before):
            return None
        drawn = drawn_setup(task, scene, random, "front", setup.robot_start)
        if drawn is not None and reachable(postures(task, scene, drawn), scene):
            return replace(drawn, name=f"new_{seed}")
    return None


def _half_deg(sector: Sector) -> float:
    return FRONT_DEG if sector == "front" else ALL_DEG


def drawn_setup(
    task: Task, scene: Scene, random: np.random.Generator, sector: Sector, start: Place
) -> Setup | None:
    """Return a setup as it is drawn, within reach or not; None where things would overlap."""
    places = arranged(task, scene, random, _half_deg(sector))
    return None if places is None else Setup("random", scene.name, start, places)


def drawn_start(random: np.random.Generator, half_deg: float) -> Place:
    """Return a robot start, drawn at an azimuth within so much of straight ahead."""
    azimuth = random.uniform(-half_deg, half_deg)
    radius, height = random.uniform(320.0, 640.0), random.uniform(380.0, 760.0)
    ray = np.deg2rad(azimuth)
    xyz = (radius * np.cos(ray), radius * np.sin(ray), height)
    roll, pitch, yaw = random.uniform([-15.0, -20.0, -45.0], [15.0, 20.0, 45.0])
    yaw = (azimuth + yaw + 180.0) % 360.0 - 180.0
    return Place("hand", _rounded(xyz), _rounded((roll, pitch, yaw)))


def _rounded(values: tuple[float, float, float]) -> Triple:
    return (round(float(values[0]), 1), round(float(values[1]), 1), round(float(values[2]), 1))


def postures(task: Task, scene: Scene, setup: Setup) -> list[Posture]:
    """Return what the hand must hold: the start, and every station's docking and act."""
    bodies = {n: scene.body_pose(n, p) for n, p in setup.places.items() if n in scene.bodies}
    bodies = {n: pose for n, pose in bodies.items() if scene.bodies[n].shape != "sphere"}
    frames = {name: scene.hand_pose(name, place) for name, place in setup.places.items()}
    none = np.zeros(7)
    found = [Posture(setup.robot_start.pose, GRIPPER.open_m, "", none, bodies)]
    held, in_hand = "", none
    stations = task.learned.stations if task.learned else ()
    if not stations:
        return found + [Posture(hand, 0.0, "", none, {}) for hand in frames.values()]
    for station in stations:
        hands = _hands(task, station, frames, held)
        opening = _width(scene, held) if held else _opening(task, station)
        near: tuple[str, ...] = (station.object, station.frame)
        standing = dict(bodies)
        if station.kind == "touch":
            # What is pushed goes along, and what wipes lies on what it wipes.
            standing.pop(station.object, None)
            near = (*near, *(table.name for table in scene.tables))
        for k, pose in enumerate(hands):
            found.append(Posture(pose, opening, held, in_hand, standing, near, k > 0))
        if station.kind != "touch":
            held, in_hand = _acted(station, hands[-1], bodies, frames, in_hand)
        elif not held and station.object != station.frame:
            bodies.pop(station.object, None)
    return found


def _hands(task: Task, station: Station, frames: dict[str, Array], held: str) -> Array:
    """Return flange poses, shape (m, 7), from docking to grasp or release, or of all of a touch."""
    path = task.learned.path if task.learned else None
    frame = frames[station.frame]
    hand = compose(frame, station.hand_in_frame)
    if station.kind == "touch" and not held and task.learned is not None:
        # A push leads from the body to where it is pushed.
        touched = (s for s in task.learned.stations if s.frame == station.object)
        begin = next((compose(frames[s.frame], s.hand_in_frame) for s in touched), hand)
        return interpolate(begin, hand, np.linspace(0.0, 1.0, ALONG))
    if station.kind == "touch" and path is not None:
        shown = path.path[station.docking_at : station.at + 1 : EVERY]
        return compose(compose(frame, inverse(station.frame_to_world)), shown)
    docking = compose(frame, station.docking_in_frame)
    return interpolate(docking, hand, np.linspace(0.0, 1.0, BETWEEN))


def _opening(task: Task, station: Station) -> float:
    path = task.learned.path if task.learned else None
    if station.kind != "touch" or path is None or path.gripper_m is None:
        return GRIPPER.open_m
    return float(path.gripper_m[station.at])


def _width(scene: Scene, name: str) -> float:
    return float(min(scene.bodies[name].size_mm[1] / 1000.0, GRIPPER.open_m))


def _acted(
    station: Station, hand: Array, bodies: dict[str, Array], frames: dict[str, Array], held: Array
) -> tuple[str, Array]:
    if station.kind == "grasp" and station.object in bodies:
        return station.object, compose(inverse(hand), bodies[station.object])
    if station.kind == "release" and station.object in bodies:
        bodies[station.object] = compose(hand, held)
        frames[station.object] = hand
    return "", held
