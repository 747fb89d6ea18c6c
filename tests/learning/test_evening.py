from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import Array
from assistant.learning.evening import even, share_needed, third

SHARE = np.arange(1, 300) / 300


def uneven(height_m: float, seed: int = 0) -> Array:
    """Return a slow detour with a teacher's unevenness on it, at rest at both ends."""
    rng = np.random.default_rng(seed)
    fade = np.sin(np.pi * SHARE) ** 4
    knots = np.arange(20, 30)
    sizes, phases = rng.normal(0.0, height_m, (10, 3)), rng.uniform(0.0, 6.0, 10)
    waves = np.sin(np.pi * np.outer(SHARE, knots) + phases) @ sizes
    return np.asarray(fade[:, None] * (np.array([0.05, 0.02, 0.1]) + waves))


def test_an_even_way_stays_near_and_has_less_jerk() -> None:
    details = uneven(0.001)
    curve = even(details, SHARE, 0.010)
    assert np.max(np.linalg.norm(curve - details, axis=1)) <= 0.010
    assert np.sum(third(curve.T) ** 2) < 0.1 * np.sum(third(details.T) ** 2)
    # Both ends keep their place, speed and acceleration.
    assert np.max(np.abs(curve[[0, -1]])) < 1e-4


def test_what_cannot_be_evened_within_the_bound_stays() -> None:
    details = uneven(0.02)
    assert even(details, SHARE, 1e-6) is details


def test_details_of_few_samples_stay() -> None:
    details = np.ones((4, 3))
    assert even(details, np.arange(1, 5) / 5, 1.0) is details


def products(rough: Array, change: Array) -> tuple[float, float, float]:
    return (
        float(np.vdot(rough, rough)),
        float(np.vdot(rough, change)),
        float(np.vdot(change, change)),
    )


@pytest.mark.parametrize("aim", [0.95, 0.7, 0.4])
def test_no_more_is_evened_than_needed(aim: float) -> None:
    details = uneven(0.001)
    rough, change = third(details.T), third((even(details, SHARE, 0.010) - details).T)
    most = aim * float(np.vdot(rough, rough))
    share = share_needed(*products(rough, change), most)
    assert 0.0 < share < 1.0
    after = rough + share * change
    assert np.vdot(after, after) == pytest.approx(most, rel=1e-9)


def test_what_is_even_enough_is_left_alone_and_what_is_never_is_evened_wholly() -> None:
    details = uneven(0.001)
    rough, change = third(details.T), third((even(details, SHARE, 0.010) - details).T)
    assert share_needed(*products(rough, change), float(np.vdot(rough, rough))) == 0.0
    assert share_needed(*products(rough, -change), 0.0) == 0.0
    assert share_needed(*products(rough, change), 0.0) == pytest.approx(1.0, abs=0.05)
