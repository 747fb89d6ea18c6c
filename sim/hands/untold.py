"""Places for the things a teacher has not told of: who shows a task knows where they are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from assistant.model.scene import Scene
from assistant.model.setup import Place, Setup
from assistant.model.task import Task

RADIUS_MM = 700.0
AZIMUTHS_DEG = (20.0, -20.0, 45.0, -45.0, 0.0, 65.0, -65.0, 33.0, -33.0)
"""Where things are put, in this order: well within the arm's reach, left and right in turn,
turned as the hand reaches for them."""
JITTER_MM = 15.0
APART_MM = 130.0
"""Between the middles of things."""
EDGE_MM = 60.0
"""From the middle of a thing to the edge of the table it stands on."""


def filled(task: Task, scene: Scene, setup: Setup, seed: int) -> Setup:
    """Return a setup with places on a table for those of the task's things that have none.

    Parameters
    ----------
    task : Task
    scene : Scene
    setup : Setup
        What is placed in it stays there.
    seed : int
        The same seed gives the same places.
    """
    places = dict(setup.places)
    missing = [one.name for one in task.objects if one.name not in places]
    taken = [1000.0 * scene.body_pose(name, place)[:2] for name, place in places.items()]
    free = (
        (x, y)
        for x, y in _free(taken, np.random.default_rng(seed))
        if not scene.tables or _tops_mm(scene, x, y, EDGE_MM)
    )
    for name, (x, y) in zip(missing, free, strict=False):
        yaw = round(float(np.rad2deg(np.arctan2(y, x))), 1)
        top_mm = max(_tops_mm(scene, x, y), default=0.0)
        places[name] = Place("body", (x, y, top_mm), (0.0, 0.0, yaw))
    return replace(setup, places=places)


def _free(taken: list[np.ndarray], random: np.random.Generator) -> Iterator[tuple[float, float]]:
    for azimuth in np.deg2rad(AZIMUTHS_DEG):
        spot = RADIUS_MM * np.array([np.cos(azimuth), np.sin(azimuth)])
        spot = np.round(spot + random.uniform(-JITTER_MM, JITTER_MM, 2), 1)
        if all(float(np.linalg.norm(spot - other)) > APART_MM for other in taken):
            taken.append(spot)
            yield float(spot[0]), float(spot[1])


def _tops_mm(scene: Scene, x: float, y: float, edge_mm: float = 0.0) -> list[float]:
    """Return the heights of the tables under a spot that is so far from their edges."""
    return [
        table.xyz_mm[2] + table.size_mm[2]
        for table in scene.tables
        if abs(x - table.xyz_mm[0]) <= table.size_mm[0] / 2 - edge_mm
        and abs(y - table.xyz_mm[1]) <= table.size_mm[1] / 2 - edge_mm
    ]
