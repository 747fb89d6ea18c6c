"""Things met by a hand from above stand upright on the table and are held as they were shown."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.dialogue.bodies import fitted, standing, with_body
from assistant.dialogue.gripped import TIP_M, met
from assistant.dialogue.knowledge import Knowledge
from assistant.geometry import Array, pose_from_mm_deg, quat_to_rpy, transform_points
from assistant.model.scene import Obstacle, Scene
from assistant.model.setup import Setup
from assistant.model.task import TaskObject

TABLE = Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0))
THINGS = (TaskObject("jar", "object"), TaskObject("coaster", "target"))


def known(tall_mm: float = 60.0) -> Knowledge:
    bare = Knowledge(objects=THINGS, scene=Scene(tables=(TABLE,)), setup=Setup())
    return with_body(
        with_body(bare, "jar", "cylinder", (50.0, 50.0, tall_mm)), "coaster", "box", (90, 90, 5)
    )


def hand(tip_mm: tuple[float, float, float], pitch_deg: float, yaw_deg: float) -> Array:
    turn = pose_from_mm_deg((0, 0, 0), (0.0, pitch_deg, yaw_deg))
    back = transform_points(turn, np.array([-TIP_M, 0.0, 0.0]))
    return np.concatenate([np.array(tip_mm) / 1000.0 + back, turn[3:]])


@pytest.mark.parametrize("yaw_deg", [-140.0, 0.0, 35.0])
@pytest.mark.parametrize("pitch_deg", [30.0, 60.0, 90.0, 100.0])
def test_what_is_met_from_above_stands_upright_under_the_fingers(
    pitch_deg: float, yaw_deg: float
) -> None:
    shown = hand((450.0, 80.0, 275.0), pitch_deg, yaw_deg)
    after = met(known(), "jar", shown)
    place = after.setup.places["jar"]
    base = after.scene.body_pose("jar", place)
    assert base[:3] == pytest.approx([0.45, 0.08, 0.24], abs=1e-5)
    assert quat_to_rpy(base[3:])[:2] == pytest.approx([0.0, 0.0], abs=1e-6)
    assert np.rad2deg(quat_to_rpy(base[3:])[2]) == pytest.approx(yaw_deg, abs=1e-2)
    assert after.scene.hand_pose("jar", place) == pytest.approx(shown, abs=1e-5)


def test_what_is_put_down_from_above_lies_as_high_as_it_was_held() -> None:
    taken = met(known(), "jar", hand((450.0, 0.0, 280.0), 90.0, 0.0))
    # Let go 12 mm above the coaster: what is put there rests on it all the same.
    after = met(taken, "coaster", hand((450.0, 200.0, 297.0), 90.0, 20.0))
    base = after.scene.body_pose("coaster", after.setup.places["coaster"])
    assert base[:3] == pytest.approx([0.45, 0.2, 0.24], abs=1e-5)
    let_go = after.scene.hand_pose("coaster", after.setup.places["coaster"])
    assert let_go[2] - TIP_M == pytest.approx(0.245 + 0.040, abs=1e-5)


@pytest.mark.parametrize(("tip_mm", "held_mm"), [(262.0, 22.0), (305.0, 55.0), (311.0, 55.0)])
def test_fingers_that_closed_a_little_above_a_thing_are_led_lower(
    tip_mm: float, held_mm: float
) -> None:
    low = met(known(24.0), "jar", hand((450.0, 0.0, 265.0), 90.0, 0.0))
    assert low.scene.bodies["jar"].grasp_xyz_mm[2] == pytest.approx(25.0 + 1000.0 * TIP_M)
    after = met(known(), "jar", hand((450.0, 0.0, tip_mm), 90.0, 0.0))
    assert after.setup.places["jar"].xyz_mm[2] == pytest.approx(240.0)
    assert after.scene.bodies["jar"].grasp_xyz_mm[2] == pytest.approx(held_mm + 1000.0 * TIP_M)


def test_a_level_hand_meets_things_as_ever_and_how_it_was_shown_is_kept() -> None:
    level = hand((450.0, 0.0, 290.0), 5.0, 0.0)
    assert met(known(), "jar", level).setup.places["jar"] == standing(known(), "jar", level)
    after = met(known(), "jar", hand((450.0, 0.0, 275.0), 90.0, 0.0))
    again = fitted(replace(after, objects=THINGS))
    assert again.scene.bodies["jar"].hand_in_body == pytest.approx(
        after.scene.bodies["jar"].hand_in_body
    )
