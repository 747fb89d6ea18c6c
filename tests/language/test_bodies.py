"""Shapes and sizes out of words."""

from __future__ import annotations

import pytest

from assistant.language.bodies import read_body


@pytest.mark.parametrize(
    ("text", "shape", "size_mm"),
    [
        ("a box, 6 by 4 by 10 centimetres", "box", (60, 40, 100)),
        ("a box of 60 by 40 by 100 mm", "box", (60, 40, 100)),
        ("a cube, 5 cm", "box", (50, 50, 50)),
        ("a flat mark 6 by 4 cm", "box", (60, 40, 0)),
        ("a ball four centimetres across", "sphere", (40, 40, 40)),
        ("a cylinder 5 cm wide and 10 cm high", "cylinder", (50, 50, 100)),
        ("a mug, 8 centimeters wide and 95 mm high", "cup", (80, 80, 95)),
        ("it is two inches wide", None, (50.8, 50.8, 50.8)),
        ("6 by 4 by 10", None, (60, 40, 100)),
        ("8 centimetres wide and 7 high", None, (80, 80, 70)),
        ("7 high and 8 wide", None, (80, 80, 70)),
        ("a box with a height of 7 cm, 5 long and 4 deep", "box", (50, 40, 70)),
        ("round, 12 cm wide and 1 cm thick", "cylinder", (120, 120, 10)),
        ("seven tall, four by five", None, (40, 50, 70)),
    ],
)
def test_shape_and_size(text: str, shape: str | None, size_mm: tuple[float, ...]) -> None:
    told = read_body(text)
    assert told.shape == shape
    assert told.size_mm == pytest.approx(size_mm)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "it is round",
        "a cylinder 5 cm wide",
        "zero by 0",
        "about 30 cm in front of you and 15 to the left",
    ],
)
def test_without_a_size_there_is_none(text: str) -> None:
    assert read_body(text).size_mm is None


def test_a_body_has_the_shape_of_its_name() -> None:
    assert read_body("8 cm wide and 9 high", name="cup").shape == "cup"
    assert read_body("a box, 8 by 9 by 3", name="cup").shape == "box"
    assert read_body("8 cm breit und 9 hoch", "german", "Tasse").size_mm == (80.0, 80.0, 90.0)


@pytest.mark.parametrize(
    ("text", "size_mm"),
    [
        ("ein Würfel, 4 cm groß", (40, 40, 40)),
        ("ein Würfel mit vier Zentimetern Kantenlänge", (40, 40, 40)),
        ("ein Zylinder, 5 Zentimeter breit und 10 hoch", (50, 50, 100)),
        ("eine flache Platte von 20 mal 20 cm", (200, 200, 0)),
        ("10 mal 10 Zentimeter, einen Zentimeter dick", (100, 100, 10)),
        ("anderthalb Zentimeter dick, 10 mal 10", (100, 100, 15)),
        ("ein mal zwei mal drei Zentimeter", (10, 20, 30)),
        ("eine Kugel, zweieinhalb Zentimeter", (25, 25, 25)),
    ],
)
def test_german_sizes_count_no_article(text: str, size_mm: tuple[float, ...]) -> None:
    assert read_body(text, "german").size_mm == pytest.approx(size_mm)


def test_one_counts_where_lengths_are_told() -> None:
    assert read_body("one cube with 4 cm sides").size_mm == pytest.approx((40, 40, 40))
    assert read_body("one by two by three cm").size_mm == pytest.approx((10, 20, 30))


@pytest.mark.parametrize(
    ("text", "language", "shape"),
    [
        ("a flat round thing, 14 wide and 1.5 high", "english", "cylinder"),
        ("flat, 25 by 20, 1 thick", "english", "box"),
        ("ein flacher runder Teller, rund, 14 breit und 2 hoch", "german", "cylinder"),
        ("flach, 25 mal 20 mal 1", "german", "box"),
    ],
)
def test_what_is_flat_may_be_round(text: str, language: str, shape: str) -> None:
    assert read_body(text, language).shape == shape
