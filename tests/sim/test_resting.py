"""What is carried rests only where it is taken up and put down."""

from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import IDENTITY, Array, inverse, transform_points
from assistant.model.motion import JointPath
from assistant.model.scene import Body, Obstacle, Scene
from assistant.model.setup import Place, Setup
from sim.collision import fixed_things
from sim.kinematics import forward
from sim.planner import A465Planner
from sim.resting import CLEARANCE_M, RISE, SLACK_M, Carried, Standing, carried_body
from tests.sim.hand_paths import TABLE1, pick_and_place, scene

TABLE_M = 0.24
AROUND = Setup(
    "around",
    "table",
    Place("hand", (-342.9, -296.6, 613.9), (10.8, -16.7, -107.5)),
    {
        "block": Place("body", (-551.6, 354.6, 240.0), (0.0, 0.0, -155.5)),
        "target": Place("body", (317.2, 640.7, 240.0), (0.0, 0.0, 49.3)),
    },
)


def heights(where: Scene, motion: JointPath) -> Array:
    """Return how high the block's lowest corner is above the table while it is carried."""
    grasp, release = motion.stops
    body = where.bodies["block"]
    size = np.array(body.size_mm) / 1000.0
    signs = np.array(np.meshgrid([-0.5, 0.5], [-0.5, 0.5], [0.0, 1.0])).reshape(3, -1).T
    corners = transform_points(inverse(body.hand_in_body), signs * size)
    hands = forward(motion.q[grasp.left_at + 1 : release.docking_at])
    lowest = [float(transform_points(hand, corners)[:, 2].min()) for hand in hands]
    return np.array(lowest) - TABLE_M


def test_a_block_led_around_the_base_stays_clear_of_the_table() -> None:
    where = scene()
    motion = A465Planner().plan(pick_and_place(where, AROUND), where, AROUND)
    assert isinstance(motion, JointPath), str(motion)
    assert heights(where, motion).min() > CLEARANCE_M - 1e-4


def test_a_block_is_taken_up_and_put_down_as_shown() -> None:
    where, told = scene(), TABLE1[1]
    motion = A465Planner().plan(pick_and_place(where, told), where, told)
    assert isinstance(motion, JointPath), str(motion)
    assert heights(where, motion).min() > 0.05


def standing_on(above_m: float) -> tuple[Carried, Standing]:
    """Return a block taken up so far above a table, and the table."""
    carried = carried_body(Scene(bodies={"block": Body("block")}), "block", np.array(IDENTITY))
    table = Obstacle("table", (900.0, 900.0, 20.0), (0.0, 0.0, -20.0 - 1000.0 * above_m))
    thing = next(t for t in fixed_things(Scene(tables=(table,))) if t.name == "table")
    assert carried is not None
    return carried.rested(np.array([IDENTITY]), (thing,)), thing


@pytest.mark.parametrize("above_m", [0.0, 0.002, 0.1])
def test_what_rested_rises_until_it_is_clear(above_m: float) -> None:
    carried, table = standing_on(above_m)
    here = carried.box(np.array([IDENTITY])).center
    away = np.linspace(0.0, 0.05, 26)
    keeps = carried.keeps(here + away[:, None] * np.array([1.0, 0.0, 0.0]), table)
    assert keeps[0] <= above_m
    assert keeps[-1] == CLEARANCE_M
    assert np.all(np.diff(keeps) <= RISE * (away[1] - away[0]) + 1e-12)
    assert np.all(np.diff(keeps) >= 0.0)


def test_where_it_is_put_down_it_may_touch_but_not_sink_in() -> None:
    carried, table = standing_on(0.1)
    far = np.full((2, 3), 1.0)
    keeps = carried.keeps(far, table, np.array([True, False]))
    np.testing.assert_allclose(keeps, [-SLACK_M, CLEARANCE_M])


def test_it_rests_on_nothing_that_bears_nothing() -> None:
    carried, _ = standing_on(0.0)
    post = Obstacle("post", (900.0, 900.0, 20.0), (0.0, 0.0, -20.0))
    thing = next(t for t in fixed_things(Scene(obstacles=(post,))) if t.name == "post")
    np.testing.assert_array_equal(
        carried.keeps(np.zeros((1, 3)), thing, np.array([True])), [CLEARANCE_M]
    )
