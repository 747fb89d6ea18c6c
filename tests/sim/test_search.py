"""A way is found around what stands between two postures, the same each time."""

from __future__ import annotations

import numpy as np

from assistant.geometry import Array
from sim import a465
from sim.kinematics import within_limits
from sim.search import STEP_RAD, filled, searched

START = np.array([-0.8, 0.3, 1.2, 0.0, 0.2, 0.0])
END = np.array([0.8, 0.3, 1.2, 0.0, 0.2, 0.0])


def wall(q: Array) -> Array:
    """Free but for a wall across joint 1 that is open where joint 2 leans back."""
    return np.where((np.abs(q[:, 0]) < 0.2) & (q[:, 1] > -0.2), -1.0, 1.0)


def test_it_goes_through_the_gap() -> None:
    way = searched(START, END, wall, 120)
    assert way is not None
    assert way.shape == (120, a465.JOINTS)
    np.testing.assert_allclose(way[[0, -1]], [START, END])
    assert wall(way).min() > 0
    assert within_limits(way).all()


def test_it_is_the_same_each_time() -> None:
    first, second = (searched(START, END, wall, 60) for _ in range(2))
    assert first is not None
    assert second is not None
    np.testing.assert_array_equal(first, second)


def test_no_way_into_a_closed_place() -> None:
    assert searched(START, END, lambda q: np.where(q[:, 0] > 0.5, -1.0, 1.0), 60) is None


def test_far_joints_have_more_between_them_on_the_curve_through_all() -> None:
    s = np.linspace(0.0, 1.0, 12)[:, None]
    q = START + (END - START) * s**2 * (3.0 - 2.0 * s)
    dense = filled(q)
    assert np.abs(np.diff(q, axis=0)).max() > 3.0 * STEP_RAD
    assert np.abs(np.diff(dense, axis=0)).max() < 1.1 * STEP_RAD
    for joints in q:
        assert np.abs(dense - joints).max(axis=1).min() < 1e-12
    short = q[:1] + 0.5 * STEP_RAD * np.arange(4)[:, None]
    np.testing.assert_array_equal(filled(short), short)
