from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import Array
from assistant.learning.onsets import centered, onset
from assistant.learning.signals import Minimum, pace, speed_minima
from assistant.learning.smoothing import smooth
from assistant.model.demonstration import Recording
from assistant.model.settings import SignalSettings

GIVEN = SignalSettings()


def reach(t_s: Array, start_s: float, lasting_s: float) -> Array:
    """Way of a minimum-jerk reach, from 0 to 1."""
    share = np.clip((t_s - start_s) / lasting_s, 0.0, 1.0)
    return np.asarray(share**3 * (10.0 - 15.0 * share + 6.0 * share**2))


def two_reaches(step_s: float, first_s: float, rest_s: float, second_s: float) -> Recording:
    """Rest, a reach along x, a rest, a reach along y, a rest; noise of a tenth of a millimetre."""
    left_s = 2.0 + first_s + rest_s
    t_s = np.arange(0.0, left_s + second_s + 2.0, step_s)
    path = np.zeros((len(t_s), 7))
    path[:, 6] = 1.0
    path[:, 0] = 0.3 * reach(t_s, 2.0, first_s)
    path[:, 1] = 0.25 * reach(t_s, left_s, second_s)
    path[:, :3] += np.random.default_rng(0).normal(0.0, 1e-4, (len(t_s), 3))
    return Recording(t_s, path)


@given(begun_s=st.floats(2.0, 5.0), lasting_s=st.floats(5.0, 15.0), size_m=st.floats(0.1, 0.5))
@settings(max_examples=25, deadline=None)
def test_a_reach_seen_twice_a_second_sets_in_where_it_began(
    begun_s: float, lasting_s: float, size_m: float
) -> None:
    t_s = np.arange(0.0, begun_s + lasting_s + 1.0, 0.5)
    rows = size_m * reach(t_s, begun_s, lasting_s)[:, None]
    told = onset(t_s, rows, 0.0, float(t_s[-1]), 1e-4, GIVEN)
    assert told is not None
    # A reach of least jerk sets off a little more slowly than the cube of its whole first part.
    assert abs(told - begun_s) < 0.2 + 0.05 * lasting_s


def test_too_few_samples_tell_no_onset() -> None:
    t_s = np.arange(4.0)
    assert onset(t_s, t_s[:, None], 0.0, 3.0, 1e-4, GIVEN) is None


@pytest.mark.parametrize(("first_s", "second_s"), [(8.0, 8.0), (14.0, 6.0), (5.0, 12.0)])
def test_a_rest_seen_twice_a_second_is_known_to_less_than_a_sample(
    first_s: float, second_s: float
) -> None:
    smoothed = smooth(two_reaches(0.5, first_s, 3.0, second_s))
    minima = speed_minima(smoothed.t_s, pace(smoothed, GIVEN), GIVEN)
    true_s = 2.0 + first_s + 1.5
    found = centered(minima, smoothed, GIVEN)
    assert min(abs(spot.at_s - true_s) for spot in found) < 0.4


def test_order_and_rests_are_kept() -> None:
    smoothed = smooth(two_reaches(0.5, 8.0, 3.0, 6.0))
    minima = speed_minima(smoothed.t_s, pace(smoothed, GIVEN), GIVEN)
    found = centered(minima, smoothed, GIVEN)
    assert len(found) == len(minima)
    assert sorted((s.from_s, s.to_s) for s in found) == sorted((s.from_s, s.to_s) for s in minima)
    at_s = [spot.at_s for spot in found]
    assert at_s == sorted(at_s)


def test_samples_that_show_a_rest_tell_of_it_themselves() -> None:
    smoothed = smooth(two_reaches(0.02, 1.5, 0.6, 1.0))
    minima = speed_minima(smoothed.t_s, pace(smoothed, GIVEN), GIVEN)
    assert centered(minima, smoothed, GIVEN) == minima


def test_a_hand_that_stands_still_is_left_alone() -> None:
    t_s = 0.5 * np.arange(50.0)
    path: Array = np.tile([0.4, 0.0, 0.3, 0.0, 0.0, 0.0, 1.0], (50, 1))
    spots = (Minimum(12.0, 1.0, 11.0, 13.0),)
    (found,) = centered(spots, smooth(Recording(t_s, path)), GIVEN)
    assert np.isfinite(found.at_s)
    assert 0.0 <= found.at_s <= 24.5
