"""A problem is one message on one line, whatever it is about."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from assistant.errors import BadInput, Problem

WORDS = st.text(min_size=1, max_size=20)


@given(st.lists(st.builds(Problem, WORDS, WORDS, WORDS), min_size=1, max_size=3))
def test_every_problem_is_one_line(problems: list[Problem]) -> None:
    assert len(str(BadInput(problems)).splitlines()) == len(problems)


def test_signs_that_move_the_cursor_are_spelled() -> None:
    told = str(Problem("a\nb.yaml:3", "name '\x1b[2J'", "größer"))
    assert told == r"a\nb.yaml:3: name '\x1b[2J'; größer"
