"""One branch is chosen for a whole task; where there is none, the worst place is told."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.model.setup import Setup
from sim.branches import answers, candidates, forbidden, needed, place_name
from sim.fine_path import FinePath, refine
from tests.sim.hand_paths import TABLE1, pick_and_place, scene, setup


def fine(told: Setup) -> FinePath:
    return refine(pick_and_place(scene(), told))


@pytest.mark.parametrize("told", TABLE1)
def test_a_branch_that_is_offered_holds_every_exact_sample(told: Setup) -> None:
    path = fine(told)
    found, flags = answers(path.poses), needed(path, True)
    offered = candidates(found, flags, None)
    assert offered
    for branch in offered:
        assert found.margin[flags, branch].min() >= 0.0


def test_the_branch_with_the_least_to_turn_comes_first() -> None:
    path = fine(TABLE1[0])
    found = answers(path.poses)
    first = candidates(found, needed(path, True), None)[0]
    grasp, release = (found.q[stop.at, first] for stop in path.stops)
    # On the other branches of the wrist joint 4 would pass half a turn.
    assert abs(release[3] - grasp[3]) < np.pi / 2


@pytest.mark.parametrize(
    ("x_mm", "reason", "hint"),
    [(150.0, "reach", "farther"), (260.0, "joint_limit", "farther"), (800.0, "reach", "closer")],
)
def test_the_worst_place_is_told_with_what_would_help(x_mm: float, reason: str, hint: str) -> None:
    path = fine(setup((x_mm, 0.0, 330.0), 0.0, (520.0, -248.6, 300.0), 40.0))
    refusal = forbidden(answers(path.poses), needed(path, True), path)
    assert (refusal.where, refusal.reason, refusal.hint) == ("grasp of block", reason, hint)
    assert refusal.amount > 0.0


def test_places_are_named_in_the_tasks_words() -> None:
    path = fine(TABLE1[0])
    grasp, release = path.stops
    between = (grasp.left_at + release.docking_at) // 2
    named = [place_name(path, k) for k in (0, grasp.docking_at, between, release.at)]
    assert named == ["start", "grasp of block", "way to target", "release at target"]
    assert place_name(path, len(path.u_s) - 1) == "end"


def test_what_begins_where_another_stretch_ends_is_told_of_the_place_it_goes_with() -> None:
    path = fine(TABLE1[0])
    grasp, release = path.stops
    wiped = replace(release, kind="touch", docking_at=grasp.left_at)
    joined = replace(path, stops=(grasp, wiped))
    assert place_name(joined, grasp.left_at) == "touch of target"
    assert place_name(joined, grasp.left_at - 1) == "grasp of block"
