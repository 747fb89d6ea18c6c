"""What a demonstration shows of how its primitives end."""

from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import IDENTITY, Array, compose, pose_from_mm_deg
from assistant.learning.conditions import Inferred, inferred
from assistant.model.conditions import Condition
from assistant.model.lesson import Station
from assistant.model.scene import Body, Scene
from assistant.model.task import Action, Primitive

LEAVES = tuple(
    Primitive(name, Action("move", way, "block"))
    for name, way in (("grasp", "to"), ("carry", "to"), ("lower", "down"), ("place", "to"))
)
SCENE = Scene(bodies={"block": Body("block")})
TARGET = pose_from_mm_deg((500.0, -200.0, 300.0), (0.0, 0.0, 40.0))
BLOCK = pose_from_mm_deg((500.0, 200.0, 300.0), (0.0, 0.0, 0.0))


def seen(
    beside_mm: float = 0.0,
    passing_mm: float = 0.0,
    let_go: Array = IDENTITY,
    grasped: Array = IDENTITY,
) -> Inferred:
    """Carry a block over a target and down.

    Parameters
    ----------
    beside_mm : float
        Where the carrying ends, beside the target's middle.
    passing_mm : float
        How far beside the way goes after that, before it comes down.
    let_go, grasped : array, shape (7,)
        The hand in the frames of target and block when it opens and closes.
    """
    end = compose(TARGET, let_go)
    sides = [beside_mm, beside_mm, passing_mm, passing_mm, 0.0]
    over = [_by(end, aside, 120.0 - 10.0 * k) for k, aside in enumerate(sides)]
    path = np.array([compose(BLOCK, grasped), *over, end])
    primitive_at = np.array([0, 1, 1, 2, 2, 2, 3])
    stations = (
        Station("grasp", "block", "block", "grasp", 0, 0, 1, BLOCK, grasped, grasped),
        Station("release", "block", "target", "place", 6, 5, 6, TARGET, let_go, let_go),
    )
    return inferred(LEAVES, path, primitive_at, stations, SCENE)


def _by(pose: Array, beside_mm: float, up_mm: float) -> Array:
    return np.array(pose) + np.array([0.0, beside_mm, up_mm, 0.0, 0.0, 0.0, 0.0]) / 1000.0


@pytest.mark.parametrize(
    ("beside_mm", "passing_mm", "above"),
    [(0.0, 0.0, True), (12.0, 5.0, True), (20.0, 0.0, False), (0.0, 80.0, False)],
)
def test_above_is_where_a_step_ended_not_what_it_passed(
    beside_mm: float, passing_mm: float, above: bool
) -> None:
    until = seen(beside_mm, passing_mm).until["carry"]
    assert until == ((Condition("above", "block", "target"),) if above else ())


@pytest.mark.parametrize(
    ("xyz_mm", "yaw_deg", "aligned"),
    [((0.5, 0.0, 0.0), 0.0, True), ((0.0, 3.0, 0.0), 0.0, False), ((0.0, 0.0, 0.0), 2.5, False)],
)
def test_in_line_is_what_practice_calls_so(
    xyz_mm: tuple[float, float, float], yaw_deg: float, aligned: bool
) -> None:
    off = pose_from_mm_deg(xyz_mm, (0.0, 0.0, yaw_deg))
    wanted = Condition("aligned", "block", "target")
    assert (wanted in seen(let_go=off).until["place"]) == aligned
    # A block that sits aside in the hand lies aside; let go as far aside, it lies in line.
    assert (wanted in seen(grasped=off).until["place"]) == aligned
    assert wanted in seen(let_go=off, grasped=off).until["place"]
