import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.language.phrasebook import phrasebook


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("two and a half centimetres", "m", 0.025),
        ("half an inch", "m", 0.0127),
        ("an inch and a half", "m", 0.0381),
        ("three quarters of an inch", "m", 0.01905),
        ("a couple of millimetres", "m", 0.002),
        ("twenty five mm", "m", 0.025),
        ("a hundred and ten mm", "m", 0.11),
        ("point five cm", "m", 0.005),
        ("a quarter turn", "deg", 90.0),
        ("half a turn", "deg", 180.0),
        ("a full turn", "deg", 360.0),
        ("15 degrees", "deg", 15.0),
        ("20 percent", "ratio", 0.2),
        ("minus 248.6", "", -248.6),
        ("half a dozen", "", 6.0),
        ("one centimetre and half", "m", 0.015),
        ("an inch and three quarters", "m", 0.04445),
        ("1 0.5 inches", "m", 0.0381),
    ],
)
def test_quantities_in_words(text: str, kind: str, value: float) -> None:
    words = text.split()
    found = phrasebook().numbers.quantity(words, 0)
    assert found is not None
    assert (found.kind, found.end) == (kind, len(words))
    assert found.value == pytest.approx(value)


@given(st.integers(0, 999))
def test_digits_and_words_agree(number: int) -> None:
    numbers = phrasebook().numbers
    ones = {value: word for word, value in numbers.ones.items()}
    tens = {value: word for word, value in numbers.tens.items()}
    hundreds, rest = divmod(number, 100)
    words = [ones[hundreds], "hundred"] if hundreds else []
    if rest and rest < 20:
        words.append(ones[rest])
    elif rest:
        words += [tens[rest - rest % 10], *([ones[rest % 10]] if rest % 10 else [])]
    words = words or ["zero"]
    assert numbers.number(words, 0) == (float(number), len(words))
    assert numbers.number([str(number)], 0) == (float(number), 1)


@pytest.mark.parametrize("text", ["two cm and half the speed", "one inch and a third of that"])
def test_half_of_something_else_is_no_part_of_a_measure(text: str) -> None:
    found = phrasebook().numbers.quantity(text.split(), 0)
    assert found is not None
    assert found.end == 2


@given(st.lists(st.integers(0, 9), min_size=2, max_size=4))
def test_digits_said_one_by_one_make_a_number(digits: list[int]) -> None:
    numbers = phrasebook().numbers
    ones = {value: word for word, value in numbers.ones.items()}
    told = [ones[digit] for digit in digits]
    assert numbers.listed(told) == float("".join(map(str, digits)))
    assert numbers.listed(["minus", *told]) == -float("".join(map(str, digits)))


def test_hundreds_in_a_row_are_numbers_of_their_own() -> None:
    words = ["four", "hundred", "one", "hundred", "seventy", "two", "hundred"]
    numbers = phrasebook().numbers
    assert [numbers.number(words, at) for at in (0, 2, 5)] == [(400.0, 2), (170.0, 5), (200.0, 7)]


@pytest.mark.parametrize(
    ("text", "at", "start"),
    [("one point five mm", 2, 0), ("left twenty five mm", 2, 1), ("left five mm", 1, 1)],
)
def test_a_place_within_a_number_leads_to_its_beginning(text: str, at: int, start: int) -> None:
    assert phrasebook().numbers.start(text.split(), at) == start


@pytest.mark.parametrize(("text", "value"), [("half of ninety", 45.0), ("a third of 60", 20.0)])
def test_a_part_of_a_number_is_that_much_of_it(text: str, value: float) -> None:
    found = phrasebook().numbers.number(text.split(), 0)
    assert found is not None
    assert found[0] == pytest.approx(value)


_SAID = (
    "point",
    "0.4",
    "4",
    "nought",
    "four",
    "hundred",
    "half",
    "and",
    "a",
    "minus",
    "\u00b2",
    "1e30",
)


@settings(deadline=None)
@given(st.lists(st.sampled_from((*_SAID, "9" * 25)), min_size=1, max_size=6))
def test_any_row_of_words_for_numbers_is_read_without_a_fault(words: list[str]) -> None:
    numbers = phrasebook().numbers
    for at in range(len(words)):
        found = numbers.quantity(words, at)
        assert found is None or found.end > at


@pytest.mark.parametrize("text", ["0.4 point 6", "point four point six"])
def test_a_number_has_one_point(text: str) -> None:
    found = phrasebook().numbers.number(text.split(), 0)
    assert found is not None
    assert found[0] == pytest.approx(0.4)
