"""Pictures of characters: bars as high as their numbers, marks where things happened."""

from __future__ import annotations

import io

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from rich.console import Console

from assistant.shells import curves

heights = st.lists(st.floats(0, 1e3), min_size=1, max_size=40).map(np.array)


@settings(max_examples=50)
@given(heights, st.integers(1, 5))
def test_bars_grow_with_their_numbers(values: np.ndarray, rows: int) -> None:
    lines = curves.bars(values, rows)
    assert len(lines) == rows
    assert {len(line) for line in lines} == {len(values)}
    drawn = [sum(curves.BLOCKS.index(line[at]) for line in lines) for at in range(len(values))]
    assert all(np.diff(np.array(drawn)[np.argsort(values, kind="stable")]) >= 0)
    assert values.max() == 0 or max(drawn) == rows * 8


def test_the_greatest_value_of_a_span_is_seen() -> None:
    t_s = np.linspace(0, 10, 1001)
    values = np.where(np.abs(t_s - 5.05) < 0.02, 1.0, 0.0)
    seen = curves.sampled(t_s, values, 10)
    assert seen.tolist() == [0, 0, 0, 0, 0, 1, 0, 0, 0, 0]


def test_few_samples_fill_all_columns() -> None:
    seen = curves.sampled(np.array([0.0, 1.0]), np.array([0.0, 1.0]), 20)
    assert (np.diff(seen) >= 0).all()


def test_marks_stay_within_the_picture() -> None:
    t_s = np.array([0.0, 10.0])
    assert curves.marks([-5, 5, 99], t_s, 11, "|") == "|    |    |"
    assert curves.axis(t_s, 12) == "0.0   10.0 s"


def test_speed_bridges_repeated_times() -> None:
    t_s = np.array([0.0, 0.1, 0.1, 0.2, 0.3])
    path = np.zeros((5, 7))
    path[:, 0] = t_s
    assert np.allclose(curves.speed(t_s, path), 1.0)
    assert curves.speed(np.zeros(3), path[:3]).tolist() == [0, 0, 0]


def test_terminals_without_blocks_get_plain_signs() -> None:
    class Ascii(io.StringIO):
        encoding = "ascii"

    out = Ascii()
    picture = curves.Picture(
        lambda blocks, _: "".join(curves.bars(np.array([1.0]), 1, blocks=blocks))
    )
    Console(file=out).print(picture)
    assert out.getvalue() == "@\n"


def test_a_picture_is_no_wider_than_the_terminal() -> None:
    picture = curves.Picture(lambda blocks, columns: "#" * columns)
    for width, drawn in ((100, curves.COLUMNS), (40, 40), (5, 5)):
        console = Console(file=io.StringIO(), width=width)
        with console.capture() as told:
            console.print(picture)
        assert len(told.get().rstrip()) == drawn
