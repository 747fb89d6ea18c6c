import pytest
from hypothesis import given
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
