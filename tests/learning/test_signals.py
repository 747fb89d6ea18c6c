from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import Array
from assistant.learning.signals import gripper_events, speed_minima
from assistant.model.demonstration import Recording
from assistant.model.settings import SignalSettings

STILL = np.array([0.4, 0.0, 0.3, 0.0, 0.0, 0.0, 1.0])


def times(count: int, step_s: float = 0.02) -> Array:
    return np.arange(count, dtype=np.float64) * step_s


def with_gripper(opening_m: Array, step_s: float = 0.02) -> Recording:
    t_s = times(len(opening_m), step_s)
    return Recording(t_s, np.tile(STILL, (len(t_s), 1)), opening_m)


def bell(t_s: Array, start_s: float, lasting_s: float, size: float = 1.0) -> Array:
    """Speed of a minimum-jerk reach."""
    share = np.clip((t_s - start_s) / lasting_s, 0.0, 1.0)
    return np.asarray(size * 30.0 * share**2 * (1.0 - share) ** 2 / lasting_s)


@given(
    close_s=st.floats(0.5, 2.0),
    ramp_s=st.floats(0.1, 0.8),
    open_m=st.floats(0.03, 0.1),
    noise_m=st.floats(0.0, 1e-3),
)
@settings(max_examples=25, deadline=None)
def test_a_gripper_instant_is_half_the_travel(
    close_s: float, ramp_s: float, open_m: float, noise_m: float
) -> None:
    t_s = times(300)
    share = np.clip((t_s - close_s) / ramp_s, 0.0, 1.0) - np.clip((t_s - 4.0) / ramp_s, 0.0, 1.0)
    noise = np.random.default_rng(0).uniform(-noise_m, noise_m, len(t_s))
    events = gripper_events(with_gripper(open_m * (1.0 - 0.7 * share) + noise), SignalSettings())
    assert [event.kind for event in events] == ["close", "open"]
    assert events[0].at_s == pytest.approx(close_s + 0.5 * ramp_s, abs=0.02 + 0.1 * ramp_s)
    assert events[1].at_s == pytest.approx(4.0 + 0.5 * ramp_s, abs=0.02 + 0.1 * ramp_s)


def test_fingers_that_stop_half_way_close_once() -> None:
    t_s = times(200)
    opening = np.interp(t_s, [0.0, 1.0, 1.3, 2.0, 2.3, 4.0], [0.08, 0.08, 0.05, 0.05, 0.02, 0.02])
    opening += 0.003 * np.sin(40.0 * t_s)
    assert [event.kind for event in gripper_events(with_gripper(opening), SignalSettings())] == [
        "close"
    ]


@given(
    at_s=st.sets(st.sampled_from([0.5, 1.0, 3.0, 5.0, 5.5])),
    wrong_m=st.sampled_from([-1.0, 0.0, 0.02, 0.08, 0.5]),
    lasting_s=st.sampled_from([0.01, 0.1]),
)
@settings(max_examples=25, deadline=None)
def test_a_sensor_that_is_wrong_for_a_moment_closes_no_hand(
    at_s: set[float], wrong_m: float, lasting_s: float
) -> None:
    t_s = times(300)
    opening = np.where((t_s > 2.0) & (t_s < 4.0), 0.02, 0.08)
    for begin_s in at_s:
        # One sample may be anything; what lasts is at least an opening.
        told_m = wrong_m if lasting_s < 0.02 else min(max(wrong_m, 0.02), 0.08)
        first = round(begin_s / 0.02)
        opening[first : first + max(round(lasting_s / 0.02), 1)] = told_m
    events = gripper_events(with_gripper(opening), SignalSettings())
    assert [one.kind for one in events] == ["close", "open"]
    assert [one.at_s for one in events] == pytest.approx([2.0, 4.0], abs=0.021)


def test_who_lets_go_by_a_slip_of_the_finger_still_holds() -> None:
    t_s = times(300)
    held = (t_s > 1.0) & (t_s < 5.0) & ~((t_s > 1.4) & (t_s < 1.6))
    events = gripper_events(with_gripper(np.where(held, 0.02, 0.08)), SignalSettings())
    assert [one.at_s for one in events] == [
        pytest.approx(1.01, abs=0.02),
        pytest.approx(5.0, abs=0.02),
    ]


@pytest.mark.parametrize("opening_m", [0.0, 0.08])
def test_a_gripper_that_hardly_moves_has_no_events(opening_m: float) -> None:
    noise = np.random.default_rng(1).normal(0.0, 1e-4, 200)
    assert gripper_events(with_gripper(opening_m + noise), SignalSettings()) == ()


def test_an_unknown_gripper_has_no_events() -> None:
    bare = Recording(times(9), np.tile(STILL, (9, 1)))
    assert gripper_events(bare, SignalSettings()) == ()


@given(
    rest_s=st.floats(0.3, 2.0),
    before_s=st.floats(0.8, 3.0),
    after_s=st.floats(0.8, 3.0),
    size=st.floats(0.02, 2.0),
)
@settings(max_examples=25, deadline=None)
def test_the_middle_of_a_rest_does_not_depend_on_the_reaches_around(
    rest_s: float, before_s: float, after_s: float, size: float
) -> None:
    t_s = times(int((before_s + rest_s + after_s + 0.4) / 0.02))
    begin = 0.2 + before_s
    speed = bell(t_s, 0.2, before_s, size) + bell(t_s, begin + rest_s, after_s, size)
    rests = [spot for spot in speed_minima(t_s, speed, SignalSettings()) if spot.at_s > 0.3]
    inner = [spot for spot in rests if spot.at_s < t_s[-1] - 0.3]
    assert len(inner) == 1
    assert inner[0].at_s == pytest.approx(begin + 0.5 * rest_s, abs=0.08)
    assert inner[0].to_s - inner[0].from_s == pytest.approx(rest_s, abs=0.15)


def test_minima_above_the_mean_are_not_proposed() -> None:
    t_s = times(400)
    speed = 1.0 + 0.05 * np.sin(6.0 * t_s)
    assert speed_minima(t_s, speed, SignalSettings()) == ()


def test_a_hand_that_never_moves_has_no_minima() -> None:
    assert speed_minima(times(50), np.zeros(50), SignalSettings()) == ()
    assert speed_minima(times(3), np.ones(3), SignalSettings()) == ()
