import pytest

from assistant.language.cues import counted_cue
from assistant.language.parsing import Hearing
from assistant.language.phrasebook import phrasebook
from assistant.language.words import words_of
from assistant.model.listening import Listening
from assistant.model.teacher_acts import act_to_json
from tests.language.heard_as import heard_as


@pytest.mark.parametrize(
    ("text", "which"),
    [
        ("now going fifth step", 5),
        ("we have now arrived at stage number three", 3),
        ("so, on to the fourth bit then", 4),
        ("step won", 1),
        ("now the forth step", 4),
        ("here begins the first part", "first"),
        ("and with that we come to the final step", "last"),
    ],
)
def test_a_step_that_is_counted_is_no_mere_next(text: str, which: int | str) -> None:
    book = phrasebook()
    hearing = Hearing(book, Listening(stage="demonstration"))
    found = counted_cue(words_of(text, book.contractions), hearing)
    assert found is not None
    assert [act_to_json(act) for act in found.acts] == [{"act": "cue", "which": which}]


@pytest.mark.parametrize("text", ["the second cup is full now", "then I lift the cup", "next step"])
def test_what_counts_no_step_is_no_counted_cue(text: str) -> None:
    (act,) = heard_as(text, stage="demonstration")
    assert act.get("which") in (None, "next")
