from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.learning.cue_lag import estimate, modes, refined, support
from assistant.model.settings import CueSettings

CUTS = np.array([2.0, 4.3, 9.1, 11.0, 15.7, 18.2])
BLUR = np.full(6, 0.05)


@given(lag_s=st.floats(0.15, 1.8), seed=st.integers(0, 1000))
@settings(max_examples=20, deadline=None)
def test_the_lag_is_found_with_false_and_missing_cues(lag_s: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    cues = np.append(CUTS[rng.permutation(6)[:5]] + lag_s + rng.normal(0, 0.05, 5), 13.3)
    lag = estimate(np.sort(cues), CUTS, BLUR, np.full(6, 0.9), 20.0, CueSettings())
    likely = [way.best_s for way, _ in modes(lag)]
    assert min(abs(way - lag_s) for way in likely) < 0.12


def test_a_steady_teacher_is_known_to_be_steady() -> None:
    steady = estimate(CUTS + 0.7, CUTS, 0.0 * BLUR, np.ones(6), 20.0, CueSettings())
    wobble = np.array([-0.3, 0.25, -0.2, 0.3, -0.25, 0.2])
    loose = estimate(CUTS + 0.7 + wobble, CUTS, 0.0 * BLUR, np.ones(6), 20.0, CueSettings())
    assert steady.jitter_s < loose.jitter_s


def test_without_cues_the_lag_is_what_is_usual() -> None:
    lag = estimate(np.zeros(0), CUTS, BLUR, np.ones(6), 20.0, CueSettings())
    assert np.sum(lag.chances) == pytest.approx(1.0)
    assert lag.best_s == pytest.approx(CueSettings().usual_lag_s, abs=0.1)


def test_a_cue_speaks_for_a_cut_before_it_and_for_one_only() -> None:
    lag = modes(estimate(CUTS + 0.7, CUTS, BLUR, np.ones(6), 20.0, CueSettings()))[0][0]
    spots = np.array([9.1, 9.2, 9.8, 14.0])
    alone, shared = support(np.array([9.8]), spots, 0.05 * np.ones(4), lag, 0.1, 0.02)
    assert alone[0] > 0.5
    assert alone[2] == pytest.approx(np.log(0.1), abs=0.1)
    assert alone[3] == pytest.approx(np.log(0.1))
    assert shared[0, 1] > 0.5
    assert shared[0, 3] == pytest.approx(0.0, abs=1e-9)


def test_without_cues_nothing_is_said() -> None:
    lag = estimate(np.zeros(0), CUTS, BLUR, np.ones(6), 20.0, CueSettings())
    alone, shared = support(np.zeros(0), CUTS, BLUR, lag, 0.1, 0.02)
    assert not np.any(alone)
    assert not np.any(shared)


def test_a_blurred_cut_moves_to_the_cue_and_a_sharp_one_stays() -> None:
    lag = modes(estimate(CUTS + 0.7, CUTS, BLUR, np.ones(6), 20.0, CueSettings()))[0][0]
    moved = refined(np.array([5.4, 8.4]), np.array([5.0, 8.0]), np.array([0.8, 0.001]), lag)
    assert moved[0] == pytest.approx(5.4 - lag.best_s, abs=0.05)
    assert moved[1] == pytest.approx(8.0, abs=1e-3)
    far = refined(np.array([9.9]), np.array([5.0]), np.array([0.3]), lag)
    assert far[0] == 5.0
