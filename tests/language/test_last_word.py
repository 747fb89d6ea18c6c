from typing import Any, cast

import pytest

from assistant.language.last_word import uncontradicted
from assistant.language.parsing import Hearing
from assistant.language.phrasebook import phrasebook
from assistant.language.understanding import understand
from assistant.language.words import words_of
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Asked, TeacherAct, Translate, act_to_json


def acts(text: str, asked: str | None = None) -> list[dict[str, Any]]:
    where = Listening(stage="practice", asked=cast("Asked | None", asked))
    return [act_to_json(act) for act in understand(text, where).acts]


def kept(text: str, *told: TeacherAct) -> tuple[TeacherAct, ...]:
    book = phrasebook()
    hearing = Hearing(book, Listening(stage="practice"))
    return uncontradicted(told, words_of(text, book.contractions), hearing)


@pytest.mark.parametrize(
    ("text", "first"),
    [
        ("right, er, left rather", Translate("right")),
        ("a touch right, no, I am confused, left", Translate("right", "little")),
        ("right, hmm, left", Translate("right")),
    ],
)
def test_of_a_way_and_its_opposite_the_last_holds(text: str, first: TeacherAct) -> None:
    assert kept(text, first, Translate("left")) == (Translate("left"),)


@pytest.mark.parametrize("text", ["left 2 cm, right 1 cm", "left then right", "left, and right"])
def test_two_ways_that_are_told_in_full_or_in_turn_are_both_meant(text: str) -> None:
    both = Translate("left", distance_m=0.02), Translate("right", distance_m=0.01)
    assert kept(text, *both) == both


@pytest.mark.parametrize(
    ("text", "act"), [("yes, no, sorry, no", "deny"), ("no, wait, yes", "affirm")]
)
def test_the_last_of_yes_and_no_holds(text: str, act: str) -> None:
    assert acts(text, "satisfied") == [{"act": act}]


@pytest.mark.parametrize(
    ("text", "direction"), [("go up", "up"), ("move right", "right"), ("turn right", "right")]
)
def test_a_motion_where_a_start_was_asked_for_is_a_motion(text: str, direction: str) -> None:
    where = Listening(stage="practice", asked="ready")
    meant = understand(text, where)
    (act,) = (act_to_json(one) for one in meant.acts)
    assert act["direction"] == direction
    assert meant.confidence >= 0.85


@pytest.mark.parametrize("text", ["go", "go ahead", "up we go", "right, off you go", "go on"])
def test_words_for_beginning_are_a_start(text: str) -> None:
    assert acts(text, "ready") in ([{"act": "start"}], [{"act": "affirm"}])


@pytest.mark.parametrize("text", ["put the block down 2 cm higher", "set it down 2 cm higher"])
def test_how_a_thing_is_put_is_no_way_it_goes(text: str) -> None:
    assert acts(text) == [{"act": "translate", "direction": "up", "distance_m": 0.02}]


def test_two_ways_of_which_nothing_is_told_are_both_kept() -> None:
    both = Translate("up"), Translate("down")
    assert kept("up down", *both) == both


@pytest.mark.parametrize(
    ("text", "asked"),
    [
        ("no no. the plan is right", "confirm_tree"),
        ("no, no, it's all good", "satisfied"),
        ("nope, perfect as it is", "satisfied"),
    ],
)
def test_a_no_that_waves_a_doubt_away_is_a_yes_that_is_read_back(text: str, asked: str) -> None:
    where = Listening(stage="practice", asked=cast("Asked", asked))
    told = understand(text, where)
    assert [act_to_json(act) for act in told.acts] == [{"act": "affirm"}]
    assert told.confidence < 0.85


@pytest.mark.parametrize("text", ["no, it is not good", "no, no, it is wrong", "no"])
def test_a_no_to_what_is_wrong_stays_one(text: str) -> None:
    assert acts(text, "satisfied") == [{"act": "deny"}]
