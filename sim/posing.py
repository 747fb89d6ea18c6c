"""A comfortable posture for a driven hand: over the table, pointing straight down, unwound.

Who is asked for it goes there by joints: from a wound-up wrist no way of the hand leads out.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from assistant.geometry import (
    Array,
    compose,
    inverse,
    quat_from_rotvec,
    quat_multiply,
    rotate_vector,
)
from assistant.model.motion import Refusal
from assistant.model.scene import Scene
from assistant.ports import ArmLook
from sim import a465
from sim.driving import TIP
from sim.jogging import Jog, Jogger
from sim.kinematics import forward, inverse_all, limit_margin
from sim.tracking import AHEAD, PATH
from sim.world import CONTROL_S

ABOVE_M = 0.15
"""The fingers come to rest at least so far above the table."""
LIFTS_M = (0.0, 0.08, -0.1, -0.2, 0.16)
SHARES = (1.0, 0.9, 0.8, 0.7, 0.6, 0.5)
"""How much nearer to the base the hand may come where it is out of reach."""
NEAREST_M = 0.25
ROOM_RAD = math.radians(8.0)
HASTE = 0.25
"""Share of the joints' speed that is used at most."""
DOWN = quat_from_rotvec(np.array([0.0, math.pi / 2, 0.0]))
DOWNWARD = 0.9
"""A hand that points down so much keeps the way it is turned."""


def posed(jogger: Jogger, scene: Scene, look: ArmLook, most_m_s: float) -> Jog | Refusal:
    """Return a checked motion to a comfortable posture above where the hand is, or why not.

    Parameters
    ----------
    jogger : Jogger
    scene : Scene
    look : ArmLook
    most_m_s : float
        Of the hand.
    """
    refusal: Refusal = Refusal("reach", PATH)
    for goal in _postures(scene, look):
        found = jogger.along(_eased(look.q, goal, most_m_s))
        if isinstance(found, Jog):
            return found
        refusal = found
    return refusal


def _postures(scene: Scene, look: ArmLook) -> Iterator[Array]:
    """Yield joints of comfortable postures, the nearest first."""
    tip = compose(look.hand, TIP)
    tops = [one.xyz_mm[2] + one.size_mm[2] for one in scene.tables]
    low = max(tops, default=0.0) / 1000.0 + ABOVE_M
    turn = _downward(tip, held=bool(look.held))
    for share in SHARES:
        for lift in LIFTS_M:
            place = np.array([*(share * tip[:2]), max(float(tip[2]) + lift, low)])
            if float(np.hypot(*place[:2])) < NEAREST_M:
                place[:2] = _outward(place[:2])
            hand = compose(np.concatenate([place, turn]), inverse(TIP))
            # The wrist either way round, that with more room first.
            either = inverse_all(hand[None])[0, :2]
            fine = [q for q in either if np.isfinite(q).all() and limit_margin(q) > ROOM_RAD]
            yield from sorted(fine, key=lambda q: -float(limit_margin(q)))


def _downward(tip: Array, *, held: bool) -> Array:
    """Return the turn of a hand that points down; what it holds is not leaned."""
    ahead = rotate_vector(tip[3:], AHEAD)
    if held and ahead[2] > -DOWNWARD:
        return tip[3:]
    if ahead[2] < -DOWNWARD:
        axis = np.cross(ahead, [0.0, 0.0, -1.0])
        size = float(np.linalg.norm(axis))
        angle = math.atan2(size, -float(ahead[2]))
        lean = axis / size * angle if size > 1e-9 else np.zeros(3)
        return quat_multiply(quat_from_rotvec(lean), tip[3:])
    return DOWN


def _outward(place: Array) -> Array:
    far = float(np.linalg.norm(place))
    way = place / far if far > 1e-3 else np.array([1.0, 0.0])
    return np.asarray(NEAREST_M * way)


def _eased(begin: Array, end: Array, most_m_s: float) -> Array:
    """Return joints, shape (n, 6), one a tick, from rest to rest."""
    way = np.abs(end - begin)
    # Of a smooth step the greatest speed is 1.5 times the mean.
    needed = float(np.max(1.5 * way / (HASTE * a465.SPEEDS)))
    trial = begin + np.linspace(0.0, 1.0, 50)[:, None] * (end - begin)
    hands = forward(trial)
    tips = compose(hands, np.tile(TIP, (50, 1)))
    far = max(_length(hands[:, :3]), _length(tips[:, :3]))
    count = max(math.ceil(max(needed, 1.6 * far / most_m_s) / CONTROL_S), 10)
    share = np.linspace(0.0, 1.0, count + 1)
    eased = share * share * (3.0 - 2.0 * share)
    return np.asarray(begin + eased[:, None] * (end - begin))


def _length(places: Array) -> float:
    return float(np.linalg.norm(np.diff(places, axis=0), axis=1).max()) * (len(places) - 1)
