from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from assistant.files.demonstrations import read_demonstration
from assistant.files.tasks import read_task
from assistant.learning.questions import UNHEARD
from assistant.learning.reading import Understood, read, read_cuts
from assistant.learning.segmentation import gathered, segment
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Subtask, primitives
from tests.generators import generator_a
from tests.generators.shown import Shown

USUAL = SegmentationSettings()


def understood(shown: Shown) -> Understood:
    evidence = gathered(shown.demonstration, shown.task, USUAL)
    return read(shown.demonstration, shown.task, evidence, USUAL)


def without(shown: Shown, name: str) -> Shown:
    leaves = tuple(leaf for leaf in primitives(shown.task.tree) if leaf.name != name)
    return replace(shown, task=replace(shown.task, tree=Subtask("told", leaves)))


def test_a_step_left_out_of_the_introduction_is_found_where_it_was() -> None:
    shown = generator_a.generate(70_031)
    told = understood(without(shown, shown.names[2]))
    from_s, to_s, chance = told.unheard()[0]
    assert chance > UNHEARD
    assert shown.cuts_s[1] < 0.5 * (from_s + to_s) < shown.cuts_s[2]
    assert not [place for place in understood(shown).unheard() if place[2] > UNHEARD]


def test_where_the_teacher_cut_nothing_is_said_to_be_unheard() -> None:
    shown = generator_a.generate(70_030)
    evidence = gathered(shown.demonstration, shown.task, USUAL)
    told = read_cuts(shown.demonstration, shown.task, evidence, USUAL, shown.cuts_s)
    assert segment(shown.demonstration, shown.task, cuts_s=shown.cuts_s).questions == ()
    assert not [place for place in told.unheard() if place[2] > UNHEARD]


@pytest.mark.parametrize("name", ["insertion", "pick_and_place", "sorting", "wiping"])
def test_a_hand_that_leaves_at_the_end_is_not_asked_about(name: str) -> None:
    """The shipped demonstrations end backing off; nobody told that as a step."""
    folder = Path(__file__).parents[2] / "tasks"
    shown = read_demonstration(folder / "demonstrations" / f"{name}.yaml")
    found = segment(shown, read_task(folder / f"{name}.yaml"))
    assert "never_introduced" not in {one.reason for one in found.questions}


def test_a_block_is_carried_to_the_block_it_is_put_on() -> None:
    """What a thing is put on may be a thing itself: its way there goes aside, then down."""
    folder = Path(__file__).parents[2] / "tasks"
    shown = read_demonstration(folder / "demonstrations" / "stacking.yaml")
    found = segment(shown, read_task(folder / "stacking.yaml"))
    lifted = next(one for one in found.episodes if one.primitive == "lift green block")
    assert lifted.to_s == pytest.approx(23.5, abs=0.3)
    assert "never_introduced" not in {one.reason for one in found.questions}
