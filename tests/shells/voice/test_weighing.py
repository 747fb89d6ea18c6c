"""Shares of candidates: they sum to one, and the sound, the place and the length decide."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.shells.voice.weighing import GAIN, gain, length_penalty, weighed

pytestmark = pytest.mark.voice

WORDS = ("stop", "start", "go", "left", "right", "the other way", "slower")
LIKELIHOODS = st.dictionaries(st.sampled_from(WORDS), st.floats(-60.0, 0.0), min_size=1, max_size=5)


@settings(deadline=None)
@given(LIKELIHOODS, st.floats(0.1, 5.0))
def test_shares_sum_to_one_and_are_ranked(told: dict[str, float], speech_s: float) -> None:
    found = weighed(told, speech_s)
    shares = [one.share for one in found]
    assert sum(shares) == pytest.approx(1.0)
    assert shares == sorted(shares, reverse=True)
    assert {one.text: one.fit for one in found} == told


@settings(deadline=None)
@given(LIKELIHOODS, st.floats(0.1, 5.0), st.sampled_from(WORDS))
def test_what_is_expected_or_agreed_never_loses(
    told: dict[str, float], speech_s: float, word: str
) -> None:
    def share(expected: dict[str, float], agreed: tuple[str, ...]) -> float:
        found = weighed(told, speech_s, expected=expected, agreed=agreed)
        return sum(one.share for one in found if one.text == word)

    assert share({word: -10.0}, ()) >= share({}, ()) - 1e-12
    assert share({}, (word,)) >= share({}, ()) - 1e-12


def test_a_rare_word_gains_more_where_it_is_expected() -> None:
    assert GAIN[0] <= gain(-3.0) <= gain(-8.0) <= gain(-12.0) <= gain(-50.0) <= GAIN[1]


def test_the_sound_decides_between_words_of_one_length() -> None:
    found = weighed({"stop": -2.2, "start": -9.1}, 0.5)
    assert found[0].text == "stop"
    assert found[0].share > 0.9


def test_one_word_is_a_poor_account_of_a_sentence() -> None:
    told = {"yes": -1.9, "yes you can start": -2.6}
    assert weighed(told, 1.5)[0].text == "yes you can start"
    assert weighed(told, 0.35)[0].text == "yes"


def test_a_usual_pace_costs_nothing() -> None:
    assert length_penalty("stop", 4 * 0.085) == pytest.approx(0.0)
    assert length_penalty("move a little to the left", 0.3) > 4.0
