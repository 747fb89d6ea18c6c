"""Answers to open questions: what names a thing is told from what only leads to it."""

from __future__ import annotations

import pytest

from assistant.language.hints import hints
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Asked, Inform


def _answer(text: str, asked: Asked) -> object:
    (act,) = understand(text, Listening(stage="introduction", asked=asked)).acts
    assert isinstance(act, Inform), act
    return act.value


@pytest.mark.parametrize(
    "text",
    [
        "the one I have in mind is the ladle",
        "the ladle is the one I was after",
        "I'm on about the ladle",
        "we were talking about the ladle",
        "the ladle, not the bowl",
        "ladle rather than bowl",
        "the answer to that is the ladle",
        "the small one, the ladle",
        "the ladle, that's the one",
    ],
)
def test_either_side_of_is_may_name_the_thing(text: str) -> None:
    assert str(_answer(text, "which")).removeprefix("the ") == "ladle"


@pytest.mark.parametrize(
    "text",
    [
        "what you left out is rinsing",
        "rinsing is what you left out",
        "you clean overlooked the rinsing",
        "the rinsing got lost",
        "rinsing step has gone missing",
        "rinsing, you skipped rinsing",
        "the one not on your list is rinsing",
        "there was no rinsing",
    ],
)
def test_what_was_left_out_is_named(text: str) -> None:
    assert str(_answer(text, "missing_step")).removeprefix("the ") == "rinsing"


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("pot lid ladle", ("pot", "lid", "ladle")),
        ("green cup yellow cup and the tray", ("green cup", "yellow cup", "tray")),
        ("a pot a lid a ladle", ("pot", "lid", "ladle")),
        ("two jars, a small jar and a tall jar", ("small jar", "tall jar")),
        ("a jar, a lid, and the shelf it goes on", ("jar", "lid", "shelf")),
        ("you will be using a jar, you will be using a lid", ("jar", "lid")),
        ("the equipment includes a jar and a lid", ("jar", "lid")),
        ("mixing bowl and whisk", ("mixing bowl", "whisk")),
        ("the tool box and a bottle rack", ("tool box", "bottle rack")),
    ],
)
def test_lists_of_things_are_taken_apart(text: str, value: tuple[str, ...]) -> None:
    assert _answer(text, "objects") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("reach then grab then lift", ("reach", "grab", "lift")),
        ("first reach, then grab, and finally lift up", ("reach", "grab", "lift up")),
        ("the steps are reach over and then lift up", ("reach over", "lift up")),
        ("pick and place", "pick and place"),
        ("reaching, as I said", "reaching"),
        ("then comes reaching", "reaching"),
    ],
)
def test_steps_told_one_after_the_other_are_a_list(text: str, value: object) -> None:
    assert _answer(text, "subtask_name") == value


@pytest.mark.parametrize(
    "text",
    [
        "in the end the cups stand on the shelf",
        "when it is all over, the purpose of the thing is that the cups stand on the shelf",
        "the cups stand on the shelf, simple as that",
    ],
)
def test_a_goal_is_a_whole_sentence(text: str) -> None:
    assert _answer(text, "goal") == "the cups stand on the shelf"


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("it is the ladle I was asking about", "ladle"),
        ("was the ladle that went missing", "ladle"),
    ],
)
def test_a_thing_may_be_set_off(text: str, value: str) -> None:
    assert str(_answer(text, "missing_step")).removeprefix("the ") == value


def test_counting_up_ends_with_how_many() -> None:
    assert _answer("one, two, three, four, that makes four", "subtask_count") == 4
    assert _answer("one two three... three!", "subtask_count") == 3


@pytest.mark.parametrize("text", ["and", "also and", "next", "and then"])
@pytest.mark.parametrize("asked", ["objects", "actions"])
def test_joining_words_alone_are_no_list(text: str, asked: Asked) -> None:
    meant = understand(text, Listening(stage="introduction", asked=asked))
    assert meant.confidence < 0.85


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("by the end the cup is three quarters full", "the cup is three quarters full"),
        ("the end game is every cap sits in the tray", "every cap sits in the tray"),
        ("once it's all done the fork lies left of the plate", "the fork lies left of the plate"),
    ],
)
def test_what_leads_to_a_goal_is_none_of_it(text: str, value: str) -> None:
    assert _answer(text, "goal") == value


@pytest.mark.parametrize("text", ["four, nah hold on, five", "three, no hold on, five steps"])
def test_of_a_count_taken_back_the_later_holds(text: str) -> None:
    assert _answer(text, "subtask_count") == 5


@pytest.mark.parametrize("language", ["english", "german"])
def test_that_there_is_no_goal_is_understood_in_the_words_the_robot_offers(language: str) -> None:
    asked = Listening("introduction", "goal", task="stacking")
    for words in hints("nothing", language):
        told = understand(words, asked, language)
        assert told.confidence >= 0.85
        (act,) = told.acts
        assert isinstance(act, Inform)
        assert act.value in hints("nothing", language)
