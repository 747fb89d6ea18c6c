from typing import cast

import pytest

from assistant.language.leading_answers import with_answer, without_nothing
from assistant.language.parsing import Hearing
from assistant.language.phrasebook import phrasebook
from assistant.language.words import words_of
from assistant.model.listening import Listening
from assistant.model.teacher_acts import (
    Affirm,
    Asked,
    Deny,
    Merge,
    Optional,
    Required,
    TeacherAct,
    Translate,
)

MERGED = Merge(("lift", "carry"))


def answered(text: str, acts: tuple[TeacherAct, ...], asked: str) -> tuple[TeacherAct, ...]:
    book = phrasebook()
    hearing = Hearing(book, Listening(stage="learning", asked=cast("Asked", asked)))
    return with_answer(acts, words_of(text, book.contractions), hearing)


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        ("no, merge lift and carry", Deny()),
        ("no no, merge lift and carry", Deny()),
        ("yes, but merge lift and carry", Affirm()),
    ],
)
def test_an_answer_stays_before_what_is_to_change(text: str, answer: TeacherAct) -> None:
    assert answered(text, (MERGED,), "confirm_segmentation") == (answer, MERGED)


def test_only_an_answer_to_a_question_is_one() -> None:
    assert answered("no, merge lift and carry", (MERGED,), "order") == (MERGED,)
    assert answered("merge lift and carry", (MERGED,), "confirm_tree") == (MERGED,)
    assert answered("no order between lift and carry", (MERGED,), "confirm_tree") == (MERGED,)
    moved = (Translate("left"),)
    assert answered("no, left", moved, "satisfied") == moved


@pytest.mark.parametrize("name", ["nothing", "None"])
def test_no_step_is_called_nothing_where_it_was_asked_what_may_be_left_out(name: str) -> None:
    asked = Hearing(phrasebook(), Listening(stage="introduction", asked="optional"))
    beside = Hearing(phrasebook(), Listening(stage="introduction"))
    for act in (Optional(name), Required(name)):
        assert without_nothing((act,), asked) == (Deny(),)
        assert without_nothing((act,), beside) == (act,)
    assert without_nothing((Optional("no lid"),), asked) == (Optional("no lid"),)
