"""What the hand holds when the arm is halted, and how high above what is below it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from assistant.geometry import Array
from assistant.model.motion import ArmReport
from assistant.model.scene import Scene
from assistant.ports import ArmLook


def with_held(reports: Sequence[ArmReport], look: ArmLook, scene: Scene) -> tuple[ArmReport, ...]:
    """Return the reports of a tick that ended a motion, with what is held told at the end.

    The dialogue needs it to ask before it opens the hand (design, safety). An unmet condition
    tells of its own body; what the hand holds then follows as a report of the halt.
    """
    *before, last = reports
    if last.kind == "unmet":
        before.append(last)
        last = ArmReport("halted", last.at_s, last.primitive_at, last.kind)
    if look.held:
        last = replace(last, object=look.held, height_mm=height_mm(look, scene))
    return (*before, last)


def height_mm(look: ArmLook, scene: Scene) -> float | None:
    """Return how far the base of the held body is above a table or body, in mm.

    None where nothing is known to be below it.
    """
    pose = look.bodies.get(look.held)
    if pose is None:
        return None
    base_mm = 1000.0 * float(pose[2])
    tops = [table.xyz_mm[2] + table.size_mm[2] for table in scene.tables]
    tops += [
        1000.0 * float(other[2]) + scene.bodies[name].size_mm[2]
        for name, other in look.bodies.items()
        if name != look.held and name in scene.bodies and _below(name, other, pose, scene)
    ]
    under = [top for top in tops if top <= base_mm + 1.0]
    return max(0.0, base_mm - max(under)) if under else None


def _below(name: str, other: Array, pose: Array, scene: Scene) -> bool:
    """Whether another body lies so near that the held one would fall on it."""
    reach_mm = max(scene.bodies[name].size_mm[:2]) / 2.0
    away = (float(pose[0]) - float(other[0]), float(pose[1]) - float(other[1]))
    return 1000.0 * max(abs(away[0]), abs(away[1])) <= reach_mm
