from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.geometry import Array
from assistant.learning.clearing import (
    FAR_ROUND_RAD,
    NEAREST,
    bump,
    kept_out,
    least_presses,
    prepared,
    presses,
)
from assistant.learning.turning import Turn
from assistant.learning.weights import least_jerk, quintic

SAMPLES = 300
SHARE = np.arange(1, SAMPLES) / SAMPLES


def turn(azimuth: float) -> Turn:
    return Turn(azimuth, [0.0, 0.0, 0.0, 1.0], float(np.cos(azimuth)), float(np.sin(azimuth)))


def jerk(xy: Array) -> float:
    return float(np.sqrt(np.sum(np.diff(xy, n=3, axis=0) ** 2)))


def led(azimuth: float, keep: float = 1.0, radius: float = 0.6, end_m: float = 0.6) -> Array:
    """Return a way from rest to rest whose end is turned about the base, shape (m, 2)."""
    hermite = quintic(SHARE, SAMPLES)
    shown = np.array([radius, 0.0]) + np.linspace(0.0, 1.0, SAMPLES + 1)[:, None] * [0.0, 0.1]
    ready = prepared(shown, SHARE)
    assert ready is not None
    clear, bumps = ready
    end = [end_m * np.cos(azimuth), end_m * np.sin(azimuth), 0.0]
    rest = [[0.0, 0.0, 0.0]] * 2
    free = hermite @ np.array([[radius, 0.0, 0.0], *rest, end, *rest])
    places = [[radius, 0.0, 0.0], *free[clear.at].tolist(), end]
    found = presses(clear, places, (turn(0.0), turn(azimuth)), keep)
    return np.asarray(free[:, :2] + bumps @ np.reshape(found or np.zeros((3, 2)), (3, 2)))


@pytest.mark.parametrize("instant", [0.3, 0.5, 0.7])
def test_a_bump_rests_at_both_ends(instant: float) -> None:
    near = np.array([0.0, 1e-3, 2e-3])
    for share in (near, 1.0 - near):
        value = bump(share, instant)
        assert np.abs(value[0]) < 1e-12
        assert np.abs(np.diff(value)).max() < 1e-5
        assert np.abs(np.diff(value, n=2)).max() < 1e-5


def test_presses_at_two_instants_move_each_other_alike() -> None:
    at = np.array([0.3, 0.5, 0.7])
    stiff = np.stack([bump(at, instant) for instant in at])
    assert np.allclose(stiff, stiff.T)
    assert np.all(np.linalg.eigvalsh(stiff) > 0.0)


@given(seed=st.integers(0, 10_000))
def test_presses_are_the_least_that_do(seed: int) -> None:
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(3, 3))
    stiff, needs = root @ root.T + 0.05 * np.eye(3), rng.normal(size=3)
    found = np.array(least_presses(stiff.tolist(), needs.tolist()))
    spare = stiff @ found - needs
    # These three together say that no other presses meet the needs with less jerk.
    assert np.all(found >= 0.0)
    assert np.all(spare >= -1e-8)
    assert abs(found @ spare) < 1e-7


@given(seed=st.integers(0, 10_000))
def test_little_more_need_is_little_more_press(seed: int) -> None:
    rng = np.random.default_rng(seed)
    stiff = np.stack([bump(np.array([0.3, 0.5, 0.7]), instant) for instant in (0.3, 0.5, 0.7)])
    needs, more = rng.normal(0.0, 0.2, 3), rng.normal(0.0, 1e-5, 3)
    first, second = (
        np.array(least_presses(stiff.tolist(), one.tolist())) for one in (needs, needs + more)
    )
    least = np.linalg.eigvalsh(stiff)[0]
    assert np.linalg.norm(second - first) <= np.linalg.norm(more) / least + 1e-6


@pytest.mark.parametrize("degrees", [60, 120, 180, 240, 300, -200])
def test_a_way_around_the_base_stays_out_with_less_jerk_than_an_even_turn(degrees: int) -> None:
    azimuth = np.deg2rad(degrees)
    path = led(azimuth)
    assert np.min(np.hypot(*path.T)) > 0.97 * kept_out(1.0, abs(azimuth)) * 0.6
    assert np.max(np.hypot(*path.T)) < 1.05 * 0.6
    # It goes around on the side it should.
    assert np.unwrap(np.arctan2(path[:, 1], path[:, 0]))[-1] == pytest.approx(azimuth, abs=1e-2)
    angle = azimuth * least_jerk(SHARE)
    even = 0.6 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    assert jerk(path) <= jerk(even) * (0.85 if abs(degrees) >= 180 else 1.0)


def test_a_way_that_may_come_nearer_has_less_jerk() -> None:
    azimuth = np.deg2rad(200.0)
    rough = [jerk(led(azimuth, keep)) for keep in (1.0, 0.9, 0.8)]
    assert rough[0] > rough[1] > rough[2]


@pytest.mark.parametrize("degrees", [60, 90, 120])
def test_a_way_to_a_nearer_place_is_pressed_no_further_out_than_that(degrees: int) -> None:
    path = led(np.deg2rad(degrees), 1.0, radius=0.6, end_m=0.4)
    away = np.hypot(*path.T)
    assert np.min(away) > 0.97 * 0.4
    assert np.min(away) < 1.02 * 0.4


@given(keep=st.floats(0.3, 1.0), turned=st.floats(0.0, 6.0), more=st.floats(0.0, 1.0))
def test_only_a_way_that_turns_far_comes_nearer(keep: float, turned: float, more: float) -> None:
    assert kept_out(keep, min(turned, FAR_ROUND_RAD)) == keep
    assert min(keep, NEAREST) <= kept_out(keep, turned + more) <= kept_out(keep, turned) <= keep


def test_a_way_that_is_clear_is_not_pressed() -> None:
    path = led(np.deg2rad(30.0), 0.95)
    straight = quintic(SHARE, SAMPLES)[:, [0, 3]] @ np.array([path[0], path[-1]])
    assert np.allclose(path, straight, atol=1e-6)


def test_a_way_of_few_samples_is_left_alone() -> None:
    share = np.arange(1, 8) / 8
    xy = np.ones((9, 2))
    assert prepared(xy, share) is None
