"""From grasp to release a body is carried; elsewhere it stands."""

from __future__ import annotations

import numpy as np

from assistant.geometry import compose, inverse
from assistant.model.scene import Body, Scene
from assistant.model.setup import Place, Setup
from assistant.ports import ArmLook
from sim import a465
from sim.fine_path import refine
from sim.kinematics import forward
from sim.phases import bodies_at, overlap, phases
from tests.sim.hand_paths import TABLE, TABLE1, pick_and_place, scene, setup


def test_the_block_stands_is_carried_and_stands_again() -> None:
    where, told = scene(), TABLE1[1]
    fine = refine(pick_and_place(where, told))
    before, between, after = phases(fine, where, told)
    assert (before.carried, after.carried) == (None, None)
    assert between.carried is not None
    assert between.carried.name == "block"
    assert [phase.first for phase in (before, between, after)] == [
        0,
        fine.stops[0].at,
        fine.stops[1].at,
    ]
    names = [{thing.name for thing in phase.things} for phase in (before, between, after)]
    assert ["block" in each for each in names] == [True, False, True]
    (put,) = [thing.box.center[0] for thing in after.things if thing.name == "block"]
    release = where.hand_pose("target", told.places["target"])
    base = compose(release, inverse(where.bodies["block"].hand_in_body))
    np.testing.assert_allclose(put - base[:3], [0.0, 0.0, 0.05], atol=1e-9)


def test_a_mark_without_height_is_not_in_the_way() -> None:
    where, told = scene(), TABLE1[1]
    for phase in phases(refine(pick_and_place(where, told)), where, told):
        assert "target" not in {thing.name for thing in phase.things}


def test_what_is_seen_counts_more_than_what_was_told() -> None:
    where, told = scene(), TABLE1[1]
    seen = np.array([0.5, 0.0, 0.24, 0.0, 0.0, 0.0, 1.0])
    look = ArmLook(a465.READY, forward(a465.READY), 0.08, "", {"block": seen}, False, 0.0)
    np.testing.assert_array_equal(bodies_at(where, told, look)["block"], seen)
    assert not np.allclose(bodies_at(where, told, None)["block"], seen)


def test_a_setup_in_order_has_no_overlap() -> None:
    where, told = scene(), TABLE1[1]
    assert overlap(where, told, pick_and_place(where, told).stops) is None


def test_two_bodies_in_one_place_overlap() -> None:
    where = Scene("table", {"red": Body("red"), "green": Body("green")}, (TABLE,))
    places = {
        "red": Place("body", (500.0, 0.0, 240.0)),
        "green": Place("body", (530.0, 0.0, 240.0)),
    }
    refusal = overlap(where, Setup("s", "table", places=places), ())
    assert refusal is not None
    assert (refusal.reason, refusal.where, refusal.what) == ("setup", "red", "green")
    assert 29.0 < refusal.amount < 31.0


def test_people_measure_to_the_millimetre() -> None:
    where = scene()
    told = setup((553.0, 190.0, 299.0), 0.0, (520.0, -248.6, 300.0), 40.0)
    assert overlap(where, told, pick_and_place(where, told).stops) is None


def test_a_body_told_within_a_table_is_to_be_put_higher() -> None:
    where = Scene("table", {"red": Body("red")}, (TABLE,))
    places = {"red": Place("body", (500.0, 0.0, 200.0))}
    refusal = overlap(where, Setup("s", "table", places=places), ())
    assert refusal is not None
    assert (refusal.what, refusal.hint) == (TABLE.name, "higher")
