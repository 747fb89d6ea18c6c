"""Random setups over the whole annulus the arm can reach, for practice and evaluation.

Places of objects and targets, their turn and the robot start are drawn; what overlaps, or what
a plain check (`sim.feasibility`) says cannot be reached, is drawn again.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import count
from typing import Literal

import numpy as np

from assistant.errors import WorkFailed
from assistant.geometry import Array, compose, interpolate, inverse, pose_from_mm_deg
from assistant.model.lesson import Station
from assistant.model.scene import Obstacle, Scene
from assistant.model.setup import READY, Place, Setup, Triple
from assistant.model.task import Task
from sim.a465 import GRIPPER
from sim.feasibility import Posture, reachable

Sector = Literal["front", "all"]

FRONT_DEG, ALL_DEG = 70.0, 180.0
NEAR_M, FAR_M = 0.38, 0.85
"""Where bodies are put, by their distance from the base's axis."""
YAW_DEG = 60.0
"""How far a body's approach is turned from the ray that leads to it."""
APART_M = 0.13
"""Between the middles of bodies."""
TRIES = 4000
BETWEEN = 9
"""Postures looked at from docking to grasp or release."""


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
        start = _start(random, _half_deg(sector)) if random_start else READY
        setup = _drawn(task, scene, random, sector, start)
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


def new_setup(task: Task, scene: Scene, setup: Setup, seed: int) -> Setup | None:
    """Return a new reachable setup ahead of the robot, which starts where it did; else None."""
    random = np.random.default_rng(seed)
    for _ in range(TRIES):
        drawn = _drawn(task, scene, random, "front", setup.robot_start)
        if drawn is not None and reachable(postures(task, scene, drawn), scene):
            return replace(drawn, name=f"new_{seed}")
    return None


def _half_deg(sector: Sector) -> float:
    return FRONT_DEG if sector == "front" else ALL_DEG


def _drawn(
    task: Task,
    scene: Scene,
    random: np.random.Generator,
    sector: Sector,
    start: Place,
) -> Setup | None:
    half = _half_deg(sector)
    places: dict[str, Place] = {}
    spots: list[Array] = []
    for name in _concerned(task):
        spot = _spot(random, half)
        if any(np.hypot(*(spot[:2] - other[:2])) < APART_M for other in spots):
            return None
        table = _table_under(scene, spot)
        if table is None:
            return None
        spots.append(spot)
        places[name] = _place(scene, name, spot, table)
    return Setup("random", scene.name, start, places)


def _concerned(task: Task) -> tuple[str, ...]:
    """Return the things a task tells of, and those only its lesson came upon."""
    stations = task.learned.stations if task.learned else ()
    met = (name for one in stations for name in (one.object, one.frame) if name)
    return tuple(dict.fromkeys((*(one.name for one in task.objects), *met)))


def _spot(random: np.random.Generator, half_deg: float) -> Array:
    """Return x, y in m and yaw in deg; evenly over the ring's area."""
    radius = np.sqrt(random.uniform(NEAR_M**2, FAR_M**2))
    azimuth = random.uniform(-half_deg, half_deg)
    x, y = radius * np.cos(np.deg2rad(azimuth)), radius * np.sin(np.deg2rad(azimuth))
    return np.array([x, y, azimuth + random.uniform(-YAW_DEG, YAW_DEG)])


def _place(scene: Scene, name: str, spot: Array, table: Obstacle) -> Place:
    height = table.xyz_mm[2] + table.size_mm[2]
    xyz: Triple = (round(1000 * float(spot[0]), 1), round(1000 * float(spot[1]), 1), height)
    yaw = (round(float(spot[2]), 1) + 180.0) % 360.0 - 180.0
    if name in scene.bodies:
        return Place("body", xyz, (0.0, 0.0, yaw))
    return Place("hand", (xyz[0], xyz[1], height + 60.0), (0.0, 0.0, yaw))


def _table_under(scene: Scene, spot: Array) -> Obstacle | None:
    for table in scene.tables:
        pose = pose_from_mm_deg(table.xyz_mm, table.rpy_deg)
        local = compose(inverse(pose), np.array([spot[0], spot[1], 0.0, 0.0, 0.0, 0.0, 1.0]))
        if np.all(np.abs(local[:2]) < np.array(table.size_mm[:2]) / 2000.0 - 0.04):
            return table
    return None


def _start(random: np.random.Generator, half_deg: float) -> Place:
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
    frames = {name: scene.hand_pose(name, place) for name, place in setup.places.items()}
    none = np.zeros(7)
    found = [Posture(setup.robot_start.pose, GRIPPER.open_m, "", none, bodies)]
    held, in_hand = "", none
    stations = task.learned.stations if task.learned else ()
    if not stations:
        return found + [Posture(hand, 0.0, "", none, {}) for hand in frames.values()]
    for station in stations:
        frame = frames[station.frame]
        hand = compose(frame, station.hand_in_frame)
        near = (station.object, station.frame)
        opening = GRIPPER.open_m if not held else _width(scene, held)
        docking = compose(frame, station.docking_in_frame)
        for pose in interpolate(docking, hand, np.linspace(0.0, 1.0, BETWEEN)):
            found.append(Posture(pose, opening, held, in_hand, dict(bodies), near))
        held, in_hand = _acted(station, hand, bodies, frames, in_hand)
    return found


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
