from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.geometry import Array
from assistant.learning.candidates import gather
from assistant.learning.handling import (
    acted,
    carrying,
    goals,
    handled,
    held_before,
    reaching,
    untold,
)
from assistant.learning.smoothing import smooth
from assistant.learning.stretches import Stretches, stretches
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Action, Primitive, Subtask, Task, TaskObject

GIVEN = SegmentationSettings()
BODIES = (TaskObject("cup", "object"), TaskObject("mat", "target"))
REACH = Primitive("reach", Action("move", "approach", "cup"))
TAKE = Primitive("take", Action("hand", "close", "cup"))
LIFT = Primitive("lift", Action("move", "up", "cup"))
CARRY = Primitive("carry", Action("move", "to", "mat"))
DROP = Primitive("drop", Action("hand", "open", "mat"))
LEAVE = Primitive("leave", Action("move", "depart", "mat"))
LOWER = Primitive("put it down", Action("move", "down", "cup"))


def task(*leaves: Primitive) -> Task:
    return Task("t", Subtask("t", leaves), objects=BODIES)


def between(ends_s: tuple[float, ...] = (2.0, 4.0, 6.0)) -> Stretches:
    """The hand goes left all the time; it closes at 2 s and opens at 4 s."""
    t_s = np.arange(0.0, 6.0, 0.02)
    path = np.zeros((len(t_s), 7))
    path[:, 1], path[:, 6] = 0.1 * t_s, 1.0
    opening = np.where((t_s > 1.99) & (t_s < 3.99), 0.02, 0.08)
    shown = Demonstration(Recording(t_s, path, opening))
    evidence = gather(shown, smooth(shown.recording), GIVEN)
    return stretches(np.array([0.0, *ends_s]), evidence, 0.05)


def marked(told: Array) -> set[tuple[int, int]]:
    return {(int(a), int(b)) for a, b in zip(*np.nonzero(np.triu(told, 1)), strict=True)}


def test_what_the_hand_did_more_often_than_told_ends_a_step_nobody_told() -> None:
    spans = between()
    closing, opening = {(0, 1)}, {(0, 2), (1, 2)}
    for leaves, expected in (
        ((REACH, TAKE, CARRY, DROP), set()),
        ((REACH, CARRY), set()),
        ((REACH, TAKE, LOWER), set()),
        ((REACH, TAKE, CARRY), opening),
        ((REACH, TAKE, CARRY, LEAVE), opening),
        ((REACH, CARRY, DROP), closing),
        ((REACH, TAKE), opening),
    ):
        told = untold(leaves, task(*leaves), spans)
        assert {span for span in marked(told) if span[1] < 3} == expected, leaves


def test_a_step_nobody_told_may_end_after_the_hand_has_rested() -> None:
    spans = between((2.0, 3.0, 6.0))
    told = untold((REACH, TAKE, CARRY), task(REACH, TAKE, CARRY), spans)
    assert {(0, 3), (1, 3), (2, 3)} == marked(told)


def test_where_a_step_of_the_hand_tells_it_no_other_is_looked_for() -> None:
    assert marked(acted((REACH, CARRY), between())) == {(0, 1), (0, 2), (1, 2)}
    assert marked(acted((REACH, TAKE, CARRY), between())) == {(0, 2), (1, 2)}
    assert marked(acted((REACH, TAKE, CARRY, DROP), between())) == set()


@pytest.mark.parametrize(
    ("leaf", "others", "way"),
    [
        (REACH, (CARRY,), 1),
        (REACH, (TAKE, CARRY, DROP), -1),
        (REACH, (CARRY, DROP), -1),
        (LIFT, (REACH, CARRY), -1),
        (LEAVE, (REACH, CARRY), -1),
        (replace(LIFT, action=Action("turn", "left", "cup")), (REACH, CARRY), -1),
        (replace(LIFT, action=Action("move", "left")), (REACH, CARRY), -1),
        (replace(LIFT, action=Action("free", "shake")), (REACH, CARRY), 0),
    ],
)
def test_a_motion_ends_in_closing_the_hand_only_where_it_means_that(
    leaf: Primitive, others: tuple[Primitive, ...], way: int
) -> None:
    told = frozenset(one.action.way for one in others if one.action.verb == "hand")
    score = handled(leaf, task(leaf, *others), between(), True, told, GIVEN)
    assert np.sign(score[0, 1]) == way
    assert score[2, 3] == 0.0
    assert np.all(handled(leaf, task(leaf), between(), False, told, GIVEN) == 0.0)


def test_letting_go_may_be_part_of_putting_down_what_was_taken() -> None:
    told = frozenset({"close"})
    assert handled(LOWER, task(LOWER, TAKE), between(), True, told, GIVEN)[1, 2] == 0.0
    assert handled(CARRY, task(CARRY, TAKE), between(), True, told, GIVEN)[1, 2] < 0.0
    assert handled(CARRY, task(CARRY, REACH), between(), True, frozenset(), GIVEN)[1, 2] > 0.0


def test_who_leaves_a_target_has_let_go_even_where_nobody_told_the_way_there() -> None:
    told = held_before((REACH, LIFT, LEAVE), task())
    assert told == {"lift": True, "leave": False}
    assert held_before((REACH, LIFT, CARRY, LEAVE), task())["leave"] is False
    assert held_before((LIFT, CARRY), task()) == {"lift": True, "carry": True}


def test_who_tells_one_way_to_a_thing_tells_the_other_too() -> None:
    other = Primitive("take more", Action("hand", "close", "mat"))
    assert reaching((TAKE, DROP)) == {"take", "drop"}
    assert reaching((REACH, TAKE, DROP)) == {"drop"}
    assert reaching((REACH, TAKE, CARRY, DROP, other)) == set()


def test_what_a_thing_is_put_on_is_where_its_way_ends_whatever_its_role() -> None:
    onto = Primitive("stack", Action("move", "down", "cup"))
    take = Primitive("take", Action("hand", "close", "lid"))
    bodies = (*BODIES, TaskObject("lid", "object"))
    given = replace(task(), objects=bodies)
    assert goals((take, onto, CARRY), given) == {"stack", "carry"}
    assert goals((take, DROP, onto), given) == {"drop"}
    assert goals((TAKE, LIFT, LOWER), given) == set()


def test_what_is_carried_to_a_target_is_in_the_hand_where_the_hand_was_told_to_take_it() -> None:
    leaves = (REACH, TAKE, LIFT, CARRY, DROP, LEAVE)
    assert carrying(leaves, task(*leaves)) == {CARRY.name: True}
    assert carrying((REACH, LIFT, CARRY), task(REACH, LIFT, CARRY)) == {}
    assert carrying((TAKE, DROP, CARRY), task(TAKE, DROP, CARRY)) == {}
