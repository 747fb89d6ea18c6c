from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.learning.cue_lag import Lag
from assistant.learning.following import Following, following, jogged
from assistant.model.settings import CueSettings
from tests.generators import generator_a, generator_b

MEANT_S = np.array([3.0, 5.0, 8.0, 9.0, 12.0, 15.0, 16.0, 19.0])
ACTED = np.array([False, True, False, False, True, False, True, False])
END_S = 22.0


def told(late_s: float, lag_s: float = 0.8, given: CueSettings | None = None) -> Following:
    rng = np.random.default_rng(5)
    cues_s = MEANT_S + lag_s + rng.normal(0.0, 0.08, len(MEANT_S))
    shown_s = np.where(ACTED, MEANT_S, MEANT_S + late_s)
    blur_s = np.where(ACTED, 0.0, 0.08)
    # As it is known before: from what is shown, gripper and rests together.
    mean_s = float(np.mean(cues_s - shown_s))
    lag = Lag(np.array([mean_s]), np.ones(1), 0.15)
    return following(cues_s, shown_s, blur_s, ACTED, END_S, lag, given or CueSettings())


@pytest.mark.parametrize("late_s", [0.3, 0.4])
def test_how_late_the_hand_follows_and_the_teacher_speaks_is_told_apart(late_s: float) -> None:
    found = told(late_s)
    assert found.late_s == pytest.approx(late_s, abs=0.1)
    assert found.lag.best_s == pytest.approx(0.8, abs=0.1)


def test_a_hand_that_is_not_late_is_not_said_to_be() -> None:
    found = told(0.0)
    assert found.late_s < 0.05
    assert found.lag.best_s == pytest.approx(0.8, abs=0.06)


def test_who_never_follows_late_is_taken_to_speak_late() -> None:
    given = replace(CueSettings(), late_share=1e-12)
    assert told(0.3, given=given).late_s < 1e-6


@pytest.mark.parametrize("acted", [np.zeros(3, bool), np.ones(3, bool)])
def test_without_both_kinds_of_cuts_nothing_is_told(
    acted: np.ndarray[tuple[int], np.dtype[np.bool_]],
) -> None:
    lag = Lag(np.array([0.5]), np.ones(1), 0.15)
    at_s = np.array([1.0, 2.0, 3.0])
    found = following(at_s + 0.5, at_s, np.full(3, 0.1), acted, 4.0, lag, CueSettings())
    assert (found.late_s, found.lag) == (0.0, lag)


@pytest.mark.parametrize("seed", range(70_050, 70_053))
def test_a_hand_that_is_jogged_is_told_from_one_that_is_not(seed: int) -> None:
    for generate in (generator_a.generate, generator_b.generate):
        assert jogged(generate(seed, "keys").demonstration.recording)
        assert not jogged(generate(seed, "fluent").demonstration.recording)
        assert not jogged(generate(seed, "slow").demonstration.recording)
