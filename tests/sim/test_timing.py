"""Timing keeps the shown profile and passes no limit."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import Array, angle_between
from sim import a465
from sim.kinematics import forward
from sim.timing import TURN_RAD_S, Timed, timed

HAND_M_S = 0.25


def swing(amount: float, lasts_s: float, rest_s: float = 0.5) -> tuple[Array, Array]:
    """Return a minimum-jerk motion of all joints from READY, with a rest at either end."""
    u_s = np.arange(0.0, lasts_s + 2 * rest_s, 0.02)
    s = np.clip((u_s - rest_s) / lasts_s, 0.0, 1.0)
    s = s**3 * (10.0 - 15.0 * s + 6.0 * s * s)
    return u_s, a465.READY + amount * s[:, None] * np.array([1.0, 0.4, -0.5, 0.8, 0.6, -0.7])


def run(u_s: Array, q: Array, hand_m_s: float = HAND_M_S) -> Timed:
    return timed(u_s, q, forward(q)[:, :3], hand_m_s)


def peaks(q: Array) -> tuple[float, float, float]:
    """Return the greatest shares of joint speed and acceleration, and the hand's speed."""
    speed = np.abs(np.diff(q, axis=0)) * a465.CONTROL_HZ / a465.SPEEDS
    padded = np.concatenate([q[:1], q, q[-1:]])
    bend = np.abs(np.diff(padded, 2, axis=0)) * a465.CONTROL_HZ**2 / a465.ACCELERATIONS
    hand = np.linalg.norm(np.diff(forward(q)[:, :3], axis=0), axis=1) * a465.CONTROL_HZ
    return float(speed.max()), float(bend.max()), float(hand.max())


def test_a_gentle_motion_keeps_its_own_timing() -> None:
    u_s, q = swing(0.4, 3.0)
    result = run(u_s, q)
    assert result.t_s[-1] == pytest.approx(u_s[-1] - u_s[0], abs=0.03)
    np.testing.assert_allclose(result.q[: len(q)], q, atol=1e-6)


@settings(max_examples=25, deadline=None)
@given(st.floats(0.3, 1.5), st.floats(0.2, 3.0), st.sampled_from([0.25, 10.0]))
def test_no_limit_is_passed(amount: float, lasts_s: float, hand_m_s: float) -> None:
    speed, bend, hand = peaks(run(*swing(amount, lasts_s), hand_m_s).q)
    assert speed <= 1.0
    assert bend <= 1.0
    assert hand <= hand_m_s


def test_the_hand_turns_no_faster_than_a_body_in_it_allows() -> None:
    u_s = np.arange(0.0, 2.0, 0.02)
    s = np.clip((u_s - 0.5) / 0.8, 0.0, 1.0)
    turn = 1.8 * s**3 * (10.0 - 15.0 * s + 6.0 * s * s)
    result = run(u_s, a465.READY + turn[:, None] * np.eye(6)[5], 10.0)
    hand = forward(result.q)
    rates = angle_between(hand[1:], hand[:-1]) * a465.CONTROL_HZ
    assert np.max(rates) <= TURN_RAD_S
    assert np.max(rates) > 0.8 * TURN_RAD_S


def test_a_motion_given_in_course_is_led_in_and_out_from_rest() -> None:
    u_s, q = swing(0.6, 3.0, rest_s=0.0)
    part = slice(60, 110)
    result = run(u_s[part], q[part])
    assert peaks(result.q)[1] <= 1.0
    np.testing.assert_allclose(result.q[0], q[60], atol=1e-9)
    np.testing.assert_allclose(result.q[-1], q[109], atol=1e-9)


def test_rests_keep_their_length() -> None:
    u_s, q = swing(1.2, 0.4, rest_s=1.0)
    result = run(u_s, q)
    still = np.abs(np.diff(result.q, axis=0)).max(axis=1) < 1e-6
    assert result.t_s[-1] > u_s[-1]
    assert np.sum(still) * 0.02 == pytest.approx(2.0, abs=0.12)


def test_the_hands_own_time_never_runs_back_or_ahead() -> None:
    result = run(*swing(1.0, 0.5))
    steps = np.diff(result.u_s)
    assert np.all(steps >= 0.0)
    assert np.all(steps <= 0.02 + 1e-9)
