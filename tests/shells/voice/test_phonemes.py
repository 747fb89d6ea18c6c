"""Phrases are compared by sound: misheard words come near, other words do not."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.shells.voice.phonemes import distance, nearest, phonemes

pytestmark = pytest.mark.voice
words = st.lists(st.sampled_from(["S", "T", "AA", "P", "M", "UW", "V"]), min_size=1, max_size=6)


@given(words, words)
def test_distance_is_a_fraction_and_symmetric(first: list[str], second: list[str]) -> None:
    assert 0.0 <= distance(first, second) <= 1.0
    assert distance(first, second) == pytest.approx(distance(second, first))
    assert (distance(first, second) == 0.0) == (first == second)


@pytest.mark.parametrize(
    ("heard", "meant"),
    [
        ("big up object", "pick up object"),
        ("it's called big and please", "it's called pick and place"),
        ("clothes the hand", "close the hand"),
        ("lift", "left"),
    ],
)
def test_misheard_words_come_near(heard: str, meant: str) -> None:
    others = ("open the hand", "what did you say", "undo that", "go back to the introduction")
    assert nearest(heard, (*others, meant))[0] == meant


def test_other_words_stay_far() -> None:
    phrases = ("move left", "slower", "open the hand", "stop")
    assert nearest("my sister lives in the mountains", phrases)[1] > 0.5


def test_unknown_words_are_spelled() -> None:
    assert phonemes("blorf") == ("B", "L", "AA", "R", "F")
