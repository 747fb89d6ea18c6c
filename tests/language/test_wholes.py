import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Unordered


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("the two parts of step two in any order", "step two"),
        ("the parts of lifting the cup may happen in any order", "lifting the cup"),
    ],
)
def test_what_parts_are_parts_of_is_named_by_itself(text: str, name: str) -> None:
    assert understand(text, Listening()).acts == (Unordered((name,)),)


def test_a_known_step_is_told_by_its_place() -> None:
    names = ("reach", "lift", "carry", "set down")
    told = understand("the two parts of step two can go in any order", Listening(subtasks=names))
    assert told.acts == (Unordered(("lift",)),)


def test_steps_that_are_named_are_themselves_in_any_order() -> None:
    told = understand("the order of lift and wipe does not matter", Listening())
    assert told.acts == (Unordered(("lift", "wipe")),)
