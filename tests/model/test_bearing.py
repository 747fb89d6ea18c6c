"""A body stands where a surface is under it; how far below others it is, is told."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.model.bearing import lifts_mm, stands
from assistant.model.scene import Body, Obstacle, Scene
from assistant.model.setup import Place, Setup

SCENE = Scene(
    bodies={
        "box": Body("box", size_mm=(60.0, 40.0, 50.0)),
        "book": Body("book", size_mm=(200.0, 150.0, 30.0)),
    },
    tables=(Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0)),),
)


def at(x_mm: float, z_mm: float) -> Setup:
    book = Place("body", (400.0, -200.0, 240.0))
    return Setup(places={"box": Place("body", (x_mm, -200.0, z_mm)), "book": book})


@pytest.mark.parametrize(
    ("x_mm", "z_mm", "lifts"),
    [(700.0, 220.0, [20.0]), (700.0, 240.0, []), (400.0, 240.0, [30.0]), (400.0, 270.0, [])],
)
def test_how_far_it_has_to_be_put_higher_to_stand(
    x_mm: float, z_mm: float, lifts: list[float]
) -> None:
    assert lifts_mm(SCENE, at(x_mm, z_mm), "box") == pytest.approx(lifts)


@pytest.mark.parametrize(
    ("x_mm", "z_mm", "does"),
    [(700.0, 240.0, True), (700.0, 265.0, False), (400.0, 270.0, True), (2000.0, 240.0, False)],
)
def test_it_stands_only_on_what_is_there(x_mm: float, z_mm: float, does: bool) -> None:
    assert stands(SCENE, at(x_mm, z_mm), "box") is does


def test_what_has_no_place_stands_on_nothing() -> None:
    nowhere = replace(at(700.0, 240.0), places={})
    assert not stands(SCENE, nowhere, "box")
    assert lifts_mm(SCENE, nowhere, "box") == []
