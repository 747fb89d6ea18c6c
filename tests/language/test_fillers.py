import pytest

from assistant.language.fillers import without_fillers
from assistant.language.phrasebook import phrasebook
from assistant.language.words import spoken, words_of
from assistant.model.teacher_acts import Asked


@pytest.mark.parametrize(
    ("text", "asked", "left"),
    [
        ("um, a bit, er, more left", None, "a bit more left"),
        ("mate, go left", None, "go left"),
        ("go left a touch, dear", None, "go left a touch"),
        ("a spoon and honey", "objects", "a spoon and honey"),
        ("a spoon, honey", "objects", "a spoon honey"),
        ("duck feeding", "task_name", "duck feeding"),
        ("um", None, "um"),
    ],
)
def test_only_what_carries_nothing_is_left_out(text: str, asked: Asked | None, left: str) -> None:
    book = phrasebook()
    assert spoken(without_fillers(words_of(text, book.contractions), asked, book)) == left


def test_a_mark_before_a_filler_stays_before_the_next_word() -> None:
    book = phrasebook()
    words = without_fillers(words_of("left, er, right", book.contractions), None, book)
    assert [word.broken for word in words] == [False, True]
