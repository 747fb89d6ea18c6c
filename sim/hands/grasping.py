"""How a scripted hand takes things: as the scene says, or from above where the arm cannot."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from assistant.geometry import compose, pose_from_mm_deg, pose_to_mm_deg
from assistant.model.scene import Body, Scene
from assistant.model.setup import Setup, Triple
from sim.kinematics import inverse_all, within_limits

TIP = pose_from_mm_deg((134.1, 0.0, 0.0), (0.0, 0.0, 0.0))
"""The point between the fingers as seen from the flange."""
DOWN_DEG = ((0.0, 90.0, 0.0), (0.0, 90.0, 180.0))
"""A hand that points down, its fingers closing as they would from the side."""


def within_reach(scene: Scene, setup: Setup) -> Scene:
    """Return a scene in which everything is taken from above where the arm needs that.

    Near its base the arm reaches a table from above only. All is left as it is where the arm
    reaches it so, where that would not help, and where places were told by the hand.
    """
    placed = [name for name in scene.bodies if name in setup.places]
    if any(setup.places[name].kind == "hand" for name in placed):
        return scene
    for trial in (scene, *(_all_from_above(scene, placed, rpy_deg) for rpy_deg in DOWN_DEG)):
        poses = [trial.hand_pose(name, setup.places[name]) for name in placed]
        if not poses or within_limits(inverse_all(np.array(poses))).any(axis=-1).all():
            return trial
    return scene


def _all_from_above(scene: Scene, names: Sequence[str], rpy_deg: Triple) -> Scene:
    held = {name: _from_above(scene.bodies[name], rpy_deg) for name in names}
    return replace(scene, bodies={**scene.bodies, **held})


def _from_above(body: Body, rpy_deg: Triple) -> Body:
    """Return a body held at the same point by a hand that points down."""
    tip_mm, _ = pose_to_mm_deg(compose(body.hand_in_body, TIP))
    turned = pose_from_mm_deg((0.0, 0.0, 0.0), rpy_deg)
    back_mm, _ = pose_to_mm_deg(compose(turned, TIP))
    x, y, z = (round(float(one), 3) for one in tip_mm - back_mm)
    return replace(body, grasp_xyz_mm=(x, y, z), grasp_rpy_deg=rpy_deg)
