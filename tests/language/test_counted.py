from typing import Any, cast

import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Asked, act_to_json


def values(text: str, asked: str) -> list[Any]:
    where = Listening(stage="introduction", asked=cast("Asked", asked))
    pages = [act_to_json(act) for act in understand(text, where).acts]
    return [page.get("value", page["act"]) for page in pages]


@pytest.mark.parametrize(
    ("text", "count", "names"),
    [
        ("three steps: reach, hold and carry", 3, ["reach", "hold", "carry"]),
        ("2. take it, put it down", 2, ["take it", "put it down"]),
        ("four bits in all, namely open, fill, close and shake", 4,
         ["open", "fill", "close", "shake"]),
        ("3 steps grab swing and put down", 3, ["grab", "swing", "put down"]),
    ],
)  # fmt: skip
def test_a_count_with_just_as_many_names_tells_both(
    text: str, count: int, names: list[str]
) -> None:
    assert values(text, "subtask_count") == [count, names]


@pytest.mark.parametrize(
    "text",
    ["four, if I count right", "two steps, no more and no less", "three, give or take none",
     "five: one, two, three, four, five", "two steps in total it has", "three, yes"],
)  # fmt: skip
def test_talk_behind_a_count_names_no_steps(text: str) -> None:
    (value,) = values(text, "subtask_count")
    assert isinstance(value, int)


def test_a_name_a_count_and_a_list_are_told_in_one_line() -> None:
    assert values("piling up, two steps, lift and drop", "task_name") == [
        *("piling up", 2),
        ["lift", "drop"],
    ]
    assert values("lift and drop", "task_name") == ["lift and drop"]


@pytest.mark.parametrize("text", ["two", "three things", "7"])
def test_a_number_alone_names_no_thing(text: str) -> None:
    assert values(text, "objects") == ["unknown"]


def test_counted_things_are_named() -> None:
    assert values("a cup and two spoons", "objects") != ["unknown"]


def test_steps_listed_where_their_number_was_asked_for_are_the_answer() -> None:
    told = values("pick it up, carry it over, put it down", "subtask_count")
    assert told == [["pick it up", "carry it over", "put it down"]]
    assert values("well, you know, it depends, really", "subtask_count") == ["unknown"]
