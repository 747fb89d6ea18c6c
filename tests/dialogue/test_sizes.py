"""A size is a size, whatever was asked, and things may be told with theirs."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue.sizes import tells_size, without_sizes
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.scene import Obstacle
from tests.dialogue.teaching import Lessons

TABLE = Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0))
FIRST = "a small tea box 4 cm, put it on a book thats on the table to the right of it"


def test_a_size_is_no_goal() -> None:
    teacher = Lessons().open().tell("little jar on a coaster")
    teacher.hear(acts.Unknown(), text="the jar is 6 cm tall, 5 wide")
    assert teacher.topics == ["told.size", "ask.goal"]
    assert "5 by 5 centimetres wide and 6 high" in phrase(teacher.lines[0])
    assert teacher.dialogue.known.goal is None


def test_things_are_told_with_their_sizes() -> None:
    teacher = Lessons().open().tell("tea box").tell("the tea box is on the book")
    teacher.hear(acts.Unknown(), text=FIRST)
    known = teacher.dialogue.known
    assert [one.name for one in known.objects or ()] == ["small tea box", "book"]
    assert known.scene.bodies["small tea box"].size_mm == (40.0, 40.0, 40.0)
    assert "book" not in known.scene.bodies


@pytest.mark.parametrize(
    "text",
    [
        "15 cm to the right of the jar",
        "move it 10 cm higher",
        "the jar stands on the coaster",
        "it has three parts",
        "5 mm away from the edge",
    ],
)
def test_a_place_a_way_and_a_number_are_no_size(text: str) -> None:
    assert not tells_size(text, "english")


def test_a_sentence_is_read_without_its_sizes() -> None:
    assert without_sizes("a jar, 6 cm tall, 5 wide", "english").startswith("a jar")
    assert not any(sign.isdigit() for sign in without_sizes("a box 30 x 20 x 1 cm", "english"))


def test_a_box_is_the_thing_asked_about_though_another_is_called_one() -> None:
    teacher = Lessons().open().tell("tea box").tell("the tea box is on the coaster")
    teacher.tell(("tea box", "coaster")).tell("a box, 6 by 4 by 7 centimetres")
    if teacher.asked == "pose":
        teacher.hear(acts.Deny(), text="no")
    teacher.tell("a box 100 by 100 by 5 mm")
    bodies = teacher.dialogue.known.scene.bodies
    assert bodies["tea box"].size_mm == (60.0, 40.0, 70.0)
    assert bodies["coaster"].size_mm == (100.0, 100.0, 5.0)


def test_the_plan_is_read_back_with_the_sizes_told() -> None:
    teacher = Lessons().open().tell("tea box").tell("the tea box is on the book")
    teacher.hear(
        acts.Unknown(), text="a tea box 4 cm wide and 7 high, and a book 15 by 12 and 3 high"
    )
    for _ in range(2):
        teacher.hear(acts.Deny(), text="no")
    steps = ("take the tea box", "lift it", "carry it to the book", "put it down")
    teacher.tell(steps)
    while teacher.asked == "subtask_count":
        teacher.tell(0)
    assert teacher.topics[-1] == "confirm.tree"
    told = phrase(teacher.lines[-1])
    assert "the tea box to be 4 by 4 by 7 and the book to be 15 by 12 by 3 centimetres" in told
    # What it is carried to is where it is put down, though the last step does not name it.
    roles = {one.name: one.role for one in teacher.dialogue.known.objects or ()}
    assert roles == {"tea box": "object", "book": "target"}


def test_the_size_of_one_thing_is_no_list_of_all() -> None:
    teacher = Lessons().open().tell("tea box").tell("the tea box is on the book")
    teacher.hear(acts.Unknown(), text="the tea box is 4 cm wide and 6 high")
    assert teacher.topics == ["told.size", "ask.objects"]
    assert teacher.dialogue.known.objects is None


def asked_where() -> Lessons:
    """Return a lesson with a table in which it is asked where a thing is."""
    teacher = Lessons().open().tell("tea box").tell("the tea box is on the coaster")
    known = teacher.dialogue.known
    scene = replace(known.scene, tables=(TABLE,))
    teacher.dialogue = replace(teacher.dialogue, known=replace(known, scene=scene))
    return teacher.tell(("tea box", "coaster")).tell("a box, 6 by 4 by 7 centimetres")


def test_lengths_by_each_other_are_a_size_also_where_a_place_is_asked() -> None:
    teacher = asked_where()
    teacher.hear(acts.SetPose("", position_mm=(15.0, 15.0, 1.0)), text="15 by 15 by 1 cm")
    assert teacher.topics[0] == "told.size"
    assert teacher.dialogue.known.scene.bodies["coaster"].size_mm == (150.0, 150.0, 10.0)
    assert not teacher.dialogue.known.setup.places.get("tea box")


def test_lengths_that_could_be_a_place_are_one_where_a_place_is_asked() -> None:
    teacher = asked_where()
    told = acts.SetPose("", position_mm=(450.0, 100.0, 240.0))
    teacher.hear(told, text="450 x 100 x 240")
    assert teacher.dialogue.known.setup.places["tea box"].xyz_mm == (450.0, 100.0, 240.0)
