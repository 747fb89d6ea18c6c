from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.geometry import Array, quat_from_rotvec, quat_multiply, quat_to_rotvec
from assistant.learning.turning import NODES, SUMMED, Turn, nodes_between, products, turned

MADE = np.linspace(0.0, 1.0, 301)


def a_turn(rng: np.random.Generator, azimuth: float) -> Turn:
    return Turn(azimuth, quat_from_rotvec(rng.normal(size=3)).tolist(), 1.0, 0.0)


@given(
    seed=st.integers(0, 10_000),
    before=st.floats(-2.0 * math.pi, 2.0 * math.pi),
    after=st.floats(-2.0 * math.pi, 2.0 * math.pi),
)
def test_a_way_turns_by_the_arc_and_then_with_the_azimuth(
    seed: int, before: float, after: float
) -> None:
    """Through its nodes it is the same turn, to rounding, as made sample by sample."""
    rng = np.random.default_rng(seed)
    here, there = a_turn(rng, before), a_turn(rng, after)
    found = (turned([here, there])[0] @ nodes_between(MADE)).T
    back = np.array([-1.0, -1.0, -1.0, 1.0]) * here.rest
    arc = quat_to_rotvec(quat_multiply(back, np.array(there.rest)))
    arcs = quat_multiply(np.array(here.rest), quat_from_rotvec(MADE[:, None] * arc))
    azimuth = before + (after - before) * MADE
    round_base = quat_from_rotvec(azimuth[:, None] * np.array([0.0, 0.0, 1.0]))
    wanted = quat_multiply(round_base, arcs)
    wanted *= np.sign(np.sum(found * wanted, axis=1, keepdims=True))
    assert np.max(np.abs(found - wanted)) < 1e-13


def test_at_the_nodes_the_values_themselves_stand() -> None:
    assert np.array_equal(nodes_between(NODES), np.eye(len(NODES)))


@pytest.mark.parametrize("seed", range(3))
def test_terms_sum_up_to_products_of_quaternions(seed: int) -> None:
    rng = np.random.default_rng(seed)
    first: Array = quat_from_rotvec(rng.normal(size=(20, 3)))
    second: Array = quat_from_rotvec(rng.normal(size=(20, 3)))
    found = SUMMED @ products(np.ascontiguousarray(first.T), np.ascontiguousarray(second.T))
    assert np.allclose(found.T, quat_multiply(first, second), atol=1e-15)
