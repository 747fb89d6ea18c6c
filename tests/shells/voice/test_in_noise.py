"""All that speaks for words counts, none of them may have been said, and doubt is asked about."""

from __future__ import annotations

from dataclasses import astuple, replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Inform, Stop, TeacherAct, Translate
from assistant.shells.voice.deciding import SURE, is_sure, is_unknown
from assistant.shells.voice.in_noise import (
    ALONE_SURE_SHARE,
    SURE_SHARE,
    WEIGHTS,
    Evidence,
    Evident,
    logs,
    settled,
)
from assistant.shells.voice.recognized import Recognized
from tests.shells.voice.reading import PRACTICE

pytestmark = pytest.mark.voice

TEXTS = ("move left", "go up", "open the hand", "some apples", "stop", "faster please")


def evidence(text: str, explained: float = 0.0, listening: Listening = PRACTICE) -> Evidence:
    return Evidence(text, understand(text, listening), explained, worded=-8.0)


def read_by_both(text: str) -> Evidence:
    return replace(evidence(text), read=-0.2, reread=-0.5, first=True)


@settings(deadline=None)
@given(st.lists(st.sampled_from(TEXTS), min_size=1, unique=True), st.floats(-30.0, 0.0))
def test_shares_sum_to_one_with_that_of_what_nobody_thought_of(
    texts: list[str], explained: float
) -> None:
    told = Evident([evidence(text, explained) for text in texts], doubt=-1.0, unread=-0.5)
    shares = told.shares()
    assert len(shares) == len(texts) + 1
    assert sum(shares) == pytest.approx(1.0)
    assert {len(row) for row in told.features()} == {len(astuple(WEIGHTS))}


LEFT, UP = evidence("move left", -4.0), evidence("go up", -4.0)


@pytest.mark.parametrize(
    "likelier",
    [
        replace(LEFT, explained=0.0),
        replace(LEFT, worded=-4.0),
        replace(LEFT, read=-0.1),
        replace(LEFT, reread=-0.1),
        replace(LEFT, first=True),
        replace(LEFT, expected=True),
    ],
)
def test_what_speaks_for_words_makes_them_likelier(likelier: Evidence) -> None:
    assert Evident((likelier, UP)).shares()[0] > Evident((LEFT, UP)).shares()[0]


@pytest.mark.parametrize("unlikelier", [replace(LEFT, pace=3.0), replace(LEFT, rare=True)])
def test_what_speaks_against_words_makes_them_less_likely(unlikelier: Evidence) -> None:
    assert Evident((unlikelier, UP)).shares()[0] < Evident((LEFT, UP)).shares()[0]


def test_the_less_sure_everything_is_the_likelier_something_else_was_said() -> None:
    told = [Evident((evidence("move left"),), doubt, unread).shares()[-1]
            for doubt, unread in ((-0.2, -0.1), (-2.0, -0.1), (-2.0, -2.0))]  # fmt: skip
    assert told == sorted(told)


def test_what_both_recognizers_read_is_acted_on() -> None:
    one = settled(Evident((read_by_both("move left"), evidence("go up", -9.0)), -0.3, -0.2))
    assert one.understanding.acts == (Translate("left"),)
    assert is_sure(one)


def test_two_likely_meanings_are_asked_about() -> None:
    left = replace(read_by_both("move left"), explained=-4.0)
    told = (left, replace(read_by_both("move right"), first=False))
    one = settled(Evident(told, -0.3, -0.2))
    assert one.understanding.acts == (Translate("left"),)
    assert not is_sure(one)


def test_what_means_the_same_votes_together() -> None:
    told = (read_by_both("move left"), replace(read_by_both("go left"), first=False))
    assert is_sure(settled(Evident(told, -0.3, -0.2)))


def test_what_explains_nothing_well_is_nothing() -> None:
    told = Evident([evidence(text, -3.0) for text in TEXTS], doubt=-3.0, unread=-6.0)
    assert is_unknown(settled(told).understanding)


def test_chat_that_was_read_well_is_nothing() -> None:
    told = Evident((read_by_both("some apples on the table"), evidence("stop", -9.0)), -0.2, -0.1)
    assert is_unknown(settled(told).understanding)


@pytest.mark.parametrize(("text", "act"), [("stop", Stop()), ("left", Translate("left"))])
def test_a_word_alone_must_be_likelier(text: str, act: TeacherAct) -> None:
    alone = replace(read_by_both(text), explained=-9.0, expected=True)
    rival = replace(read_by_both("undo it"), first=False)
    told = Evident((alone, rival), -0.3, -0.2)
    share = told.shares()[0]
    assert SURE_SHARE < share < ALONE_SURE_SHARE
    one = settled(told)
    assert one.understanding.acts == (act,)
    assert not is_sure(one)
    assert one.sure < SURE


def test_a_number_nobody_would_expect_is_asked_about() -> None:
    where = Listening(stage="introduction", asked="subtask_count")
    for text, value, sure in (("three", 3, True), ("twelve", 12, False)):
        one = settled(Evident((replace(read_by_both(text), meant=understand(text, where)),)))
        assert one.understanding.acts == (Inform(value),)
        assert is_sure(one) == sure


def test_readings_keep_their_order() -> None:
    told = logs((Recognized("go", 0.5), Recognized("no", 0.25)))
    assert list(told) == ["go", "no"]
    assert told["go"] > told["no"]
