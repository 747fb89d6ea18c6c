"""Random setups are reachable, spread over their sector and the same for the same seed."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import numpy as np
import pytest

from assistant.errors import WorkFailed
from assistant.model.motion import Refusal
from assistant.model.scene import Obstacle
from assistant.model.setup import READY, Setup
from sim.feasibility import reachable
from sim.planner import A465Planner
from sim.setups import FRONT_DEG, new_setup, postures, random_setup, random_setups
from tests.benchmarks.bench_refusals import full, unreachable
from tests.sim.hand_paths import TABLE1, pick_and_place, scene, setup, taught


def test_the_same_seed_and_number_give_the_same_setup() -> None:
    first, again = (random_setup(taught(), scene(), 3, 2) for _ in range(2))
    other = random_setup(taught(), scene(), 4, 2)
    assert first == again
    assert first.places != other.places
    assert next(islice(random_setups(taught(), scene(), 3), 1, 2)) == first


def test_they_are_reachable_by_the_plain_check() -> None:
    for told in islice(random_setups(taught(), scene(), 5), 4):
        assert reachable(postures(taught(), scene(), told), scene())


@pytest.mark.parametrize("how", ["drawn", "anywhere", "near"])
def test_what_the_plain_check_calls_out_of_reach_is_refused_with_all_there_is_to_tell(
    how: str,
) -> None:
    random = np.random.default_rng(8)
    for told in islice(unreachable(how, taught(), scene(), random), 3):
        refusal = A465Planner().plan(pick_and_place(scene(), told), scene(), told)
        assert isinstance(refusal, Refusal)
        assert full(refusal), str(refusal)


def test_the_front_sector_lies_ahead() -> None:
    for told in islice(random_setups(taught(), scene(), 6, "front"), 6):
        for place in told.places.values():
            assert abs(np.rad2deg(np.arctan2(place.pose[1], place.pose[0]))) <= FRONT_DEG


def test_all_around_reaches_behind() -> None:
    drawn = islice(random_setups(taught(), scene(), 7), 12)
    assert any(place.pose[0] < 0 for told in drawn for place in told.places.values())


def test_the_start_may_be_kept_at_ready() -> None:
    told = random_setup(taught(), scene(), 1, 1, random_start=False)
    assert told.robot_start == READY


def test_what_only_the_lesson_came_upon_is_put_somewhere_too() -> None:
    untold = replace(taught(), objects=taught().objects[:1])
    told = new_setup(untold, scene(), TABLE1[3], 5)
    assert told is not None
    assert set(told.places) == {"block", "target"}


def test_a_new_setup_starts_where_the_old_one_did() -> None:
    told = new_setup(taught(), scene(), TABLE1[3], 5)
    assert told is not None
    assert told.robot_start == TABLE1[3].robot_start


def test_where_nothing_is_reachable_none_is_found() -> None:
    walled = scene(Obstacle("wall", (1600.0, 1600.0, 1500.0), (0.0, 0.0, 0.0)))
    small = replace(walled, tables=(replace(walled.tables[0], size_mm=(900.0, 900.0, 20.0)),))
    with pytest.raises(WorkFailed, match="no reachable setup"):
        random_setup(taught(), small, 1, 1)


@pytest.mark.parametrize("told", TABLE1)
def test_table_1_is_reachable(told: Setup) -> None:
    assert reachable(postures(taught(), scene(), told), scene())


def test_what_is_far_or_blocked_is_not() -> None:
    far = setup((800.0, 0.0, 300.0), 0.0, (500.0, -240.0, 300.0), 0.0)
    assert not reachable(postures(taught(), scene(), far), scene())
    post = Obstacle("post", (30.0, 30.0, 300.0), (480.0, -285.0, 240.0))
    assert not reachable(postures(taught(), scene(post), TABLE1[1]), scene(post))
