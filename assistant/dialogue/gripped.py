"""A thing that was met by a hand that leans down: it stands upright all the same.

Told sizes say how a thing is held by a hand that comes level. Where a teacher shows it taken from
above, that is how it is held from then on, and it stands on the table under the fingers.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assistant.dialogue.bodies import LET_GO_MM, MET_MM, standing
from assistant.dialogue.knowledge import Knowledge
from assistant.geometry import (
    Array,
    compose,
    inverse,
    pose_from_mm_deg,
    pose_to_mm_deg,
    rotate_vector,
)
from assistant.model.scene import Body
from assistant.model.setup import Place

LEANS = 0.35
"""A hand whose approach goes down by this share comes from above."""
TIP_M = 0.1341
"""Of the point between the fingers from the flange."""
EDGE_MM = 5.0
"""The fingers hold a thing at least this far below its top."""
LOWEST_MM, BARELY_MM = 25.0, 3.0
"""Lower than this over a table their tips meet it; a low thing they hold by its upper edge."""


def met(known: Knowledge, thing: str, hand: Array) -> Knowledge:
    """Return what is known once a hand closed on a thing, or opened at it, that had no place.

    Parameters
    ----------
    known : Knowledge
    thing : str
    hand : array, shape (7,)
        The flange then.
    """
    ahead = rotate_vector(hand[3:], np.array([1.0, 0.0, 0.0]))
    places = dict(known.setup.places)
    scene = known.scene
    if thing in known.shaped and ahead[2] < -LEANS:
        body, place = _from_above(known, scene.bodies[thing], hand, ahead)
        places[thing] = place
        scene = replace(scene, bodies={**scene.bodies, thing: body})
    else:
        places[thing] = standing(known, thing, hand)
    return replace(known, scene=scene, setup=replace(known.setup, places=places))


def _from_above(known: Knowledge, body: Body, hand: Array, ahead: Array) -> tuple[Body, Place]:
    """Return a thing as it is held, and where its base stands."""
    x, y, tip_mm = (1000.0 * (hand[:3] + TIP_M * ahead)).tolist()
    high_mm = _held_mm(known, body, tip_mm)
    base_mm = _on_table(known, body, tip_mm - high_mm)
    up = ahead + rotate_vector(hand[3:], np.array([0.0, 0.0, 1.0]))
    yaw = float(np.degrees(np.arctan2(up[1], up[0])))
    place = Place("body", (round(x, 3), round(y, 3), round(base_mm, 3)), (0.0, 0.0, round(yaw, 3)))
    # Where the fingers were higher or lower than a thing there can be held, so is the hand.
    moved = np.array(hand)
    moved[2] += (base_mm + high_mm - tip_mm) / 1000.0
    seen = compose(inverse(pose_from_mm_deg(place.xyz_mm, place.rpy_deg)), moved)
    grasp, turn = ([round(float(one), 3) for one in part] for part in pose_to_mm_deg(seen))
    held = replace(
        body,
        grasp_xyz_mm=(grasp[0], grasp[1], grasp[2]),
        grasp_rpy_deg=(turn[0], turn[1], turn[2]),
    )
    return held, place


def _held_mm(known: Knowledge, body: Body, tip_mm: float) -> float:
    """Return how high above a thing's base the fingers are when they hold it, or let go over it."""
    objects = [one.name for one in known.objects or () if one.role == "object"]
    tall_mm = body.size_mm[2]
    if body.name in objects:
        over = [tip_mm - top for top in _tops(known)]
        near = [one for one in over if MET_MM[0] <= one <= tall_mm + MET_MM[1]]
        most = max(tall_mm - EDGE_MM, min(LOWEST_MM, tall_mm + BARELY_MM))
        return min(min(near, default=tall_mm / 2.0), most)
    carried = [known.scene.bodies[name] for name in objects if name in known.scene.bodies]
    if not carried:
        return tall_mm
    tip = compose(carried[0].hand_in_body, np.array([TIP_M, 0, 0, 0, 0, 0, 1.0]))
    return tall_mm + 1000.0 * float(tip[2])


def _on_table(known: Knowledge, body: Body, base_mm: float) -> float:
    targets = [one.name for one in known.objects or () if one.role == "target"]
    low, high = LET_GO_MM if body.name in targets else MET_MM
    near = [top for top in _tops(known) if low <= base_mm - top <= high]
    return min(near, key=lambda top: abs(base_mm - top)) if near else base_mm


def _tops(known: Knowledge) -> list[float]:
    return [table.xyz_mm[2] + table.size_mm[2] for table in known.scene.tables]
