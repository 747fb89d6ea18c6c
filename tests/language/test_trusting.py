from typing import Any

import pytest

from assistant.language.parsing import Hearing, Parse
from assistant.language.phrasebook import phrasebook
from assistant.language.trusting import (
    chatting,
    consenting,
    is_nameless,
    names_step,
    only_part,
    strange,
    trusted_from,
    unheard,
    wondered,
)
from assistant.language.understanding import understand
from assistant.language.words import words_of
from assistant.model.listening import Listening
from assistant.model.teacher_acts import (
    Affirm,
    Assign,
    Deny,
    Explain,
    Inform,
    Optional,
    Rename,
    Save,
    Translate,
    Unknown,
    Where,
)


def hearing(**where: Any) -> Hearing:
    return Hearing(phrasebook(), Listening(**{"stage": "practice", **where}))


def test_a_name_the_lesson_knows_is_trusted_and_another_is_doubted() -> None:
    near = hearing(subtasks=("wind coil",))
    known, other = (Parse((Optional(name),), 0.9) for name in ("wind coil", "cut wire"))
    assert trusted_from(known, near) < trusted_from(other, near)
    assert names_step(known.acts, near)
    assert not names_step(other.acts, near)


def test_a_step_is_named_in_a_list_and_in_where_a_correction_belongs() -> None:
    near = hearing(subtasks=("wind coil",))
    moved = Translate("left", where=Where("wind coil", "during"))
    assert names_step((moved,), near)
    assert names_step((Rename("wind coil", "coil up"),), near)


def test_counts_are_trusted_before_names_and_nothing_is_taken_as_told() -> None:
    near = hearing(asked="subtask_count", stage="introduction")
    told = [trusted_from(Parse((one,), 0.9), near) for one in (Unknown(), Inform(4), Inform("lid"))]
    assert told == sorted(told)


@pytest.mark.parametrize(
    ("asked", "rival", "alike"),
    [("ready", "start", True), ("satisfied", "start", False), ("satisfied", "approve", True)],
)
def test_rivals_that_say_the_same_leave_no_doubt(asked: Any, rival: str, alike: bool) -> None:
    chances = {rival: 0.6, "affirm": 0.4}
    assert consenting(Parse((Affirm(),), 0.9), chances, hearing(asked=asked)) is alike


def test_words_in_no_list_are_strange_unless_they_name_a_step() -> None:
    near = hearing()
    words = words_of("left a pochino", near.book.contractions)
    assert strange((Translate("left"),), words, near)
    assert not strange((Translate("left", where=Where("a pochino", "during")),), words, near)


def test_talk_of_other_matters_is_known_by_its_words() -> None:
    near = hearing()
    assert chatting(words_of("my sister has the flu", near.book.contractions), near)
    assert not chatting(words_of("a bit more left", near.book.contractions), near)


def test_a_question_of_why_asks_for_nothing_to_be_done() -> None:
    near = hearing(stage="learning")
    parse = Parse((Assign(3, "insert"),), 0.9)
    words = words_of("why's episode 3 mapped to insert", near.book.contractions)
    (act,) = wondered(parse, words, near).acts
    assert isinstance(act, Explain)
    other = words_of("episode 3 is mapped to insert", near.book.contractions)
    assert wondered(parse, other, near) is parse


def test_a_part_of_what_is_explained_whole_is_no_other_reading() -> None:
    left, up = Translate("left", distance_m=0.02), Translate("up", distance_m=0.01)
    whole = Parse((left, up), 0.95, "motion")
    assert only_part((left,), whole)
    assert not only_part((left, up), whole)
    assert not only_part((Translate("down"),), whole)
    assert not only_part((left,), Parse((left, up), 0.7, "partly"))


def test_saving_without_a_name_tells_none() -> None:
    assert not is_nameless((Save("lamp"),))
    assert is_nameless((Save(),))
    assert understand("save", Listening("practice")).confidence >= 0.85


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("no dear, half of it went on the carpet", Deny()),
        ("no, my spaniel chewed the ribbon", Deny()),
        ("my spaniel chewed the ribbon", Unknown()),
    ],
)
def test_a_no_that_was_asked_for_is_heard_beside_words_nobody_listed(
    text: str, act: Deny | Unknown
) -> None:
    asked = Listening(stage="practice", asked="satisfied")
    assert understand(text, asked).acts == (act,)


def test_words_nobody_listed_tell_no_yes_that_nobody_asked_for() -> None:
    words = words_of("my spaniel", phrasebook().contractions)
    assert unheard((Deny(),), words, hearing())
    assert unheard((Deny(),), words, hearing(asked="goal"))
    assert unheard((Affirm(),), words, hearing(asked="satisfied"))
    # Only a no at the beginning or end tells one, whatever stands beside it.
    assert unheard((Deny(),), words, hearing(asked="satisfied"))
    told = words_of("no my spaniel", phrasebook().contractions)
    assert not unheard((Deny(),), told, hearing(asked="satisfied"))


@pytest.mark.parametrize("text", ["go right", "move down", "move up", "go left", "a bit lower"])
def test_a_motion_told_in_few_words_is_sure(text: str) -> None:
    meant = understand(text, Listening(stage="practice"))
    assert isinstance(meant.acts[0], Translate)
    assert meant.confidence >= 0.85
