"""Time spent thinking is not carried out; all the rest of a motion stays as it was shown."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import Array, pose_from_mm_deg
from assistant.learning.generalization import sampled
from assistant.learning.smoothing import Smoothed, smooth
from assistant.learning.timing import rms_jerk
from assistant.learning.waiting import without_waits
from assistant.learning.weights import least_jerk
from assistant.model.demonstration import Recording
from assistant.model.settings import GeneralizationSettings

GIVEN = GeneralizationSettings()
WAY_S = 1.5


def stop_and_go(rests_s: list[float], creep_mm: float = 0.0) -> tuple[Smoothed, list[float]]:
    """Return a hand that goes 80 mm before each rest, and when its rests begin."""
    begins_s = [(k + 1) * WAY_S + sum(rests_s[:k]) for k in range(len(rests_s))]
    t_s = np.arange(0.0, begins_s[-1] + rests_s[-1] + WAY_S + 0.5, 0.02)
    gone = sum(80.0 * least_jerk((t_s - at_s) / WAY_S + 1.0) for at_s in begins_s)
    crept = sum(
        creep_mm * least_jerk((t_s - at_s) / rest_s)
        for at_s, rest_s in zip(begins_s, rests_s, strict=True)
    )
    last = 80.0 * least_jerk((t_s - begins_s[-1] - rests_s[-1]) / WAY_S)
    xyz_mm = np.stack([300.0 + gone, crept * np.ones(len(t_s)), 200.0 + last], axis=1)
    return smooth(Recording(t_s, pose_from_mm_deg(xyz_mm, np.zeros((len(t_s), 3))))), begins_s


def length(one: Smoothed) -> float:
    return float(np.ptp(one.t_s))


@given(rests_s=st.lists(st.floats(0.3, 20.0), min_size=1, max_size=3))
@settings(max_examples=10, deadline=None)
def test_no_rest_lasts_longer_than_the_longest_and_no_way_is_lost(rests_s: list[float]) -> None:
    shown, _ = stop_and_go(rests_s)
    kept, clock = without_waits(shown, [], GIVEN)
    moving_s = length(shown) - sum(rests_s) - 0.5
    # A hand is slow for a moment before it rests and after: that much is rest, too.
    slow_s = 0.5 + 0.6 * (len(rests_s) + 1)
    most_s = moving_s + slow_s + sum(min(rest_s, GIVEN.longest_rest_s) for rest_s in rests_s)
    assert length(kept) <= most_s
    assert length(kept) >= moving_s
    fast = shown.speed > GIVEN.rest_m_s
    np.testing.assert_allclose(kept.path[kept.speed > GIVEN.rest_m_s], shown.path[fast])
    np.testing.assert_allclose(clock.shortened(clock.shown(kept.t_s)), kept.t_s, atol=1e-9)


@given(rest_s=st.floats(4.0, 20.0))
@settings(max_examples=5, deadline=None)
def test_what_is_left_is_no_rougher_than_what_was_shown(rest_s: float) -> None:
    kept, _ = without_waits(stop_and_go([rest_s])[0], [], GIVEN)
    brief, _ = stop_and_go([GIVEN.longest_rest_s])
    rough = [rms_jerk(sampled(one, []).path[:, :3], GIVEN.step_s) for one in (kept, brief)]
    assert rough[0] <= 1.05 * rough[1]


def test_short_rests_leave_the_motion_as_it_is() -> None:
    shown, _ = stop_and_go([1.0, 1.4])
    assert without_waits(shown, [], GIVEN)[0] is shown


def test_a_hand_that_creeps_is_not_waiting() -> None:
    shown, _ = stop_and_go([20.0], creep_mm=60.0)
    assert length(without_waits(shown, [], GIVEN)[0]) == pytest.approx(length(shown))


@pytest.mark.parametrize("after_s", [0.5, 3.0, 15.0, 28.5])
def test_where_the_hand_acts_within_a_wait_it_rests_before_and_after(after_s: float) -> None:
    shown, begins_s = stop_and_go([30.0])
    acts_s = [begins_s[0] + after_s]
    kept, clock = without_waits(shown, acts_s, GIVEN)
    assert length(kept) < length(shown) - 20.0
    at_s = float(clock.shortened(np.array(acts_s))[0])
    still = still_about(kept, at_s)
    before = min(after_s, GIVEN.longest_rest_s / 3.0)
    after = min(30.0 - after_s, GIVEN.longest_rest_s / 3.0)
    assert at_s - still[0] >= before - 0.05
    assert still[1] - at_s >= after - 0.05
    assert float(clock.shown(np.array([at_s]))[0]) == pytest.approx(acts_s[0], abs=0.03)


def still_about(one: Smoothed, at_s: float) -> tuple[float, float]:
    fast_s: Array = one.t_s[one.speed > GIVEN.rest_m_s]
    return next((a, b) for a, b in pairwise(fast_s) if a < at_s < b)
