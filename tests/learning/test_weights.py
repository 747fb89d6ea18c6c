from __future__ import annotations

import numpy as np
from hypothesis import example, given, settings
from hypothesis import strategies as st

from assistant.learning.weights import frame_weights, least_jerk, six_order
from tests.learning.lessons import lesson


def test_six_order_goes_from_0_to_1_without_a_kink() -> None:
    assert six_order(0.0) == 0.0
    assert six_order(1.0) == 1.0
    assert np.all(np.diff(six_order(np.linspace(0, 1, 200))) > 0)
    h = 1e-3
    for end, inward in ((0.0, 1.0), (1.0, -1.0)):
        near = six_order(end + inward * h * np.arange(4))
        assert abs(near[1] - near[0]) / h < 1e-4
        assert abs(near[2] - 2 * near[1] + near[0]) / h**2 < 0.2
    # At the docking end the third derivative vanishes too.
    docking = six_order(1.0 - h * np.arange(4))
    assert abs(np.diff(docking, n=3)[0]) / h**3 < 1.0


@given(st.floats(-1.0, 2.0))
def test_both_polynomials_stay_within_0_and_1(share: float) -> None:
    assert -1e-12 <= six_order(share) <= 1.0 + 1e-12
    assert -1e-12 <= least_jerk(share) <= 1.0 + 1e-12


def stations() -> tuple[np.ndarray[tuple[int, ...], np.dtype[np.float64]], list[tuple[int, int]]]:
    made = lesson()
    assert made.path is not None
    return made.path.path[:, :3], [(one.docking_at, one.at) for one in made.stations]


def test_lambda1_is_1_from_docking_through_grasp_and_release() -> None:
    xyz, stretches = stations()
    weights = frame_weights(xyz, tuple(stretches))
    for docking_at, at in stretches:
        assert np.all(weights.lambda1[docking_at : at + 1] == 1.0)
    between = weights.lambda1[stretches[0][1] : stretches[1][0]]
    assert np.min(between) == 0.0


def test_lambda2_starts_at_1_and_is_0_before_lambda1_reaches_a_half() -> None:
    xyz, stretches = stations()
    weights = frame_weights(xyz, tuple(stretches))
    begin = 0
    for docking_at, at in stretches:
        assert weights.lambda2[begin] == 1.0
        way = slice(begin, docking_at + 1)
        rising = weights.near[way] == weights.near[docking_at]
        half = begin + int(np.argmax(rising & (weights.lambda1[way] >= 0.5)))
        assert np.all(weights.lambda2[half : docking_at + 1] == 0.0)
        begin = at


@given(seed=st.integers(0, 1000))
@example(seed=282)
@settings(max_examples=10, deadline=None)
def test_weights_hold_for_any_number_of_stations(seed: int) -> None:
    rng = np.random.default_rng(seed)
    xyz = np.cumsum(rng.normal(0.0, 0.01, (400, 3)), axis=0)
    ats = np.sort(rng.choice(np.arange(40, 390, 20), rng.integers(1, 6), replace=False))
    weights = frame_weights(xyz, tuple((int(at) - 10, int(at)) for at in ats))
    assert np.all((weights.lambda1 >= 0) & (weights.lambda1 <= 1))
    assert np.all((weights.lambda2 >= 0) & (weights.lambda2 <= 1))
    for at in ats:
        assert np.all(weights.lambda1[at - 10 : at + 1] == 1.0)
