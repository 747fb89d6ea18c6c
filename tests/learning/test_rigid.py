from __future__ import annotations

import math

import numpy as np
import pytest

from assistant.geometry import (
    Array,
    compose,
    inverse,
    pose_from_mm_deg,
    quat_from_rotvec,
    quat_multiply,
    quat_to_matrix,
    rotate_vector,
)
from assistant.learning import rigid


def random_pose(seed: int) -> Array:
    rng = np.random.default_rng(seed)
    return np.concatenate([rng.normal(size=3), quat_from_rotvec(rng.normal(size=3))])


@pytest.mark.parametrize("seed", range(5))
def test_floats_agree_with_arrays(seed: int) -> None:
    a, b = random_pose(seed), random_pose(seed + 100)
    assert np.allclose(rigid.composed(a.tolist(), b.tolist()), compose(a, b), atol=1e-14)
    assert np.allclose(rigid.inverted(a.tolist()), inverse(a), atol=1e-14)
    assert np.allclose(rigid.matrix(a[3:].tolist()), quat_to_matrix(a[3:]), atol=1e-14)
    product = np.reshape(rigid.left_factor(a[3:].tolist()), (4, 4)) @ b[3:]
    assert np.allclose(product, quat_multiply(a[3:], b[3:]), atol=1e-14)
    turned = rigid.turned(a[3:].tolist(), b[:3].tolist())
    assert np.allclose(turned, rotate_vector(a[3:], b[:3]), atol=1e-14)


@pytest.mark.parametrize("seed", range(5))
def test_told_poses_agree_with_arrays(seed: int) -> None:
    rng = np.random.default_rng(seed)
    xyz, rpy = rng.uniform(-500, 500, 3).tolist(), rng.uniform(-180, 180, 3).tolist()
    assert np.allclose(rigid.placed(xyz, rpy), pose_from_mm_deg(xyz, rpy), atol=1e-15)


def test_a_half_turn_is_made_to_the_left() -> None:
    for sign in (1.0, -1.0):
        axis, angle = rigid.arc([0.0, 0.0, sign, 0.0])
        assert angle == pytest.approx(math.pi)
        assert axis == [0.0, 0.0, 1.0]


def test_no_turn_has_no_axis() -> None:
    assert rigid.arc([0.0, 0.0, 0.0, -1.0]) == ([0.0, 0.0, 0.0], 0.0)
