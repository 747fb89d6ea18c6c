"""Free stretches are kept where they can be and led around where not."""

from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import Array
from sim.branches import answers
from sim.kinematics import forward, limit_margin
from sim.routes import FAST, Stretch, bad_samples, route
from sim.timing import timed
from tests.sim.hand_paths import TABLE1

SAMPLES = 150
BRANCH = 1


def stretch(gap: float | None = None) -> tuple[Stretch, Array]:
    """Return a sweep of the hand across the table; `gap` is where a wall stands in y."""
    s = np.linspace(0.0, 1.0, SAMPLES)
    s = s**3 * (10.0 - 15.0 * s + 6.0 * s * s)
    poses = np.repeat(TABLE1[3].robot_start.pose[None], SAMPLES, axis=0)
    poses[:, 1] += s * 0.4
    kept = answers(poses).q[:, BRANCH]

    def free(q: Array) -> Array:
        place = forward(q)[:, :3]
        low = place[:, 2] < 0.36
        walled = np.abs(place[:, 1] - gap) < 0.03 if gap is not None else np.zeros(len(q), bool)
        return np.where(low & walled, -0.01, 0.05)

    return Stretch(np.linspace(0.0, 5.0, SAMPLES), poses, BRANCH, kept[0], kept[-1], free), kept


def test_a_good_stretch_is_kept() -> None:
    free, kept = stretch()
    way = route(free, kept)
    assert way is not None
    np.testing.assert_array_equal(way[0], kept)
    assert way[1] == ""


def test_a_wall_is_passed_over_between_the_same_ends() -> None:
    walled, kept = stretch(-0.05)
    way = route(walled, kept)
    assert way is not None
    q, how = way
    assert how
    assert walled.gap(q).min() > 0.0
    assert limit_margin(q).min() >= 0.0
    np.testing.assert_allclose(q[[0, -1]], kept[[0, -1]])
    assert np.abs(np.diff(q, axis=0)).max() < 0.3


def test_missing_answers_are_bridged() -> None:
    free, kept = stretch()
    kept[60:80] = np.nan
    way = route(free, kept)
    assert way is not None
    assert np.isfinite(way[0]).all()
    np.testing.assert_array_equal(way[0][:40], kept[:40])


def test_a_spinning_wrist_is_found_bad() -> None:
    free, kept = stretch()
    assert not bad_samples(free, kept).any()
    kept[70:, 3] += 1.0
    assert bad_samples(free, kept)[69:71].all()
    assert FAST > 1.0


def test_what_is_closed_has_no_way() -> None:
    free, kept = stretch()
    closed = Stretch(
        free.u_s, free.poses, BRANCH, kept[0], kept[-1], lambda q: np.full(len(q), -1.0)
    )
    assert route(closed, kept) is None


@pytest.mark.parametrize("at_rad", [0.42, 0.5, 0.58])
def test_a_thin_wall_is_not_passed_between_two_samples(at_rad: float) -> None:
    free, kept = stretch()
    kept[SAMPLES // 2 :, 0] += 1.0
    begin = float(kept[SAMPLES // 2 - 1, 0])

    def walled(q: Array) -> Array:
        return np.abs(q[:, 0] - begin - at_rad) - 0.03

    thin = Stretch(free.u_s, free.poses, BRANCH, kept[0], kept[-1], walled)
    assert route(thin, kept) is None


def test_a_way_around_can_be_timed() -> None:
    walled, kept = stretch(-0.05)
    way = route(walled, kept)
    assert way is not None
    result = timed(walled.u_s, way[0], forward(way[0])[:, :3], 0.25)
    assert result.t_s[-1] < 15.0
