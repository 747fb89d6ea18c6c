"""What a body can stand on, and how far it has to be put higher to stand there."""

from __future__ import annotations

from assistant.model.scene import Obstacle, Scene
from assistant.model.setup import Place, Setup

TOUCHING_MM = 2.0
"""A body told so little above a surface stands on it: people measure to the millimetre."""


def lifts_mm(scene: Scene, setup: Setup, name: str) -> list[float]:
    """Return by how much a body would have to be put higher to stand on something, ascending.

    Parameters
    ----------
    scene : Scene
    setup : Setup
    name : str
        Of the body; one without a place or a shape stands on nothing.
    """
    place = setup.places.get(name)
    if place is None or name not in scene.bodies:
        return []
    base_mm = _base_mm(scene, name, place)
    above = {top - base_mm[2] for top in _tops_mm(scene, setup, name, base_mm)}
    return sorted(lift for lift in above if lift > 0.5)


def stands(scene: Scene, setup: Setup, name: str) -> bool:
    """Return whether a body stands on something that is known to be there."""
    place = setup.places.get(name)
    if place is None or name not in scene.bodies:
        return False
    base_mm = _base_mm(scene, name, place)
    tops = _tops_mm(scene, setup, name, base_mm)
    return any(abs(base_mm[2] - top) <= TOUCHING_MM for top in tops)


def _base_mm(scene: Scene, name: str, place: Place) -> tuple[float, float, float]:
    x, y, z = (1000.0 * scene.body_pose(name, place)[:3]).tolist()
    return x, y, z


def _tops_mm(
    scene: Scene, setup: Setup, name: str, base_mm: tuple[float, float, float]
) -> list[float]:
    """Return the heights of all surfaces over or under the middle of a body's base."""
    x, y, _ = base_mm
    boxes = [one for one in (*scene.tables, *scene.obstacles) if not any(one.rpy_deg)]
    for other, place in setup.places.items():
        if other != name and other in scene.bodies:
            size_mm = scene.bodies[other].size_mm
            boxes.append(Obstacle(other, size_mm, _base_mm(scene, other, place)))
    return [
        one.xyz_mm[2] + one.size_mm[2]
        for one in boxes
        if one.size_mm[2] > 0.0
        and abs(x - one.xyz_mm[0]) <= one.size_mm[0] / 2.0
        and abs(y - one.xyz_mm[1]) <= one.size_mm[1] / 2.0
    ]
