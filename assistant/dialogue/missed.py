"""A hand that closed where the thing cannot be: told at once, for practice could only fail."""

from __future__ import annotations

import numpy as np

from assistant.dialogue.bodies import AHEAD_MM, ASSUMED_MM
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.turn import line
from assistant.geometry import compose, inverse, pose_from_mm_deg
from assistant.model.lesson import Lesson, Station
from assistant.model.robot_acts import RobotAct

MISSED_MM = 12.0
"""Fingers that closed so far above a thing's top, or beside it, held nothing of it."""
TIP = pose_from_mm_deg((-AHEAD_MM, 0.0, 0.0), (0.0, 0.0, 0.0))
"""The point between the fingers, seen from the flange."""


def missed(known: Knowledge, lesson: Lesson) -> RobotAct | None:
    """Return the line that tells which thing was not between the fingers; None if all were.

    Only things of which the teacher told the size are looked at, each where it was first grasped.
    """
    first: dict[str, Station] = {}
    for station in lesson.stations:
        first.setdefault(station.object, station)
    for thing, station in first.items():
        if station.kind == "grasp" and thing in known.shaped and not _assumed(known, thing):
            above_mm, beside_mm = _off_mm(known, station)
            if above_mm > MISSED_MM:
                return line("error", "missed_above", thing=thing, mm=round(above_mm))
            if beside_mm > MISSED_MM:
                return line("error", "missed_beside", thing=thing, mm=round(beside_mm))
    return None


def _assumed(known: Knowledge, thing: str) -> bool:
    """Whether nobody knew how big a thing is."""
    return known.scene.bodies[thing].size_mm == ASSUMED_MM


def _off_mm(known: Knowledge, station: Station) -> tuple[float, float]:
    """Return how far above a thing's top, and beside it, the fingers closed; 0 for within."""
    scene, body = known.scene, known.scene.bodies[station.object]
    tip = compose(compose(station.frame_to_world, station.hand_in_frame), TIP)
    place = known.demonstrations[-1].setup.places.get(station.object)
    if place is None:
        # Where nobody told its place it stood below the fingers, on a table or another thing.
        table = _below_mm(known, 1000.0 * tip[:3], station.object)
        above = 0.0 if table is None else 1000.0 * float(tip[2]) - table - body.size_mm[2]
        return max(above, 0.0), 0.0
    seen = 1000.0 * compose(inverse(scene.body_pose(station.object, place)), tip)[:3]
    outside = np.maximum(np.abs(seen[:2]) - np.asarray(body.size_mm[:2]) / 2.0, 0.0)
    return max(float(seen[2]) - body.size_mm[2], 0.0), float(np.linalg.norm(outside))


def _below_mm(known: Knowledge, at_mm: np.ndarray, thing: str) -> float | None:
    """Return the height of what a thing can stand on below a point; None where nothing is."""
    scene = known.scene
    tops = [
        table.xyz_mm[2] + table.size_mm[2]
        for table in scene.tables
        if np.all(np.abs(at_mm[:2] - np.array(table.xyz_mm[:2])) <= np.array(table.size_mm[:2]) / 2)
    ]
    for name, place in known.demonstrations[-1].setup.places.items():
        if name != thing and name in scene.bodies:
            base = 1000.0 * scene.body_pose(name, place)[:3]
            size = scene.bodies[name].size_mm
            if np.linalg.norm(at_mm[:2] - base[:2]) <= max(size[:2]) / 2.0:
                tops.append(float(base[2]) + size[2])
    return max((top for top in tops if top < at_mm[2]), default=None)
