"""From a smoothed demonstration to the learned path, evenly sampled (paper III-C b, eq. 5)."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, interpolate, quat_continuous, quat_normalize
from assistant.learning.rests import Halt, demonstrated_times, new_instant
from assistant.learning.smoothing import Smoothed
from assistant.learning.timing import rms_jerk
from assistant.learning.weights import six_order
from assistant.model.lesson import Episode
from assistant.model.settings import GeneralizationSettings

Indices = np.ndarray[tuple[int], np.dtype[np.int64]]


@dataclass(frozen=True, slots=True, eq=False)
class Sampled:
    """The demonstration evenly sampled, at rest wherever the hand acts.

    Parameters
    ----------
    t_s : array, shape (n,)
        From 0.
    shown_s : array, shape (n,)
        The same instants on the demonstration's clock.
    path : array, shape (n, 7)
    gripper_m : array, shape (n,), or None
    acts : tuple of int
        Samples at which the hand closed or opened.
    """

    t_s: Array
    shown_s: Array
    path: Array
    gripper_m: Array | None
    acts: tuple[int, ...]


def sampled(
    smoothed: Smoothed, acts_s: Sequence[float], given: GeneralizationSettings | None = None
) -> Sampled:
    """Return the demonstration evenly sampled.

    Parameters
    ----------
    smoothed : Smoothed
    acts_s : sequence of float
        When the hand closed or opened, in order.
    given : GeneralizationSettings, optional
    """
    given = given or GeneralizationSettings()
    begin_s, end_s = float(smoothed.t_s[0]), float(smoothed.t_s[-1])
    halts = [_end_halt(smoothed, begin_s, given)]
    halts += [_halt(smoothed, at_s, given) for at_s in acts_s]
    halts.append(_end_halt(smoothed, end_s, given))
    length = new_instant(halts, begin_s, end_s, len(halts) - 1)
    step_s = max(given.step_s, length / given.most_samples)
    t_s = step_s * np.arange(int(np.ceil(length / step_s - 1e-9)) + 1, dtype=np.float64)
    shown_s = demonstrated_times(halts, begin_s, end_s, t_s)
    path = _at(smoothed, shown_s)
    instants = [new_instant(halts, begin_s, end_s, k + 1) for k in range(len(acts_s))]
    poses = _at(smoothed, np.array(acts_s)) if len(acts_s) else np.zeros((0, 7))
    for instant, pose in zip(instants, poses, strict=True):
        path = _resting(path, t_s - instant, pose, given)
    acts = tuple(int(np.clip(round(at / step_s), 0, len(t_s) - 1)) for at in instants)
    gripper_m = _gripper(smoothed, acts_s, acts, len(t_s), round(given.dwell_s / step_s))
    return Sampled(t_s, shown_s, _signed(path), gripper_m, acts)


def shown_jerk(smoothed: Smoothed, step_s: float) -> float:
    """Return the root-mean-square jerk of the smoothed demonstration itself, in m/s^3."""
    even_s = np.arange(smoothed.t_s[0], smoothed.t_s[-1], step_s)
    return rms_jerk(_at(smoothed, even_s)[:, :3], step_s) if len(even_s) > 3 else 0.0


def primitive_at(shown_s: Array, episodes: Sequence[Episode], leaves: Sequence[str]) -> Indices:
    """Return, for each instant of the demonstration, the position of its primitive, or -1."""
    out = np.full(len(shown_s), -1, dtype=np.int64)
    for episode in episodes:
        inside = (shown_s >= episode.from_s - 1e-9) & (shown_s <= episode.to_s + 1e-9)
        out[inside] = leaves.index(episode.primitive) if episode.primitive in leaves else -1
    return out


def _at(smoothed: Smoothed, shown_s: Array) -> Array:
    from scipy.interpolate import CubicSpline

    path = np.hstack([smoothed.path[:, :3], quat_continuous(smoothed.path[:, 3:])])
    poses = np.asarray(CubicSpline(smoothed.t_s, path)(shown_s), dtype=float)
    poses[:, 3:] = quat_normalize(poses[:, 3:])
    return poses


def _signed(path: Array) -> Array:
    return np.hstack([path[:, :3], quat_continuous(path[:, 3:])])


def _halt(smoothed: Smoothed, at_s: float, given: GeneralizationSettings) -> Halt:
    speed = smoothed.speed
    if float(np.interp(at_s, smoothed.t_s, speed)) > given.rest_m_s:
        return Halt(at_s, given.easing_s, given.easing_s, given.dwell_s)
    begin_s, end_s = _still(smoothed.t_s, speed, at_s, given.rest_m_s)
    lacking = given.dwell_s / 2.0 - min(at_s - begin_s, end_s - at_s)
    return Halt(at_s, 0.0, 0.0, 2.0 * max(lacking, 0.0))


def _still(t_s: Array, speed: Array, at_s: float, rest_m_s: float) -> tuple[float, float]:
    """Return from when to when the hand rests about an instant.

    A motion begins where its speed begins to rise, not where it is fast already: a rest held
    beyond that would start it, or end it, with a jerk.
    """
    moving = np.flatnonzero(speed > rest_m_s)
    before, after = moving[t_s[moving] < at_s], moving[t_s[moving] > at_s]
    first, last = (int(before[-1]) if len(before) else 0), (int(after[0]) if len(after) else -1)
    last %= len(t_s)
    while first + 1 < len(t_s) and t_s[first + 1] < at_s and speed[first + 1] < speed[first]:
        first += 1
    while last > 0 and t_s[last - 1] > at_s and speed[last - 1] < speed[last]:
        last -= 1
    return float(t_s[first]), float(t_s[last])


def _end_halt(smoothed: Smoothed, at_s: float, given: GeneralizationSettings) -> Halt:
    moving = float(np.interp(at_s, smoothed.t_s, smoothed.speed)) > given.rest_m_s
    eased = given.easing_s if moving else 0.0
    first = at_s == smoothed.t_s[0]
    return Halt(at_s, 0.0 if first else eased, eased if first else 0.0, 0.0)


def _resting(path: Array, after_s: Array, pose: Array, given: GeneralizationSettings) -> Array:
    """Return the path with the hand perfectly still around an instant."""
    beyond = (np.abs(after_s) - given.dwell_s / 2.0) / given.easing_s
    near = np.flatnonzero(beyond < 1.0)
    out = path.copy()
    # What is taken back is what the hand strayed from the pose within the rest itself, and the
    # speed it has at its end: so a hand that moves on sets off from rest and is not pulled back.
    edge = np.clip(after_s[near], -given.dwell_s / 2.0, given.dwell_s / 2.0)
    inside = np.abs(after_s) <= given.dwell_s / 2.0 + 1e-12
    rests = np.flatnonzero(inside)
    anchors = rests[np.clip(np.searchsorted(after_s[rests], edge), 0, len(rests) - 1)]
    outward = np.clip(anchors + np.where(after_s[near] < 0.0, -1, 1), 0, len(path) - 1)
    steps = np.abs(near - anchors)[:, None] * (path[outward, :3] - path[anchors, :3])
    weight = 1.0 - six_order(np.maximum(beyond[near], 0.0))
    shifted = path[near]
    shifted[:, :3] += weight[:, None] * (pose[:3] - path[anchors, :3] - steps)
    turned = interpolate(path[near], pose[None, :], weight)
    shifted[:, 3:] = turned[:, 3:]
    out[near] = shifted
    out[rests] = pose
    return out


def _gripper(
    smoothed: Smoothed, acts_s: Sequence[float], acts: Sequence[int], samples: int, ramp: int
) -> Array | None:
    """Return the opening, level between the acts, with a ramp around each."""
    if smoothed.gripper_m is None:
        return None
    edges_s = [-np.inf, *acts_s, np.inf]
    levels = []
    for from_s, to_s in itertools.pairwise(edges_s):
        inside = smoothed.gripper_m[(smoothed.t_s > from_s) & (smoothed.t_s < to_s)]
        levels.append(float(np.median(inside)) if len(inside) else float(smoothed.gripper_m[-1]))
    knots: list[float] = []
    values: list[float] = []
    for k, at in enumerate(acts):
        knots += [at - ramp / 2.0, at + ramp / 2.0]
        values += [levels[k], levels[k + 1]]
    if not knots:
        return np.full(samples, levels[0])
    return np.interp(np.arange(samples), knots, values)
