"""Cuts called by number, time or neighbors are the ones moved, by what was said."""

from __future__ import annotations

import pytest

from assistant.dialogue import effects as fx
from assistant.language.hints import hints
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import STEPS, Lessons

CUTS = (2.0, 4.0, 6.0, 8.0)
FIRST = acts.MoveCut(STEPS[0], direction="later")


def cuts_after(text: str, *meant: acts.TeacherAct) -> tuple[float, ...]:
    teacher = Lessons().learned().hear(*(meant or (acts.Unknown(),)), text=text)
    learned = [one for one in teacher.effects if isinstance(one, fx.Learn)]
    return learned[0].cuts_s or () if learned else CUTS


@pytest.mark.parametrize(
    ("text", "cuts"),
    [
        ("move the second cut half a second later", (2.0, 4.5, 6.0, 8.0)),
        ("the third cut is 0.3 s too late", (2.0, 4.0, 5.7, 8.0)),
        ("move cut number two to 3.2", (2.0, 3.2, 6.0, 8.0)),
        ("the last cut a second earlier", (2.0, 4.0, 6.0, 7.0)),
        ("the first cut comes two seconds too early", CUTS),
        ("the cut at 6 s should be at 6.5", (2.0, 4.0, 6.5, 8.0)),
        ("move the cut between grasp object and move up object later", (2.0, 4.5, 6.0, 8.0)),
        ("the cut at 7 s should be at 6.5", CUTS),
        ("why did you cut there?", CUTS),
        ("the second step comes later", CUTS),
    ],
)
def test_the_cut_that_is_told_moves_as_told(text: str, cuts: tuple[float, ...]) -> None:
    # What the understanding makes of it is another cut.
    assert cuts_after(text) == pytest.approx(cuts)
    if "cut" in text and "why" not in text and cuts != CUTS:
        assert cuts_after(text, FIRST) == pytest.approx(cuts)


def test_the_amount_counts_where_a_step_is_named() -> None:
    told = acts.MoveCut("move up object", direction="earlier")
    text = "move up object ends a second earlier"
    assert cuts_after(text, told) == pytest.approx((2.0, 4.0, 5.0, 8.0))
    assert cuts_after("move up object ends earlier", told) == pytest.approx((2.0, 4.0, 5.5, 8.0))


def test_a_cut_that_is_not_there_is_told() -> None:
    teacher = Lessons().learned().hear(acts.Unknown(), text="move cut 9 half a second later")
    assert teacher.topics[0] == "error.no_cut_number"
    teacher.hear(acts.Unknown(), text="the second cut ten seconds later")
    assert teacher.topics[0] == "error.cut_outside"


@pytest.mark.parametrize("language", ["english", "german"])
def test_the_words_of_both_ways_are_apart(language: str) -> None:
    assert not set(hints("later", language)) & set(hints("earlier", language))
