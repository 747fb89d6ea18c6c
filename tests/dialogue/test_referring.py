"""Steps called by the numbers the robot reads back."""

from __future__ import annotations

import pytest

from assistant.dialogue.machine import begin
from assistant.dialogue.referring import by_name
from assistant.dialogue.state import Dialogue
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import STEPS, Lessons


@pytest.fixture(scope="module")
def nested() -> Dialogue:
    return Lessons().introduce().dialogue


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("rename step 1.2 to grab", f"rename {STEPS[1]} to grab"),
        ("remove Step number 2.1", f"remove {STEPS[3]}"),
        ("split the second step", "split place object"),
        ("step 2 comes first", "place object comes first"),
        ("rename step 3 to x", "rename step 3 to x"),
        ("1.2 cm left", "1.2 cm left"),
        ("go up 1.2", "go up 1.2"),
    ],
)
def test_a_number_is_that_of_the_tree_as_it_is_read_back(
    nested: Dialogue, said: str, meant: str
) -> None:
    assert by_name(nested, said) == meant


def test_what_names_something_new_refers_to_nothing() -> None:
    naming = Lessons().open().tell("x y z").tell("done then").tell(("block", "target")).tell(2)
    for said in ("the second step is called step 1", "step 1.1"):
        assert by_name(naming.dialogue, said) == said
    watching = Lessons().confirmed().hear(acts.Start())
    assert by_name(watching.dialogue, "second step") == "second step"


def test_a_flat_tree_is_left_to_the_understanding() -> None:
    flat = Lessons(begin()).open().tell("x y z").tell("done then").tell(("block", "target"))
    flat.tell(2).tell("grasp the block").tell("release the block")
    assert by_name(flat.dialogue, "remove step 2") == "remove step 2"


def test_words_that_change_the_plan_refer_to_it_whatever_is_asked() -> None:
    naming = Lessons().open().tell("x y z").tell("done then").tell(("block", "target"))
    naming.tell(("fetch", "serve")).tell(("grasp the block", "lift it"))
    assert naming.asked == "subtask_count"
    assert by_name(naming.dialogue, "the second step is optional") == "serve is optional"
    listed = "step 1 look, step 2 turn, step 1.1 skip"
    assert by_name(naming.dialogue, listed) == listed


def test_the_second_of_two_numbers_is_a_step_as_well() -> None:
    flat = Lessons(begin()).open().tell("x y z").tell("done then").tell(("block", "target"))
    flat.tell(("grasp the block", "lift it", "open the hand"))
    flat.hear(acts.Merge(("grasp the block", "2")), text="merge steps 1 and 2")
    assert [part.name for part in flat.dialogue.known.root.parts][1:] == ["open the hand"]
    assert "7" in flat.hear(acts.Merge(("7", "2")), text="merge 7 and 2").lines[0].slots["name"]
