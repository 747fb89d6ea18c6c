from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.language.amounts import read_amount
from assistant.language.phrasebook import phrasebook
from tests.language.heard_as import heard_as


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("gosh, that was further than I wanted", {"change": "less"}),
        ("you went overboard there", {"change": "less"}),
        ("that was a tad more than I asked for", {"change": "less", "degree": "little"}),
        ("too little, give it more", {"change": "more"}),
        ("that barely moved", {"change": "more"}),
        ("the correction was too weak", {"change": "more"}),
        ("half as much again", {"factor": 1.5}),
        ("two and a half times that", {"factor": 2.5}),
        ("twenty percent more of it", {"factor": 1.2}),
        ("do two thirds of it", {"factor": 2 / 3}),
    ],
)
def test_the_last_correction_is_changed(text: str, told: dict[str, Any]) -> None:
    (act,) = heard_as(text)
    assert act == pytest.approx({"act": "adjust_last", **told})


@settings(deadline=None, max_examples=25)
@given(st.integers(1, 99))
def test_a_share_less_and_a_share_more_make_two(share: int) -> None:
    book = phrasebook()
    less = read_amount(f"{share} percent less".split(), book)
    more = read_amount(f"{share} percent more".split(), book)
    assert less is not None
    assert more is not None
    assert (less.act.factor or 0) + (more.act.factor or 0) == pytest.approx(2.0)


@pytest.mark.parametrize("text", ["left a bit more", "faster", "turn it less", "more to the back"])
def test_where_a_way_or_a_pace_is_told_it_is_no_amount(text: str) -> None:
    assert read_amount(text.split(), phrasebook()) is None
