from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import Array, quat_from_rpy
from assistant.learning.candidates import gather
from assistant.learning.fit import fits, known_places
from assistant.learning.smoothing import smooth
from assistant.learning.stretches import stretches
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.settings import SegmentationSettings
from assistant.model.setup import Place, Setup
from assistant.model.task import Action, Primitive, Subtask, Task, TaskObject

GIVEN = SegmentationSettings()
BODIES = (TaskObject("cup", "object"), TaskObject("mat", "target"))
NODES = np.array([0.0, 2.0, 4.0, 6.0])


def shown(*, gripper: bool = True, setup: Setup | None = None) -> Demonstration:
    """Up for 2 s, left for 2 s while the hand closes and opens, a turn to the left for 2 s."""
    t_s = np.arange(0.0, 6.0, 0.02)
    path = np.zeros((len(t_s), 7))
    path[:, 2] = 0.1 * np.clip(t_s / 2.0, 0, 1)
    path[:, 1] = 0.1 * np.clip((t_s - 2.0) / 2.0, 0, 1)
    yaw = np.clip((t_s - 4.0) / 2.0, 0, 1)
    path[:, 3:] = quat_from_rpy(np.stack([0 * t_s, 0 * t_s, yaw], axis=1))
    opening = np.where((t_s > 2.5) & (t_s < 3.5), 0.02, 0.08)
    return Demonstration(Recording(t_s, path, opening if gripper else None), setup=setup or Setup())


def scores(action: Action, demonstration: Demonstration | None = None) -> Array:
    """Return the fits of the three consecutive stretches to one action."""
    demonstration = demonstration or shown(gripper=False)
    evidence = gather(demonstration, smooth(demonstration.recording), GIVEN)
    task = Task("t", Subtask("t", (Primitive("it", action),)), objects=BODIES)
    all_fits = fits(task, demonstration, evidence, stretches(NODES, evidence), GIVEN)
    return np.array([all_fits[k, k + 1, 0] for k in range(3)])


@pytest.mark.parametrize(
    ("action", "best"),
    [
        (Action("move", "up"), 0),
        (Action("move", "left"), 1),
        (Action("turn", "left"), 2),
        (Action("turn", "right"), -1),
    ],
)
def test_motion_and_action_match(action: Action, best: int) -> None:
    told = scores(action)
    if best >= 0:
        assert int(np.argmax(told)) == best
    else:
        assert int(np.argmin(told)) == 2


def test_who_goes_one_way_goes_somewhere() -> None:
    """A hand that only turns goes neither up nor down, and less so than to a thing it is at."""
    up, down = scores(Action("move", "up")), scores(Action("move", "down"))
    assert max(up[2], down[2]) < scores(Action("move", "approach", "cup"))[2] - 1.5
    assert up[2] == pytest.approx(down[2], abs=0.1)


@pytest.mark.parametrize("way", ["up", "down", "forward", "backward", "clockwise"])
def test_other_turns_do_not_look_like_a_turn_to_the_left(way: str) -> None:
    assert scores(Action("turn", "left"))[2] > scores(Action("turn", way))[2] + 1.0


def test_events_belong_to_the_hands_own_actions() -> None:
    demonstration = shown()
    evidence = gather(demonstration, smooth(demonstration.recording), GIVEN)
    nodes = np.array([0.0, 2.2, evidence.events[0].at_s, 6.0])
    between = stretches(nodes, evidence)
    assert [event.kind for event in evidence.events] == ["close", "open"]
    assert between.at_end["close"][1, 2] == 1.0
    assert between.inside["close"][1, 2] == 0.0
    assert between.inside["open"][2, 3] == 1.0
    leaves = (Primitive("grip", Action("hand", "close")), Primitive("move", Action("move", "up")))
    task = Task("t", Subtask("t", leaves), objects=BODIES)
    told = fits(task, demonstration, evidence, between, GIVEN)
    assert told[1, 2, 0] > told[1, 2, 1]
    assert told[0, 1, 1] > told[0, 1, 0]


def test_an_approach_ends_where_the_thing_is_told_to_be() -> None:
    there = Setup(places={"cup": Place("hand", (0.0, 100.0, 100.0))})
    told = scores(Action("move", "approach", "cup"), shown(gripper=False, setup=there))
    plain = scores(Action("move", "approach", "cup"))
    assert (told - plain)[1] > (told - plain)[0]
    away = scores(Action("move", "depart", "cup"), shown(gripper=False, setup=there))
    plain = scores(Action("move", "depart", "cup"))
    assert (away - plain)[2] > (away - plain)[0]


def test_what_is_pushed_aside_need_not_end_where_it_was() -> None:
    there = Setup(places={"cup": Place("hand", (0.0, 100.0, 100.0))})
    for action in (Action("move", "left", "cup"), Action("move", "down", "cup")):
        assert scores(action, shown(gripper=False, setup=there)) == pytest.approx(scores(action))


def test_without_a_told_place_things_are_where_the_hand_acted() -> None:
    demonstration = shown()
    evidence = gather(demonstration, smooth(demonstration.recording), GIVEN)
    leaves = (
        Primitive("a", Action("move", "approach", "cup")),
        Primitive("b", Action("move", "to", "mat")),
    )
    task = Task("t", Subtask("t", leaves), objects=BODIES)
    places = known_places(task, demonstration, evidence)
    assert places["cup"] == pytest.approx([0.0, 0.025, 0.1], abs=5e-3)
    assert places["mat"] == pytest.approx([0.0, 0.075, 0.1], abs=5e-3)


def test_a_way_there_and_back_is_no_single_step() -> None:
    t_s = np.arange(0.0, 6.0, 0.02)
    path = np.zeros((len(t_s), 7))
    path[:, 0] = 0.2 * np.sin(np.pi * t_s / 6.0)
    path[:, 1], path[:, 6] = 0.05 * t_s / 6.0, 1.0
    demonstration = Demonstration(Recording(t_s, path))
    evidence = gather(demonstration, smooth(demonstration.recording), GIVEN)
    between = stretches(np.array([0.0, 3.0, 6.0]), evidence)
    assert between.longer[0, 1] < 0.1 < 1.0 < between.longer[0, 2]
    task = Task("t", Subtask("t", (Primitive("it", Action("move", "approach", "cup")),)))
    told = fits(task, demonstration, evidence, between, GIVEN)[:, :, 0]
    assert told[0, 2] < told[0, 1] - 1.0


def test_a_step_of_the_hand_that_nothing_leads_to_brings_it_there() -> None:
    """Who says "take the cup" means the way there, unless the way was told as its own step."""
    demonstration = shown()
    evidence = gather(demonstration, smooth(demonstration.recording), GIVEN)
    between = stretches(np.array([0.0, evidence.events[0].at_s, 6.0]), evidence)
    take = Primitive("take", Action("hand", "close", "cup"))
    reach = Primitive("reach", Action("move", "approach", "cup"))
    coarse, fine = (
        fits(
            Task("t", Subtask("t", parts), objects=BODIES), demonstration, evidence, between, GIVEN
        )
        for parts in ((take,), (reach, take))
    )
    assert coarse[0, 1, 0] > fine[0, 1, 1] + 2.0
