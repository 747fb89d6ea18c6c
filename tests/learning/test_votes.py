from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import Array, quat_from_rpy
from assistant.learning.votes import overall, peaks, poses_at, sharpness, vote
from assistant.model.settings import PAPER_VOTES, VoteSettings, paper


def line(count: int = 11) -> tuple[Array, Array]:
    """Ten seconds along x at 10 mm/s."""
    t_s = np.linspace(0.0, 10.0, count)
    path = np.zeros((count, 7))
    path[:, 0], path[:, 6] = 0.01 * t_s, 1.0
    return t_s, path


def test_a_vote_falls_off_with_the_square_of_the_distance() -> None:
    """Eq. (1) by hand: 10 mm from the candidate, c = 1/(2 V^2), V = 10 mm/s: exp(-1/2)."""
    t_s, path = line()
    sharp = sharpness("gripper", t_s, path, 4, PAPER_VOTES)
    assert sharp == pytest.approx(1.0 / (2.0 * 0.01**2))
    told = vote(t_s, path, np.array([5.0]), sharp, 0.1)
    assert told[5] == pytest.approx(1.0)
    assert told[4] == pytest.approx(np.exp(-0.5))
    assert told[7] == pytest.approx(np.exp(-2.0))


def test_the_papers_spreads() -> None:
    """V = 3.68 mm/s: kernels of 5, 26 and 104 mm (standard deviations, sqrt(spread/2) V)."""
    t_s, path = line()
    path[:, 0] *= 0.368
    for signal, width_mm in (("gripper", 3.68), ("speed", 18.4), ("cue", 73.6)):
        sharp = sharpness(signal, t_s, path, 4, PAPER_VOTES)
        assert np.sqrt(0.5 / sharp) * 1000.0 == pytest.approx(width_mm)


def test_the_papers_weights() -> None:
    assert dict(paper().votes.weights) == {"gripper": 0.52, "speed": 0.19, "cue": 0.29}
    votes = {"gripper": np.array([1.0, 0.0]), "cue": np.array([1.0, 1.0])}
    assert overall(votes, paper().votes.weights) == pytest.approx([0.81, 0.29])


def test_a_path_that_comes_back_gets_no_ghost_vote() -> None:
    t_s = np.linspace(0.0, 4.0, 401)
    path = np.zeros((401, 7))
    path[:, 0], path[:, 6] = 0.1 * np.sin(np.pi * t_s / 2.0), 1.0
    told = vote(t_s, path, np.array([0.1, 3.0]), 1e4, 0.1)
    back = np.argmin(np.abs(t_s - 1.9))
    assert path[back, 0] == pytest.approx(path[10, 0])
    assert told[back] < 1e-6
    assert told[10] == pytest.approx(1.0)


def test_turning_counts_with_its_stated_weight() -> None:
    t_s = np.array([0.0, 1.0])
    path = np.zeros((2, 7))
    path[:, 3:] = quat_from_rpy(np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.2]]))
    told = vote(t_s, path, np.array([0.0]), 100.0, 0.1)
    assert told[1] == pytest.approx(np.exp(-100.0 * 0.02**2))


def test_a_spread_is_relative_to_the_way_between_cuts() -> None:
    t_s, path = line()
    wide = path.copy()
    wide[:, 0] *= 7.0
    given = VoteSettings()
    near = vote(t_s, path, np.array([5.0]), sharpness("cue", t_s, path, 4, given), 0.1)
    far = vote(t_s, wide, np.array([5.0]), sharpness("cue", t_s, wide, 4, given), 0.1)
    assert near == pytest.approx(far)


def test_a_plateau_has_one_maximum() -> None:
    total = np.array([0.0, 0.5, 1.0, 1.0, 1.0, 0.5, 0.0, 0.6, 0.0])
    assert peaks(np.arange(9.0), total, 0.4) == pytest.approx([3.0, 7.0])
    trembling = total.copy()
    trembling[3] -= 1e-3
    trembling[4] -= 1e-4
    assert len(peaks(np.arange(9.0), trembling, 0.4)) == 2


def test_maxima_below_the_threshold_do_not_count() -> None:
    total = np.array([0.0, 1.0, 0.0, 0.3, 0.0])
    assert peaks(np.arange(5.0), total, float(np.mean(total)) + 0.1) == pytest.approx([1.0])
    assert len(peaks(np.arange(5.0), np.zeros(5), 0.0)) == 0


def test_no_candidates_no_votes() -> None:
    t_s, path = line()
    assert not np.any(vote(t_s, path, np.zeros(0), 1.0, 0.1))


def test_poses_between_samples() -> None:
    t_s, path = line()
    assert poses_at(t_s, path, np.array([2.5]))[0, 0] == pytest.approx(0.025)
