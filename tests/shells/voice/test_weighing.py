"""Shares of candidates: with what nobody thought of they sum to one; the sound, the place, what
was read and the length decide."""

from __future__ import annotations

from dataclasses import astuple, replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.shells.voice.weighing import (
    COMMANDS,
    GAIN,
    NAMES,
    QUIET,
    Evidence,
    Weights,
    gain,
    length_penalty,
    nothing_of_these,
    weighed,
)

pytestmark = pytest.mark.voice

WORDS = ("stop", "start", "go", "left", "right", "the other way", "slower")
LIKELIHOODS = st.dictionaries(st.sampled_from(WORDS), st.floats(-60.0, 0.0), min_size=1, max_size=5)
WEIGHTS = st.sampled_from((COMMANDS, QUIET, NAMES))


def evidence(likely: dict[str, float]) -> dict[str, Evidence]:
    return {text: Evidence(text, fit) for text, fit in likely.items()}


@settings(deadline=None)
@given(LIKELIHOODS, st.floats(0.1, 5.0), WEIGHTS, st.floats(0.0, 4.0))
def test_shares_sum_to_no_more_than_one_and_are_ranked(
    likely: dict[str, float], speech_s: float, weights: Weights, doubt: float
) -> None:
    found = weighed(evidence(likely), speech_s, weights, doubt)
    shares = [one.share for one in found]
    assert sum(shares) <= 1.0 + 1e-9
    assert shares == sorted(shares, reverse=True)
    assert {one.text: one.fit for one in found} == likely


@settings(deadline=None)
@given(LIKELIHOODS, st.floats(0.1, 5.0))
def test_where_the_sound_is_clear_something_thought_of_was_said(
    likely: dict[str, float], speech_s: float
) -> None:
    near = {text: max(fit, -20.0) for text, fit in likely.items()}
    assert sum(one.share for one in weighed(evidence(near), 1.0, QUIET)) == pytest.approx(1.0)


@settings(deadline=None)
@given(LIKELIHOODS, st.floats(0.1, 5.0), st.sampled_from(WORDS), WEIGHTS)
def test_what_was_read_means_something_or_sounds_alike_never_loses(
    likely: dict[str, float], speech_s: float, word: str, weights: Weights
) -> None:
    bare = Evidence(word, -5.0)

    def share(one: Evidence) -> float:
        told = evidence(likely) | {word: one}
        return sum(one.share for one in weighed(told, speech_s, weights) if one.text == word)

    plain = share(bare) - 1e-12
    assert share(replace(bare, agreed=True)) >= plain
    assert share(replace(bare, meant=True)) >= plain
    assert share(replace(bare, alike=1.0)) >= plain
    assert share(replace(bare, alike_elsewhere=1.0)) >= plain
    assert share(replace(bare, before=-10.0)) >= plain
    assert share(replace(bare, read=0.0)) >= share(replace(bare, read=-3.0)) - 1e-12
    assert share(replace(bare, rare=True)) <= plain + 2e-12


@settings(deadline=None)
@given(LIKELIHOODS, st.floats(0.1, 5.0))
def test_what_a_recognizer_doubts_may_be_something_else(
    likely: dict[str, float], speech_s: float
) -> None:
    sure, doubtful = (
        sum(one.share for one in weighed(evidence(likely), speech_s, COMMANDS, doubt))
        for doubt in (0.1, 2.0)
    )
    assert doubtful <= sure


def test_every_weight_has_its_feature() -> None:
    words = Evidence("go", -1.0, worded=-3.0)
    assert len(words.features(0.5)) == len(nothing_of_these(1.0)) == len(astuple(COMMANDS))


def test_a_rare_word_gains_more_where_it_is_expected() -> None:
    assert GAIN[0] <= gain(-3.0) <= gain(-8.0) <= gain(-12.0) <= gain(-50.0) <= GAIN[1]


def test_the_sound_decides_between_words_of_one_length() -> None:
    found = weighed(evidence({"stop": -2.2, "start": -9.1}), 0.5, QUIET)
    assert found[0].text == "stop"
    assert found[0].share > 0.9


def test_one_word_is_a_poor_account_of_a_sentence() -> None:
    told = evidence({"yes": -1.9, "yes you can start": -2.6})
    assert weighed(told, 1.5, QUIET)[0].text == "yes you can start"
    assert weighed(told, 0.35, QUIET)[0].text == "yes"


def test_a_usual_pace_costs_nothing() -> None:
    assert length_penalty("stop", 4 * 0.085) == pytest.approx(0.0)
    assert length_penalty("move a little to the left", 0.3) > 4.0
