"""A step told to lead to a thing is not left out where the hand goes there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.geometry import Array
from assistant.learning.leading import acts, leads
from assistant.learning.questions import DOUBTED
from assistant.learning.reading import read
from assistant.learning.scoring import motion_lattice, reordered
from assistant.learning.segmentation import gathered, segment
from assistant.model.demonstration import Demonstration, Recording, Spoken
from assistant.model.settings import SegmentationSettings
from assistant.model.setup import Place, Setup
from assistant.model.task import Action, Primitive, Subtask, Task, primitives
from tests.learning import lessons

GIVEN = SegmentationSettings()
REACH = Primitive("reach", Action("move", "approach", "block"))
TAKE = Primitive("take", Action("hand", "close", "block"))
KNOTS = (
    (0.0, (480.0, 80.0, 397.0), 80.0),
    (0.95, (557.0, 80.0, 397.0), 80.0),
    (1.2, (560.0, 80.0, 397.0), 80.0),
    (1.45, (560.0, 80.0, 397.0), 80.0),
    (1.65, (560.0, 80.0, 397.0), 40.0),
    (1.8, (560.0, 80.0, 397.0), 40.0),
    (2.6, (560.0, 80.0, 455.0), 40.0),
    (2.8, (560.0, 80.0, 455.0), 40.0),
    (4.4, (560.0, -58.0, 455.0), 40.0),
    (4.6, (560.0, -60.0, 450.0), 40.0),
    (5.3, (558.0, -60.0, 403.0), 40.0),
    (5.8, (558.0, -60.0, 403.0), 40.0),
    (6.0, (558.0, -60.0, 403.0), 80.0),
    (6.7, (558.0, -60.0, 403.0), 80.0),
)
"""When a hand driven by keys is where, in s and mm, and how far it is open, in mm."""
CUES_S = (0.04, 1.4, 1.85, 2.7, 5.6)


def driven(reach_mm: float = 80.0) -> Demonstration:
    """Return pick and place shown by keys, a cue at each step; the block is near the hand."""
    t_s = np.arange(0.0, 6.7, 0.02)
    times = [knot[0] for knot in KNOTS]
    xyz = np.array([knot[1] for knot in KNOTS]) / 1000.0
    xyz[:, 0] = 0.56 + (xyz[:, 0] - 0.56) * np.where(np.array(times) < 1.2, reach_mm / 80.0, 1.0)
    path = np.zeros((len(t_s), 7))
    path[:, :3] = np.stack([np.interp(t_s, times, column) for column in xyz.T], axis=1)
    path[:, 6] = 1.0
    opening_m = np.interp(t_s, times, [knot[2] / 1000.0 for knot in KNOTS])
    places = {
        "block": Place("hand", (560.0, 80.0, 396.7)),
        "target": Place("hand", (560.0, -60.0, 403.0)),
    }
    cues = tuple(Spoken(at_s, "next step") for at_s in CUES_S)
    setup = Setup("near", places=places)
    return Demonstration(Recording(t_s, path, opening_m), cues=cues, setup=setup)


def left_out(shown: Demonstration, task: Task, settings: SegmentationSettings = GIVEN) -> Array:
    """Return how likely each step was never shown."""
    found = read(shown, task, gathered(shown, task, settings), settings).left_out()
    return np.array([found[k] for k in range(len(found))])


@pytest.mark.parametrize("dropped", [None, 0, 1, 2, 3, 4])
def test_a_short_way_to_a_thing_is_its_approach_and_closing_there_its_grasp(
    dropped: int | None,
) -> None:
    shown = driven()
    shown = replace(shown, cues=tuple(c for k, c in enumerate(shown.cues) if k != dropped))
    assert np.all(left_out(shown, lessons.task())[:2] < 0.05)
    reasons = {question.reason for question in segment(shown, lessons.task()).questions}
    assert not reasons & {"never_shown", DOUBTED}


def test_without_what_speaks_against_it_the_grasp_may_take_the_approach_in() -> None:
    none = replace(GIVEN, decoding=replace(GIVEN.decoding, unled=0.0))
    shown, task = driven(), lessons.task()
    assert left_out(shown, task, none)[0] > 4.0 * left_out(shown, task)[0]
    assert left_out(shown, task, none)[1] > 4.0 * left_out(shown, task)[1]


def test_a_hand_that_lingers_after_the_last_step_does_no_step_nobody_told() -> None:
    shown, task = driven(), lessons.task()
    evidence = gathered(shown, task, GIVEN)
    spots = evidence.candidates
    at_s = np.array([0.0, *(spot.at_s for spot in spots), 6.68])
    opened = int(np.argmin(np.abs(at_s - evidence.events[-1].at_s)))
    unnamed = motion_lattice(shown, task, evidence, spots, GIVEN).unnamed
    assert unnamed[opened, -1] < unnamed[0, opened] - 3.0
    assert "never_introduced" not in {one.reason for one in segment(shown, task).questions}


def test_where_the_hand_is_there_already_the_approach_may_never_have_been_shown() -> None:
    assert left_out(driven(reach_mm=1.0), lessons.task())[0] > 0.3


@pytest.mark.parametrize(
    ("before", "leaf", "told"),
    [
        (REACH, TAKE, True),
        (replace(REACH, optional=True), TAKE, False),
        (replace(REACH, action=Action("move", "approach", "target")), TAKE, False),
        (replace(REACH, action=Action("move", "depart", "block")), TAKE, False),
        (replace(REACH, action=Action("move", "forward")), TAKE, False),
        (TAKE, REACH, False),
        (TAKE, replace(TAKE, action=Action("hand", "open", "block")), False),
    ],
)
def test_what_leads_to_a_step_of_the_hand(before: Primitive, leaf: Primitive, told: bool) -> None:
    assert leads(before, leaf) == told


def test_what_the_hand_does_is_told_by_its_own_acting() -> None:
    assert acts(TAKE, REACH)
    assert not acts(REACH, TAKE)
    assert not acts(TAKE, TAKE)
    assert not acts(replace(TAKE, optional=True), REACH)


def test_a_way_counts_only_where_its_approach_comes_right_before() -> None:
    shown = driven()
    rest = Primitive("wait", Action("free", "wait"))
    task = Task("t", Subtask("t", (REACH, TAKE, rest), order="any"))
    evidence = gathered(shown, task, GIVEN)
    lattice = motion_lattice(shown, task, evidence, evidence.candidates, GIVEN)
    assert [leaf.name for leaf in primitives(task.tree)] == ["reach", "take", "wait"]
    assert lattice.unled[0, -1, 1] < -1.0
    assert np.all(lattice.unled[:, :, 0] == 0.0)
    closed = [spot.at_s for spot in evidence.events if spot.kind == "close"]
    at_s = np.array([0.0, *(spot.at_s for spot in evidence.candidates), 0.0])
    assert np.array_equal(lattice.unled[:, -1, 2] < 0.0, np.isin(at_s, closed))
    first = reordered(lattice, (2, 0, 1)).unled
    assert np.array_equal(first[:, :, 2], lattice.unled[:, :, 1])
    assert np.all(first[:, :, :2] == 0.0)
    assert np.all(reordered(lattice, (0, 2, 1)).unled == 0.0)
