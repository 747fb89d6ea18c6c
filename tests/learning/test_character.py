from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import quat_from_rpy
from assistant.learning.character import change, character
from assistant.learning.smoothing import Smoothed, smooth
from assistant.model.demonstration import Recording
from assistant.model.directions import WAYS


def moved(way: tuple[float, float, float], rpy: tuple[float, float, float]) -> Smoothed:
    """A motion of two seconds, and a long way back, so that there is an extent."""
    t_s = np.arange(0.0, 4.0, 0.02)
    share = np.clip(t_s / 2.0, 0.0, 1.0) - 0.0 * t_s
    path = np.zeros((len(t_s), 7))
    path[:, :3] = share[:, None] * np.array(way)
    path[:, 0] += np.where(t_s > 3.0, 0.3 * (t_s - 3.0), 0.0)
    path[:, 3:] = quat_from_rpy(share[:, None] * np.array(rpy))
    return smooth(Recording(t_s, path))


@pytest.mark.parametrize("name", sorted(WAYS))
def test_directions_are_those_of_the_robot(name: str) -> None:
    x, y, z = (0.1 * part for part in WAYS[name])
    assert character(moved((x, y, z), (0.0, 0.0, 0.0)), 0.0, 2.0) == name


@pytest.mark.parametrize(
    ("rpy", "name"),
    [
        ((0.0, 0.0, 1.0), "turn left"),
        ((0.0, 0.0, -1.0), "turn right"),
        ((0.0, -1.0, 0.0), "turn up"),
        ((0.0, 1.0, 0.0), "turn down"),
    ],
)
def test_turns_are_named_where_they_are_all_there_is(
    rpy: tuple[float, float, float], name: str
) -> None:
    assert character(moved((0.0, 0.0, 0.0), rpy), 0.0, 2.0) == name


def test_a_rest_is_a_rest_and_a_diagonal_is_nothing() -> None:
    motion = moved((0.1, 0.0, 0.0), (0.0, 0.0, 0.0))
    assert character(motion, 2.3, 2.8) == "rest"
    assert character(moved((0.1, 0.1, 0.1), (0.0, 0.0, 0.0)), 0.0, 2.0) == ""


def test_change_is_told_in_the_base_frame() -> None:
    way, turn = change(moved((0.0, 0.1, 0.0), (0.0, 0.0, 0.5)), 0.0, 2.5)
    assert way == pytest.approx([0.0, 0.1, 0.0], abs=2e-3)
    assert turn == pytest.approx([0.0, 0.0, 0.5], abs=1e-2)
