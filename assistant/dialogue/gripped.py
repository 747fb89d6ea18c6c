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
    base_mm, high_mm = _stands(known, body, tip_mm)
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


def _stands(known: Knowledge, body: Body, tip_mm: float) -> tuple[float, float]:
    """Return how high a thing's base stands, and how high above it the fingers hold it."""
    targets = [one.name for one in known.objects or () if one.role == "target"]
    tall_mm = body.size_mm[2]
    if body.name not in targets:
        near = [top for top in _tops(known) if MET_MM[0] <= tip_mm - top <= tall_mm + MET_MM[1]]
        most = max(tall_mm - EDGE_MM, min(LOWEST_MM, tall_mm + BARELY_MM))
        if not near:
            return tip_mm - tall_mm / 2.0, tall_mm / 2.0
        # A higher table is the one it stands on.
        return max(near), min(max(tip_mm - max(near), 0.0), most)
    high_mm = tall_mm + _over_mm(known)
    low, high = LET_GO_MM
    near = [top for top in _tops(known) if low <= tip_mm - high_mm - top <= high]
    return max(near, default=tip_mm - high_mm), high_mm


def _over_mm(known: Knowledge) -> float:
    """Return how high the fingers are over the base of what is carried."""
    objects = [one.name for one in known.objects or () if one.role == "object"]
    carried = [known.scene.bodies[name] for name in objects if name in known.scene.bodies]
    if not carried:
        return 0.0
    tip = compose(carried[0].hand_in_body, np.array([TIP_M, 0, 0, 0, 0, 0, 1.0]))
    return 1000.0 * float(tip[2])


def _tops(known: Knowledge) -> list[float]:
    return [table.xyz_mm[2] + table.size_mm[2] for table in known.scene.tables]
