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
