"""Misspelled words of names are read as the words they are nearest to."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.language.actions import read_action
from assistant.language.slips import stands, without_slips
from assistant.model.task import TaskObject

THINGS = (TaskObject("block", "object"), TaskObject("target", "target"))


@pytest.mark.parametrize(
    ("text", "way", "thing"),
    [
        ("aproach the blok", "approach", "block"),
        ("raech for the block", "approach", "block"),
        ("graps the block", "close", "block"),
        ("relase it at the traget", "open", "target"),
    ],
)
def test_an_action_is_read_without_slips(text: str, way: str, thing: str) -> None:
    action = read_action(text, THINGS).action
    assert action is not None
    assert (action.way, action.object) == (way, thing)


@pytest.mark.parametrize("text", ["the lid and the tray", "pour the water", "two cups"])
def test_words_that_are_words_stay(text: str) -> None:
    assert without_slips(text, ("block", "target")) == text


@given(st.text(max_size=40))
@settings(max_examples=50, deadline=None)
def test_anything_else_stays_as_long(text: str) -> None:
    assert without_slips("1 2 3 " + text).startswith("1 2 3 ")


def test_where_someone_stands_survives_a_slip() -> None:
    assert stands("besid you") == "beside"
    assert stands("i am facng you") == "facing"
    assert stands("slower") == ""
