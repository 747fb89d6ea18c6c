"""A thing's shape may be told after its size, and is read back."""

from __future__ import annotations

import pytest

from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.scene import Body
from tests.dialogue.teaching import Lessons


def sized() -> Lessons:
    """Return a lesson in which the size of a candle was told, and where it is is asked."""
    teacher = Lessons().open().tell("light").tell("the candle is on the wooden board")
    return teacher.tell(("candle", "wooden board")).tell("4 by 5 by 6 centimetres")


def candle(teacher: Lessons) -> Body:
    return teacher.dialogue.known.scene.bodies["candle"]


@pytest.mark.parametrize(
    "text", ["the candle is round", "it's really round", "well, the candle is a cylinder"]
)
def test_a_thing_told_to_be_round_is_as_wide_as_its_longer_side(text: str) -> None:
    teacher = sized().hear(acts.Unknown(), text=text)
    assert (candle(teacher).shape, candle(teacher).size_mm) == ("cylinder", (50.0, 50.0, 60.0))
    assert teacher.topics == ["told.size", "ask.pose"]
    assert "The candle is round, 5 centimetres across and 6 high" in phrase(teacher.lines[0])
    assert candle(teacher.hear(acts.Undo())).shape == "box"


@pytest.mark.parametrize(
    "text",
    ["the candle is in the box", "is the candle round?", "the table is round", "go round it"],
)
def test_what_a_thing_is_in_is_not_its_shape(text: str) -> None:
    assert candle(sized().hear(acts.Unknown(), text=text)).shape == "box"


def test_a_size_is_read_back_with_the_next_question() -> None:
    asked = sized().lines[-1]
    assert phrase(asked).startswith("The candle is 4 by 5 centimetres wide and 6 high. Where is")


def test_a_thing_called_in_part_is_what_something_is_put_on() -> None:
    teacher = Lessons().open().tell("light").tell("the candle is on the board")
    roles = {one.name: one.role for one in teacher.tell(("candle", "wooden board")).things}
    assert roles == {"candle": "object", "wooden board": "target"}


def test_of_two_boards_the_one_called_is_meant() -> None:
    teacher = Lessons().open().tell("light").tell("the candle is on the red board")
    roles = {one.name: one.role for one in teacher.tell(("red board", "blue board")).things}
    assert roles == {"red board": "target", "blue board": "object"}


@pytest.mark.parametrize("text", ["x" + " " * 200_000, "is a " * 40_000, "s" * 200_000])
def test_endless_lines_are_read_as_fast_as_any(text: str) -> None:
    assert candle(sized().hear(acts.Unknown(), text=text)).shape == "box"
