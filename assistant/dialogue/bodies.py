"""Bodies whose shape and size the teacher tells: how they are held, and how high they stand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.turn import line
from assistant.geometry import Array, pose_to_mm_deg
from assistant.model.robot_acts import RobotAct
from assistant.model.scene import Body
from assistant.model.setup import Place

ASSUMED_MM = (60.0, 40.0, 100.0)
"""Size of a thing whose size the teacher does not know: the shipped block's."""
AHEAD_MM = -134.1
"""Of the flange from what the fingers hold."""
HELD_AT = 0.6
"""Share of its height at which a body is held, as the shipped block is."""
HELD_MM = 60.0
"""Height at which a body is held that nobody has told of."""
CLEAR_MM, EDGE_MM = 54.0, 10.0
"""The palm clears a table from this height on; fingers stay this far below a body's top."""
MASS_KG = 0.2
MET_MM, LET_GO_MM = (-15.0, 15.0), (-30.0, 60.0)
"""How far from a table's top a thing that stands on it may seem to be: where the hand closed on
it, and, of a place for things, where it opened; most open it well above."""
WIDEST_MM = 75.0
"""The fingers open 80 mm; what is wider than this they cannot be put around."""


def with_body(known: Knowledge, thing: str, shape: str, size_mm: tuple[float, ...]) -> Knowledge:
    """Return what is known after a thing has got a shape and size."""
    shapes: Mapping[str, Body] = {
        "box": Body(thing),
        "cylinder": Body(thing, "cylinder"),
        "sphere": Body(thing, "sphere"),
        "cup": Body(thing, "cup"),
    }
    x, y, z = (float(length) for length in size_mm)
    scene = known.scene
    bodies = {**scene.bodies, thing: replace(shapes[shape], size_mm=(x, y, z))}
    shaped = tuple(dict.fromkeys((*known.shaped, thing)))
    return fitted(replace(known, scene=replace(scene, bodies=bodies), shaped=shaped))


def fitted(known: Knowledge) -> Knowledge:
    """Return what is known with told bodies held and weighed as their roles have it.

    What is carried is held at a share of its height. A target is fixed, and the hand is over it
    as high as it holds what it puts there.
    """
    roles = {one.name: one.role for one in known.objects or ()}
    bodies = dict(known.scene.bodies)
    carried = [name for name, role in roles.items() if role == "object" and name in bodies]
    for name in (name for name in known.shaped if roles.get(name) != "target"):
        bodies[name] = _held(bodies[name], _height_mm(bodies[name].size_mm[2]), MASS_KG)
    over = bodies[carried[0]].grasp_xyz_mm[2] if carried else HELD_MM
    for name in (name for name in known.shaped if roles.get(name) == "target"):
        bodies[name] = _held(bodies[name], bodies[name].size_mm[2] + over, 0.0)
    if bodies == known.scene.bodies:
        return known
    return replace(known, scene=replace(known.scene, bodies=bodies))


def standing(known: Knowledge, thing: str, hand: Array) -> Place:
    """Return where a thing is that the hand met: on the table, if it is near it there.

    Nobody closes or opens a hand just as high as a thing stands, and a thing that is a little
    in the table, or over it, could be neither grasped nor met again.

    Parameters
    ----------
    known : Knowledge
    thing : str
    hand : array, shape (7,)
        The flange, when it closed on the thing or opened at it.
    """
    xyz, rpy = pose_to_mm_deg(hand)
    x, y, z = (round(float(value), 3) for value in xyz)
    roll, pitch, yaw = (round(float(value), 3) for value in rpy)
    place = Place("hand", (x, y, z), (roll, pitch, yaw))
    if thing not in known.shaped:
        return place
    base_mm = 1000.0 * float(known.scene.body_pose(thing, place)[2])
    targets = [one.name for one in known.objects or () if one.role == "target"]
    low, high = LET_GO_MM if thing in targets else MET_MM
    tops = [table.xyz_mm[2] + table.size_mm[2] for table in known.scene.tables]
    near = [top for top in tops if low <= base_mm - top <= high]
    if not near:
        return place
    lower_mm = min((base_mm - top for top in near), key=abs)
    return replace(place, xyz_mm=(x, y, round(z - lower_mm, 3)))


def plain_size(known: Knowledge, thing: str) -> dict[str, object]:
    """Return what shape and size, in cm, a thing is taken to have."""
    body = known.scene.bodies[thing]
    x, y, z = (round(side / 10.0, 1) for side in body.size_mm)
    return {"name": thing, "shape": body.shape, "x": x, "y": y, "z": z}


def size_line(known: Knowledge, thing: str) -> RobotAct:
    """Return the line that tells how big a thing is taken to be."""
    return line("told", "size", size=plain_size(known, thing))


def too_wide(known: Knowledge) -> str:
    """Return what is to be carried though the fingers cannot be put around it; empty if all can.

    However it is turned, they cannot.
    """
    carried = (one.name for one in known.objects or () if one.role == "object")
    told = {name: known.scene.bodies[name].size_mm for name in carried if name in known.shaped}
    return next((name for name, size_mm in told.items() if min(size_mm[:2]) > WIDEST_MM), "")


def _height_mm(tall_mm: float) -> float:
    """Return how high a body is held: at its share, or higher where the palm needs room."""
    if not tall_mm:
        return HELD_MM
    share_mm = HELD_AT * tall_mm
    return max(share_mm, min(CLEAR_MM, tall_mm - EDGE_MM))


def _held(body: Body, height_mm: float, mass_kg: float) -> Body:
    if any(body.grasp_rpy_deg):
        # It was shown how it is taken from above.
        return replace(body, mass_kg=mass_kg)
    return replace(body, grasp_xyz_mm=(AHEAD_MM, 0.0, height_mm), mass_kg=mass_kg)
