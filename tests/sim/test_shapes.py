"""Distances of boxes and segments agree with clouds of points."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import IDENTITY, Array, inverse, quat_normalize, transform_points
from assistant.model.scene import Body, Obstacle
from assistant.model.setup import Triple
from sim.shapes import body_box, box_at, boxes_apart, obstacle_box, segment_apart

SEEDS = st.integers(0, 10_000)


def random_pose(random: np.random.Generator, far: float) -> Array:
    return np.concatenate([random.uniform(-far, far, 3), quat_normalize(random.normal(size=4))])


def cloud(size: Array, count: int = 15) -> Array:
    axes = [np.linspace(-edge / 2, edge / 2, count) for edge in size]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)


def gap_to_box(points: Array, pose: Array, size: Array) -> float:
    local = np.abs(transform_points(inverse(pose), points)) - size / 2
    return float(np.min(np.linalg.norm(np.maximum(local, 0.0), axis=-1)))


@settings(max_examples=60, deadline=None)
@given(SEEDS)
def test_boxes_never_seem_further_apart_than_they_are(seed: int) -> None:
    random = np.random.default_rng(seed)
    first, second = random.uniform(0.05, 0.3, 3), random.uniform(0.05, 0.3, 3)
    at, other = random_pose(random, 0.35), random_pose(random, 0.05)
    apart = boxes_apart(box_at(at, (0.0, 0.0, 0.0), first), box_at(other, (0.0, 0.0, 0.0), second))
    true = gap_to_box(transform_points(at, cloud(first)), other, second)
    assert apart[0] <= true + 1e-9
    if apart[0] <= -0.01:
        # Deep enough that the cloud's grid must have a point inside.
        assert true < 0.02


@settings(max_examples=60, deadline=None)
@given(SEEDS)
def test_a_segment_is_as_far_from_a_box_as_its_points(seed: int) -> None:
    random = np.random.default_rng(seed)
    size, pose = random.uniform(0.05, 0.4, 3), random_pose(random, 0.1)
    start, end = random.uniform(-0.5, 0.5, (2, 3))
    found = segment_apart(start[None], end[None], box_at(pose, (0.0, 0.0, 0.0), size))
    true = gap_to_box(np.linspace(start, end, 2001), pose, size)
    # The points are so far apart that none need be the nearest.
    assert true - np.linalg.norm(end - start) / 4000 - 1e-9 <= found[0] <= true + 1e-9


@pytest.mark.parametrize("end", [(0.0, 0.0, 0.3), (0.4, 0.0, 0.3), (0.0, 0.0, 0.0)])
def test_a_segment_along_an_axis_or_without_length_is_measured_too(end: Triple) -> None:
    start = np.array([0.0, 0.0, 0.3])
    box = box_at(IDENTITY, (0.0, 0.0, 0.0), np.array([0.2, 0.2, 0.2]))
    found = segment_apart(start[None], np.array(end)[None], box)
    assert found[0] == pytest.approx(max(min(0.3, end[2]) - 0.1, 0.0), abs=1e-12)


def test_many_places_at_once_are_each_their_own() -> None:
    random = np.random.default_rng(3)
    poses = np.stack([random_pose(random, 0.3) for _ in range(7)])
    thing = box_at(random_pose(random, 0.1), (0.0, 0.0, 0.0), np.array([0.2, 0.1, 0.1]))
    many = boxes_apart(box_at(poses, (0.01, 0.0, 0.0), (0.1, 0.1, 0.2)), thing)
    for pose, apart in zip(poses, many, strict=True):
        one = boxes_apart(box_at(pose, (0.01, 0.0, 0.0), (0.1, 0.1, 0.2)), thing)
        np.testing.assert_allclose(one[0], apart, atol=1e-12)


def test_bodies_and_obstacles_stand_on_the_middle_of_their_base() -> None:
    body = body_box(Body("block"), np.array([1.0, 0.0, 0.2, 0.0, 0.0, 0.0, 1.0]))
    np.testing.assert_allclose(body.center, [[1.0, 0.0, 0.25]])
    post = obstacle_box(Obstacle("post", (50.0, 50.0, 400.0), (300.0, 0.0, 100.0)))
    np.testing.assert_allclose(post.center, [[0.3, 0.0, 0.3]])
