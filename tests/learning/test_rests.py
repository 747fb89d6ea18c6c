from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from assistant.learning.rests import Halt, braked, demonstrated_times, new_instant


def test_braking_ends_at_rest_with_no_kink() -> None:
    share = np.linspace(0.0, 1.0, 1001)
    way = braked(share)
    speed = np.gradient(way, share)
    assert way[0] == 0.0
    assert way[-1] == 1.0
    assert abs(speed[0] - 2.0) < 0.01
    assert abs(speed[-1]) < 0.01
    assert np.all(np.diff(way) >= 0.0)


@given(
    at_s=st.lists(st.floats(1.0, 9.0), min_size=1, max_size=3, unique=True),
    eased=st.booleans(),
    stay_s=st.floats(0.0, 1.0),
)
def test_the_new_clock_runs_forward_and_stays_at_each_halt(
    at_s: list[float], eased: bool, stay_s: float
) -> None:
    reach = 0.3 if eased else 0.0
    halts = [Halt(at, reach, reach, stay_s) for at in sorted(at_s)]
    new_s = np.arange(0.0, 15.0, 0.01)
    shown_s = demonstrated_times(halts, 0.0, 10.0, new_s)
    assert shown_s[0] == 0.0
    assert np.all(np.diff(shown_s) >= -1e-9)
    assert shown_s[-1] == 10.0
    for k, halt in enumerate(halts):
        instant = np.array([new_instant(halts, 0.0, 10.0, k)])
        assert abs(demonstrated_times(halts, 0.0, 10.0, instant)[0] - halt.at_s) < 1e-9


def test_without_halts_nothing_changes() -> None:
    new_s = np.linspace(0.0, 5.0, 20)
    assert np.allclose(demonstrated_times([], 2.0, 7.0, new_s), new_s + 2.0)
