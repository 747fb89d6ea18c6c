"""Corrections taken back and brought again, by number, by words, or all."""

from __future__ import annotations

import pytest

from assistant.dialogue import events as ev
from assistant.dialogue.machine import public_view
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import SCENE, Lessons, moved


def three() -> Lessons:
    """Return a lesson with three corrections."""
    teacher = Lessons().ready()
    teacher.hear(acts.Translate("up"), text="up").hear(
        acts.Translate("down", "little"), text="lower"
    )
    return teacher.hear(acts.Rotate("right"), text="turn right")


def words(teacher: Lessons) -> list[str]:
    view = public_view(teacher.dialogue)
    return [one["words"] for one in view["feedback"]]


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("undo the second correction", ["up", "turn right"]),
        ("take correction 1 back", ["lower", "turn right"]),
        ("forget the last two corrections", ["up"]),
        ("remove all corrections", []),
    ],
)
def test_corrections_are_taken_back_by_number(text: str, left: list[str]) -> None:
    teacher = three().hear(acts.Undo(), text=text, sure=0.6)
    assert teacher.topics[0] == "done.correction_undone"
    assert words(teacher) == left
    assert words(teacher.hear(acts.Undo(), text="undo")) == ["up", "lower", "turn right"]


def test_one_of_them_is_brought_back_to_its_place() -> None:
    teacher = three().hear(acts.Undo(), text="take back the second correction")
    teacher.hear(acts.Redo(), text="bring the second correction back")
    assert words(teacher) == ["up", "lower", "turn right"]


def test_a_number_nobody_gave_is_told() -> None:
    teacher = three().hear(acts.Undo(), text="undo the fifth correction")
    assert teacher.topics[0] == "error.no_such_correction"
    assert len(words(teacher)) == 3


def test_corrections_are_listed_with_numbers_and_sizes() -> None:
    told = three().hear(acts.Show("corrections"))
    said = phrase(told.lines[0])
    assert '1. "up": 5 mm' in said
    assert '3. "turn right": turned 3 degrees right' in said


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("undo the second one", ["up", "turn right"]),
        ("take back the last two", ["up"]),
        ("take back the turn", ["up", "lower"]),
        ("undo the one where you said lower", ["up", "turn right"]),
        ("scratch number one please", ["lower", "turn right"]),
    ],
)
def test_corrections_are_taken_back_without_the_word(text: str, left: list[str]) -> None:
    teacher = three().hear(acts.Undo(), text=text, sure=0.5)
    assert teacher.topics[0] == "done.correction_undone"
    assert words(teacher) == left


@pytest.mark.parametrize(
    "text", ["redo that one", "bring it back", "bring back everything", "redo"]
)
def test_what_was_taken_out_of_the_list_is_brought_back_by_a_redo(text: str) -> None:
    teacher = three().hear(acts.Undo(), text="undo all corrections")
    assert words(teacher) == []
    teacher.hear(acts.Redo(), text=text, sure=1.0 if text == "redo" else 0.5)
    assert teacher.topics[0] == "done.correction_redone"
    assert words(teacher) == ["up", "lower", "turn right"]
    assert teacher.hear(acts.Redo(), text="redo").topics[0] == "error.nothing_to_redo"


def test_one_is_brought_back_by_its_words() -> None:
    teacher = three().hear(acts.Undo(), text="undo all corrections")
    teacher.hear(acts.Redo(), text="bring the turn back", sure=0.5)
    assert words(teacher) == ["turn right"]


def test_of_several_that_fit_it_is_asked_which() -> None:
    teacher = three().hear(acts.Translate("up"), text="up again")
    teacher.hear(acts.Undo(), text="take back the up one", sure=0.5)
    assert teacher.topics[0] == "error.which_correction"
    assert '1. "up"' in phrase(teacher.lines[0])
    assert '4. "up again"' in phrase(teacher.lines[0])
    assert len(words(teacher)) == 4


def test_a_step_of_that_name_is_no_correction() -> None:
    teacher = Lessons().ready().hear(acts.Translate("up"), text="move up object a bit")
    teacher.hear(acts.RemoveSubtask("move up object"), text="remove move up object")
    assert "done.correction_undone" not in teacher.topics


def test_what_an_undo_took_back_is_named() -> None:
    teacher = three().hear(acts.Undo(), text="undo")
    assert phrase(teacher.lines[0]) == 'I took back the last correction: "turn right".'
    teacher.hear(acts.Redo(), text="redo")
    assert phrase(teacher.lines[0]) == 'I brought back the last correction: "turn right".'


def test_the_last_correction_is_taken_back_though_something_else_came_after() -> None:
    teacher = three().happen(ev.Arranged(moved("two", 30.0), SCENE))
    teacher.happen(ev.Checked(teacher.dialogue.known.setup, None, 9.0))
    teacher.hear(acts.Undo(), text="undo the last correction")
    assert words(teacher) == ["up", "lower"]


def test_a_correction_before_a_step_is_listed_as_one() -> None:
    where = acts.Where("grasp object", "before")
    teacher = Lessons().ready().hear(acts.Translate("up", where=where), text="higher before that")
    assert 'before "grasp object"' in phrase(teacher.lines[0])
    told = teacher.hear(acts.Show("corrections")).lines[0]
    assert '5 mm up before "grasp object"' in phrase(told)
