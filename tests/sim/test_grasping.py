"""A scripted hand takes from above what the arm cannot reach from the side."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.geometry import compose, rotate_vector
from assistant.model.scene import Body, Scene
from assistant.model.setup import Place, Setup
from sim.hands.grasping import TIP, within_reach
from sim.kinematics import inverse_all, within_limits

BODIES = {
    "cup": Body("cup", "cup", (60.0, 60.0, 60.0), grasp_xyz_mm=(-134.1, 0.0, 50.0)),
    "saucer": Body(
        "saucer", "cylinder", (140.0, 140.0, 15.0), 0.0, grasp_xyz_mm=(-134.1, 0.0, 65.0)
    ),
}
SCENE = Scene(bodies=BODIES)


def stood(x_mm: float) -> Setup:
    return Setup("told", places={name: Place("body", (x_mm, y, 240.0)) for name, y in SIDES})


SIDES = (("cup", 150.0), ("saucer", -150.0))


def reached(scene: Scene, setup: Setup) -> bool:
    poses = np.array([scene.hand_pose(name, place) for name, place in setup.places.items()])
    return bool(within_limits(inverse_all(poses)).any(axis=-1).all())


def test_near_the_base_things_are_taken_from_above_at_the_same_point() -> None:
    setup = stood(450.0)
    assert not reached(SCENE, setup)
    above = within_reach(SCENE, setup)
    assert reached(above, setup)
    for name, body in above.bodies.items():
        ahead = rotate_vector(body.hand_in_body[3:], np.array([1.0, 0.0, 0.0]))
        assert ahead == pytest.approx([0.0, 0.0, -1.0], abs=1e-9)
        tips = [compose(one.hand_in_body, TIP)[:3] for one in (body, BODIES[name])]
        assert tips[0] == pytest.approx(tips[1], abs=1e-6)


def test_what_is_reached_as_told_or_not_at_all_stays_as_it_is() -> None:
    assert within_reach(SCENE, stood(650.0)) == SCENE
    assert within_reach(SCENE, stood(2000.0)) == SCENE


def test_places_told_by_the_hand_are_kept() -> None:
    setup = stood(450.0)
    by_hand = replace(setup.places["cup"], kind="hand")
    told = replace(setup, places={**setup.places, "cup": by_hand})
    assert within_reach(SCENE, told) == SCENE
