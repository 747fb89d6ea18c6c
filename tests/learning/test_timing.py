from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import Array, quat_from_rpy
from assistant.learning.timing import Hurry, bounded_times, hand_speeds, rms_jerk, turn_speeds


def wandering(seed: int) -> Array:
    rng = np.random.default_rng(seed)
    xyz = np.cumsum(np.cumsum(rng.normal(0.0, 4e-4, (300, 3)), axis=0), axis=0) * 0.1
    yaw = np.cumsum(rng.normal(0.0, 0.02, 300))
    return np.hstack([xyz, quat_from_rpy(np.stack([0 * yaw, 0 * yaw, yaw], axis=1))])


@given(seed=st.integers(0, 1000), greatest=st.floats(0.02, 0.5), turning=st.floats(0.1, 3.0))
@settings(max_examples=25, deadline=None)
def test_no_bound_is_passed_and_nothing_is_hurried(
    seed: int, greatest: float, turning: float
) -> None:
    path, steps_s = wandering(seed), np.full(299, 0.02)
    t_s = bounded_times(steps_s, path, greatest, turning, 20)
    assert np.max(hand_speeds(t_s, path)) <= greatest * (1 + 1e-9)
    assert np.max(turn_speeds(t_s, path)) <= turning * (1 + 1e-9)
    assert np.all(np.diff(t_s) >= 0.02 - 1e-12)


def test_within_the_bounds_the_times_stay() -> None:
    steps_s = np.full(299, 0.02)
    t_s = bounded_times(steps_s, wandering(0), 100.0, 100.0, 20)
    assert np.allclose(np.diff(t_s), steps_s)


def test_slowing_down_is_smooth() -> None:
    path = np.zeros((200, 7))
    path[:, 6] = 1.0
    path[100:, 0] = np.minimum(np.arange(100) * 0.01, 0.1)
    steps = np.diff(bounded_times(np.full(199, 0.02), path, 0.1, 1.0, 20))
    assert np.max(np.abs(np.diff(steps))) < 0.2 * np.max(steps)


def test_a_smooth_way_takes_hardly_longer_than_it_must() -> None:
    s = np.linspace(0.0, 1.0, 251)
    path = np.zeros((251, 7))
    path[:, 6], path[:, 0] = 1.0, s**3 * (10.0 - 15.0 * s + 6.0 * s * s)
    must = float(np.sum(np.maximum(0.02, np.diff(path[:, 0]) / 0.2)))
    t_s = bounded_times(np.full(250, 0.02), path, 0.2, 1.0, 20)
    assert must <= t_s[-1] < 1.01 * must


def test_jerk_of_a_cubic_is_its_third_derivative() -> None:
    t_s = np.arange(50) * 0.02
    xyz = np.stack([t_s**3, 0 * t_s, 0 * t_s], axis=1)
    assert rms_jerk(xyz, 0.02) == pytest.approx(6.0)


def test_the_sign_of_a_quaternion_is_no_motion() -> None:
    path, steps_s = wandering(3), np.full(299, 0.02)
    flipped = path.copy()
    flipped[::7, 3:] *= -1.0
    flipped[150:, 3:] *= -1.0
    for turning in (0.5, 100.0):
        there = bounded_times(steps_s, path, 100.0, turning, 20)
        assert np.allclose(bounded_times(steps_s, flipped, 100.0, turning, 20), there, atol=1e-6)


@pytest.mark.parametrize(("count", "brake"), [(1, 20), (2, 20), (5, 1), (40, 41), (300, 2)])
def test_bounds_hold_on_paths_of_any_length(count: int, brake: int) -> None:
    path = wandering(1)[:count]
    t_s = bounded_times(np.full(count - 1, 0.02), path, 0.01, 0.1, brake)
    assert t_s.shape == (count,)
    assert np.all(hand_speeds(t_s, path) <= 0.01 * (1 + 1e-9))
    assert np.all(turn_speeds(t_s, path) <= 0.1 * (1 + 1e-9))


def hesitating(grown: float) -> Array:
    """Return a straight way shown in two goes with a halt between, so many times as long."""
    s = np.linspace(0.0, 1.0, 101)
    go = s**3 * (10.0 - 15.0 * s + 6.0 * s * s)
    path = np.zeros((301, 7))
    path[:, 6] = 1.0
    path[:, 0] = 0.2 * grown * np.concatenate([go, np.ones(99), 1.0 + go])
    return path


@given(grown=st.floats(0.5, 6.0), least=st.floats(0.3, 1.0))
@settings(max_examples=25, deadline=None)
def test_a_way_is_hurried_only_as_far_as_it_grew(grown: float, least: float) -> None:
    path, steps_s = hesitating(grown), np.full(300, 0.02)
    greatest = float(np.max(hand_speeds(np.linspace(0.0, 6.0, 301), hesitating(1.0))))
    hurry = Hurry((slice(50, 250),), np.where(np.arange(300) < 150, least, 1.0), 2.0)
    t_s = bounded_times(steps_s, path, greatest, 1.0, 20, hurry)
    slow_s = bounded_times(steps_s, path, greatest, 1.0, 20)
    assert np.max(hand_speeds(t_s, path)) <= greatest * (1.0 + 1e-9)
    assert np.sum(np.diff(t_s)[50:250]) >= 4.0 - 1e-9
    assert np.all(np.diff(t_s) >= least * 0.02 - 1e-12)
    assert t_s[-1] <= slow_s[-1] + 1e-9
    if grown <= 1.0:
        assert np.array_equal(t_s, slow_s)


def test_a_halt_on_a_way_that_grew_is_cut_short() -> None:
    path, steps_s = hesitating(2.0), np.full(300, 0.02)
    greatest = float(np.max(hand_speeds(np.linspace(0.0, 6.0, 301), hesitating(1.0))))
    hurry = Hurry((slice(0, 300),), np.full(300, 0.5), 2.0)
    t_s = bounded_times(steps_s, path, greatest, 1.0, 20, hurry)
    assert np.min(np.diff(t_s)[120:180]) < 0.0125
    assert t_s[-1] < bounded_times(steps_s, path, greatest, 1.0, 20)[-1] - 0.8
