from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.files.demonstrations import read_demonstration
from assistant.files.scenes import find_scene
from assistant.files.tasks import read_task
from assistant.geometry import Array, pose_from_mm_deg
from assistant.learning.adaptation import plan_adaptation
from assistant.learning.generalization import sampled, shown_jerk
from assistant.learning.lesson import learn
from assistant.learning.smoothing import Smoothed, smooth
from assistant.learning.timing import rms_jerk
from assistant.learning.weights import least_jerk
from assistant.model.demonstration import Recording

TASKS = Path(__file__).parents[2] / "tasks"


def touched(rest_s: float, away_s: float, drift_m: float) -> tuple[Smoothed, float]:
    """Return a hand that comes, rests with a small drift, and sets off, and when it acts."""
    t_s = np.arange(0.0, 5.0 + rest_s, 0.02)
    come = least_jerk((t_s - 0.5) / 1.5)
    gone = least_jerk((t_s - 2.0 - rest_s) / away_s)
    drift = least_jerk((t_s - 2.0) / rest_s)
    xyz_mm = np.stack([200.0 * come - 120.0 * gone, 1000.0 * drift_m * drift, 40.0 * gone], axis=1)
    path = pose_from_mm_deg(xyz_mm + np.array([400.0, 0.0, 300.0]), np.zeros((len(t_s), 3)))
    return smooth(Recording(t_s, path)), 2.0 + rest_s / 2.0


@given(
    rest_s=st.floats(0.3, 0.8),
    away_s=st.floats(0.5, 1.5),
    drift_m=st.floats(0.0, 0.002),
)
@settings(max_examples=30, deadline=None)
def test_a_rest_costs_no_jerk_however_briefly_the_hand_rested(
    rest_s: float, away_s: float, drift_m: float
) -> None:
    smoothed, at_s = touched(rest_s, away_s, drift_m)
    even = sampled(smoothed, [at_s])
    at, reach = even.acts[0], round(0.2 / 0.02) - 1
    resting = even.path[at - reach : at + reach + 1, :3]
    assert np.max(np.abs(resting - even.path[at, :3])) < 1e-12
    assert jerk(even.path) <= 1.15 * shown_jerk(smoothed, 0.02)


@pytest.mark.parametrize("name", ["pushing", "wiping"])
def test_what_was_shown_without_a_gripper_keeps_its_jerk(name: str) -> None:
    path = TASKS / "demonstrations" / f"{name}.yaml"
    task, shown = read_task(TASKS / f"{name}.yaml"), read_demonstration(path)
    lesson = learn([shown], task, scene=find_scene(shown.setup.scene, path))
    assert lesson.jerk_m_s3 is not None
    plan = plan_adaptation(replace(task, learned=lesson))
    assert jerk(plan.ways.path) <= 1.05 * lesson.jerk_m_s3


def jerk(path: Array) -> float:
    return rms_jerk(path[:, :3], 0.02)
