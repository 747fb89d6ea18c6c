"""Which step each episode is: in another order than introduced, and as the teacher says."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.errors import BadInput
from assistant.learning.segmentation import segment
from assistant.model.setup import Setup
from assistant.model.task import Subtask, primitives
from tests.generators import generator_a, generator_b


def test_parts_shown_in_another_order_are_recognized() -> None:
    seed = next(k for k in range(70_000, 70_100) if len(generator_a.generate(k).names) >= 8)
    shown = generator_a.generate(seed)
    leaves = primitives(shown.task.tree)
    one = tuple(leaf for leaf in leaves if leaf.name.endswith("1"))
    two = tuple(leaf for leaf in leaves if leaf.name.endswith("2"))
    parts = (Subtask("second", two), Subtask("first", one))
    places = generator_a.generate(seed).demonstration.setup.places
    if not places:
        shown = replace(shown, demonstration=replace(shown.demonstration, setup=Setup()))
    task = replace(shown.task, tree=Subtask("both", parts, order="any"))
    found = segment(shown.demonstration, task)
    named = [episode.primitive for episode in found.episodes]
    if places:
        assert named == list(shown.names)
    assert len(named) == len(shown.names)


@pytest.mark.parametrize("seed", [70_413, 70_418])
def test_what_was_told_to_be_free_may_be_shown_the_other_way_round(seed: int) -> None:
    shown = generator_b.generate(seed)
    assert shown.names != tuple(leaf.name for leaf in primitives(shown.task.tree))
    found = segment(shown.demonstration, shown.task)
    assert tuple(episode.primitive for episode in found.episodes) == shown.names


def test_assignments_of_the_teacher_are_certain() -> None:
    shown = generator_a.generate(70_002)
    name = shown.names[2]
    found = segment(shown.demonstration, shown.task, cuts_s=shown.cuts_s, assigned=[(2, name)])
    assert found.episodes[1].primitive == name
    assert found.episodes[1].probability == 1.0


@pytest.mark.parametrize(("number", "name"), [(99, "known"), (1, "unknown to the tree")])
def test_wrong_assignments_are_refused(number: int, name: str) -> None:
    shown = generator_a.generate(70_002)
    told = shown.names[0] if name == "known" else name
    with pytest.raises(BadInput):
        segment(shown.demonstration, shown.task, assigned=[(number, told)])
