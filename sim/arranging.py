"""Draws where the things of a task stand: on tables, apart, and so that the task makes sense.

What is pushed stands before its line about as it was shown, and what is poured lies in the cup
that is carried; everything else may stand anywhere on the ring the arm reaches.
"""

from __future__ import annotations

import math

import numpy as np

from assistant.geometry import Array, compose, inverse, pose_from_mm_deg, relative
from assistant.model.lesson import Station
from assistant.model.scene import Body, Obstacle, Scene
from assistant.model.setup import Place, Triple
from assistant.model.task import Task

NEAR_M, FAR_M = 0.38, 0.85
"""Where bodies are put, by their distance from the base's axis."""
YAW_DEG = 60.0
"""How far a body's approach is turned from the ray that leads to it."""
APART_M = 0.13
"""Between the middles of bodies, or more where they are large."""
ROOM_M = 0.02
PUSH_SHARE, PUSH_ASIDE_M, PUSH_YAW_DEG = 0.2, 0.015, 6.0
"""How much longer or shorter, beside and turned a push may be than the one shown."""
IN_CUP_M = 0.006
"""Height of a ball over the base of the cup it lies in: the cup's floor, and a little."""
BESIDE_BALL_M = 0.001


def arranged(
    task: Task, scene: Scene, random: np.random.Generator, half_deg: float
) -> dict[str, Place] | None:
    """Return a place for everything a task needs, or None where the draw does not do.

    Parameters
    ----------
    task : Task
        Learned, or only its tree.
    scene : Scene
    random : numpy.random.Generator
    half_deg : float
        Azimuths lie within this to both sides of straight ahead.
    """
    ahead = pushed_ahead(task, scene)
    spots: dict[str, Array] = {}
    places: dict[str, Place] = {}
    for name in concerned(task):
        pushed, shown = ahead.get(name, ("", np.zeros(3)))
        if pushed in spots:
            spot = _before(spots[pushed], shown, random)
        else:
            spot = _spot(random, half_deg)
            if not _apart(scene, name, spot, spots):
                return None
        table = _table_under(scene, spot)
        if table is None:
            return None
        spots[name] = spot
        places[name] = _place(scene, name, spot, table)
    return {**places, **contained(task, scene, places)}


def concerned(task: Task) -> tuple[str, ...]:
    """Return the things a task tells of, and those only its lesson came upon."""
    stations = task.learned.stations if task.learned else ()
    met = (name for one in stations for name in (one.object, one.frame) if name)
    return tuple(dict.fromkeys((*(one.name for one in task.objects), *met)))


def pushed_ahead(task: Task, scene: Scene) -> dict[str, tuple[str, Array]]:
    """Return for each place something is pushed to what that is and how it lay before it.

    The latter is x, y in m and yaw in deg of the place, seen from the body, shape (3,).
    """
    found: dict[str, tuple[str, Array]] = {}
    stations = task.learned.stations if task.learned else ()
    stood: dict[str, Array] = {}
    for one in stations:
        if one.kind == "touch" and one.object == one.frame:
            stood[one.object] = _base(scene, one)
        elif one.kind == "touch" and one.object in stood:
            seen = relative(stood[one.object], _base(scene, one))
            yaw_deg = math.degrees(2.0 * math.atan2(float(seen[5]), float(seen[6])))
            found[one.frame] = one.object, np.array([seen[0], seen[1], yaw_deg])
    return found


def _base(scene: Scene, station: Station) -> Array:
    body = scene.bodies.get(station.frame)
    pose = station.frame_to_world
    return compose(pose, inverse(body.hand_in_body)) if body else pose


def contained(task: Task, scene: Scene, places: dict[str, Place]) -> dict[str, Place]:
    """Return places in the cup that is carried for the balls of a scene no one tells of."""
    stations = task.learned.stations if task.learned else ()
    grasped = [one.object for one in stations if one.kind == "grasp"]
    cups = [name for name in grasped if name in places and scene.bodies[name].shape == "cup"]
    loose = [b for b in scene.bodies.values() if b.shape == "sphere" and b.name not in places]
    if not cups or not loose:
        return {}
    cup = scene.bodies[cups[0]]
    at = scene.body_pose(cup.name, places[cup.name])
    inside = zip(loose, _rings(cup, loose), strict=True)
    return {ball.name: _ball_place(compose(at, spot)) for ball, spot in inside}


def _ball_place(pose: Array) -> Place:
    x, y, z = (round(1000.0 * float(value), 1) for value in pose[:3])
    return Place("body", (x, y, z))


def _rings(cup: Body, balls: list[Body]) -> list[Array]:
    """Return places of balls in a cup's frame, shape (7,): rings, one above the other."""
    width = max(ball.size_mm[0] for ball in balls) / 1000.0 + BESIDE_BALL_M
    radius = max(cup.size_mm[0] / 4000.0, width / 2.0)
    many = max(int(2.0 * math.pi * radius / width), 1)
    found = []
    for k in range(len(balls)):
        angle = 2.0 * math.pi * (k % many) / min(many, len(balls))
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        found.append(np.array([x, y, IN_CUP_M + width * (k // many), 0.0, 0.0, 0.0, 1.0]))
    return found


def _spot(random: np.random.Generator, half_deg: float) -> Array:
    """Return x, y in m and yaw in deg; evenly over the ring's area."""
    radius = np.sqrt(random.uniform(NEAR_M**2, FAR_M**2))
    azimuth = random.uniform(-half_deg, half_deg)
    x, y = radius * np.cos(np.deg2rad(azimuth)), radius * np.sin(np.deg2rad(azimuth))
    return np.array([x, y, azimuth + random.uniform(-YAW_DEG, YAW_DEG)])


def _before(spot: Array, shown: Array, random: np.random.Generator) -> Array:
    """Return where the line is that a body at a spot is to be pushed to."""
    far, aside = shown[:2] * random.uniform(1.0 - PUSH_SHARE, 1.0 + PUSH_SHARE)
    aside += random.uniform(-PUSH_ASIDE_M, PUSH_ASIDE_M)
    turn = np.deg2rad(spot[2])
    x = spot[0] + np.cos(turn) * far - np.sin(turn) * aside
    y = spot[1] + np.sin(turn) * far + np.cos(turn) * aside
    return np.array([x, y, spot[2] + shown[2] + random.uniform(-PUSH_YAW_DEG, PUSH_YAW_DEG)])


def _apart(scene: Scene, name: str, spot: Array, spots: dict[str, Array]) -> bool:
    def wide_m(thing: str) -> float:
        body = scene.bodies.get(thing)
        return math.hypot(*body.size_mm[:2]) / 2000.0 if body else 0.0

    return all(
        np.hypot(*(spot[:2] - seen[:2])) >= max(APART_M, wide_m(name) + wide_m(other) + ROOM_M)
        for other, seen in spots.items()
    )


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
