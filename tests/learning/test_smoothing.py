from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import Array, angle_between, quat_from_rpy, quat_multiply
from assistant.learning.smoothing import smooth
from assistant.model.demonstration import Recording
from assistant.model.settings import SmoothingSettings


def steps(samples: int, step_s: float) -> Array:
    return np.arange(samples, dtype=np.float64) * step_s


def wavy(t_s: Array) -> Array:
    phase = 2.0 * np.pi * 0.3 * t_s
    xyz = np.stack([0.1 * np.sin(phase), 0.1 * np.cos(phase), 0.05 * np.sin(2 * phase)], axis=1)
    quats = quat_from_rpy(np.stack([np.sin(phase), 0.5 * np.cos(phase), 2.0 * phase], axis=1))
    return np.hstack([xyz, quats])


@given(seed=st.integers(0, 10_000), jitter=st.sampled_from([0.0, 0.4]))
@settings(max_examples=8, deadline=None)
def test_noise_goes_and_motion_stays(seed: int, jitter: float) -> None:
    rng = np.random.default_rng(seed)
    t_s = steps(300, 0.02) + rng.uniform(0.0, jitter * 0.02, 300)
    true = wavy(t_s)
    noisy = true.copy()
    noisy[:, :3] += rng.normal(0.0, 5e-4, (300, 3))
    noisy[:, 3:] *= rng.choice([-1.0, 1.0], 300)[:, None]
    smoothed = smooth(Recording(t_s, noisy))
    before = np.sqrt(np.mean((noisy[:, :3] - true[:, :3]) ** 2))
    after = np.sqrt(np.mean((smoothed.path[:, :3] - true[:, :3]) ** 2))
    assert after < 0.6 * before
    assert np.max(angle_between(smoothed.path, true)) < 0.01
    rate = np.gradient(true[:, :3], t_s, axis=0)
    assert np.max(np.abs(smoothed.velocity - rate)[10:-10]) < 0.02


def test_a_steady_turn_has_its_rate_in_the_hands_frame() -> None:
    t_s = steps(200, 0.02)
    rolled = quat_from_rpy(np.stack([0 * t_s + 0.4, 0 * t_s, 0 * t_s], axis=1))
    turned = quat_from_rpy(np.stack([0.4 + 2.0 * t_s, 0 * t_s, 0 * t_s], axis=1))
    assert not np.allclose(rolled, turned)
    smoothed = smooth(Recording(t_s, np.hstack([np.zeros((200, 3)), turned])))
    assert smoothed.turn_rate == pytest.approx(np.tile([2.0, 0.0, 0.0], (200, 1)), abs=1e-3)


def test_equal_times_are_averaged_and_gaps_are_told() -> None:
    t_s = np.array([0.0, 0.02, 0.02, 0.04, 0.06, 0.08, 1.5, 1.52])
    path = wavy(t_s)
    path[2, 0] += 0.01
    smoothed = smooth(Recording(t_s, path, np.arange(8.0)), SmoothingSettings(cutoff_hz=1e3))
    assert smoothed.t_s == pytest.approx([0.0, 0.02, 0.04, 0.06, 0.08, 1.5, 1.52])
    assert smoothed.path[1, 0] == pytest.approx(path[1, 0] + 0.005, abs=1e-4)
    assert smoothed.gripper_m is not None
    assert smoothed.gripper_m[1] == 1.0
    assert smoothed.gaps_s == ((0.08, 1.5),)


@pytest.mark.parametrize("samples", [1, 2, 3])
def test_few_samples_pass(samples: int) -> None:
    t_s = steps(samples, 0.5)
    smoothed = smooth(Recording(t_s, wavy(t_s)))
    assert smoothed.path == pytest.approx(wavy(t_s), abs=1e-2)
    assert np.all(np.isfinite(smoothed.velocity))


def test_very_many_samples_are_thinned() -> None:
    t_s = steps(50_000, 0.001)
    smoothed = smooth(Recording(t_s, wavy(t_s)), SmoothingSettings(most_samples=2_000))
    assert len(smoothed.t_s) == 2_000
    assert np.max(np.abs(smoothed.path - wavy(smoothed.t_s))[5:-5, :3]) < 1e-3


def test_what_is_returned_cannot_be_changed() -> None:
    smoothed = smooth(Recording(steps(4, 1.0), wavy(steps(4, 1.0))))
    with pytest.raises(ValueError, match="read-only"):
        smoothed.path[0, 0] = 1.0


@given(
    at=st.integers(2, 297),
    off_m=st.floats(0.02, 2.0),
    turned_rad=st.sampled_from([0.0, 0.5, 3.0]),
    step_s=st.sampled_from([0.004, 0.02, 0.04]),
)
@settings(max_examples=10, deadline=None)
def test_a_tracker_that_is_wrong_for_one_sample_bends_no_path(
    at: int, off_m: float, turned_rad: float, step_s: float
) -> None:
    t_s = steps(300, step_s)
    true = wavy(t_s)
    wrong = true.copy()
    wrong[at, :3] += np.array([0.6, -0.8, 0.0]) * off_m
    spin = quat_from_rpy(np.array([turned_rad, 0.0, 0.0]))
    wrong[at, 3:] = quat_multiply(wrong[at, 3:], spin)
    found, told = smooth(Recording(t_s, wrong)), smooth(Recording(t_s, true))
    assert found.path[:, :3] == pytest.approx(told.path[:, :3], abs=1e-3)
    assert np.max(angle_between(found.path, told.path)) < 0.02


def test_what_a_hand_can_do_is_left_as_it_was_shown() -> None:
    """A stroke there and back in a tenth of a second, and a start from rest to full speed."""
    t_s = steps(100, 0.02)
    path = wavy(t_s)
    path[40:46, 2] += 0.02 * np.array([0.3, 0.8, 1.0, 1.0, 0.8, 0.3])
    path[70:, 0] += 0.01 * np.arange(30)
    sharp = SmoothingSettings(cutoff_hz=1e3)
    smoothed = smooth(Recording(t_s, path), sharp)
    assert smoothed.path[:, :3] == pytest.approx(path[:, :3], abs=2e-4)
