import pytest

from assistant.language.phrasebook import phrasebook
from assistant.language.words import words_of


def texts(line: str) -> list[str]:
    return [word.text for word in words_of(line, phrasebook().contractions)]


def test_a_sign_between_things_joins_them_and_before_a_number_it_is_its_sign() -> None:
    assert texts("header + board + screws") == ["header", "and", "board", "and", "screws"]
    assert texts("x +5") == ["x", "+5"]


def test_a_number_and_a_name_are_said_to_be_one_and_a_coordinate_is_only_marked() -> None:
    assert texts("episode 4 = lift") == ["episode", "4", "is", "lift"]
    marked = words_of("x = 5, y = 20", phrasebook().contractions)
    assert [word.text for word in marked] == ["x", "5", "y", "20"]
    assert all(word.broken for word in marked[1:])


@pytest.mark.parametrize(("line", "first"), [("why's that", "why"), ("when's lunch", "when")])
def test_words_that_ask_are_spelled_out(line: str, first: str) -> None:
    assert texts(line)[:2] == [first, "is"]
