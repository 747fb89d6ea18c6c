from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import Array, quat_from_rpy
from assistant.learning.jolts import jolts
from assistant.learning.smoothing import smooth
from assistant.model.demonstration import Recording
from assistant.model.settings import JoltSettings

GIVEN = JoltSettings()


def carried(*, gripper: bool = False, step_s: float = 0.05) -> Recording:
    """A hand that rests at 10 s and 20 s, grips and lets go there, and draws back after."""
    rng = np.random.default_rng(3)
    t_s = np.arange(0.0, 30.0, step_s, dtype=np.float64)
    x = np.interp(
        t_s, [0, 7, 9, 12, 17, 19, 20.6, 21.4, 30], [0, 0, 0.1, 0.1, 0.1, 0.2, 0.2, 0.1, 0.1]
    )
    roll = 0.08 / (1.0 + np.exp(-(t_s - 10.5) / 0.04)) - 0.1 / (1.0 + np.exp(-(t_s - 19.7) / 0.04))
    xyz = np.stack([x, 0.0 * x, 0.0 * x], axis=1) + rng.normal(0.0, 1e-4, (len(t_s), 3))
    rpy = np.stack([roll, 0.0 * x, 0.0 * x], axis=1) + rng.normal(0.0, 5e-4, (len(t_s), 3))
    opening: Array | None = np.full(len(t_s), 0.05) if gripper else None
    return Recording(t_s, np.hstack([xyz, quat_from_rpy(rpy)]), opening)


def strongest(recording: Recording, count: int) -> list[float]:
    found = jolts(recording, smooth(recording), GIVEN)
    return sorted(float(at) for at in found[np.argsort(-found[:, 1])][:count, 0])


@pytest.mark.parametrize("step_s", [0.05, 0.1, 0.2])
def test_gripping_and_letting_go_are_seen_in_the_wrist(step_s: float) -> None:
    assert strongest(carried(step_s=step_s), 2) == [
        pytest.approx(10.2, abs=0.5),
        pytest.approx(20.0, abs=0.3),
    ]


def test_letting_go_is_told_by_the_hand_that_draws_back() -> None:
    """Half the travel comes after the jolt of letting go."""
    assert strongest(carried(), 2)[1] > 19.8


def test_a_gripper_that_is_recorded_speaks_for_itself() -> None:
    recording = carried(gripper=True)
    assert len(jolts(recording, smooth(recording), GIVEN)) == 0


def test_slow_recordings_show_no_jolts() -> None:
    recording = carried(step_s=0.5)
    assert len(jolts(recording, smooth(recording), GIVEN)) == 0
