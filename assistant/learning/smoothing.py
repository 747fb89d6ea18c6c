"""Kalman (RTS) smoothing of the tracked hand: design, "Learning, step by step".

Each of six coordinates (place, and the turning of the hand) follows a model of constant
acceleration disturbed by white jerk. All six share one ratio of disturbance to noise, hence
one sequence of gains, so that the states of all of them are carried as one 3 by 6 matrix and
the covariances, the slow part, are followed once and no further than until they settle.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from assistant.geometry import (
    Array,
    angle_between,
    distance_between,
    interpolate,
    quat_from_rotvec,
    quat_inverse,
    quat_multiply,
    quat_normalize,
    quat_to_rotvec,
)
from assistant.model.demonstration import Recording, frozen_array
from assistant.model.settings import SmoothingSettings

_PLACE_ONLY = np.array([[1.0, 0.0, 0.0]])
_SAME_STEP = 0.1
_SETTLED = 1e-6
_MOST_M_S2 = 20.0
"""A hand that shows something never turns back as sharply as this, from one sample to the next."""
_SPIKE_M = 0.01
"""What is less is noise, which the smoother sees to."""
_TURN_M = 0.1
"""Metres that count like one radian."""


@dataclass(frozen=True, slots=True, eq=False)
class Smoothed:
    """The demonstration without the tracker's noise.

    Parameters
    ----------
    t_s : array, shape (n,)
        Strictly increasing; samples with equal times are one.
    path : array, shape (n, 7)
        xyz in m, quaternion xyzw.
    velocity, acceleration : array, shape (n, 3)
        In the base frame, m/s and m/s^2.
    turn_rate : array, shape (n, 3)
        In the hand's frame, rad/s.
    gripper_m : array, shape (n,), or None
        As recorded.
    gaps_s : tuple of (from, to)
        Stretches without samples, longer than the settings allow.
    """

    t_s: Array
    path: Array
    velocity: Array
    acceleration: Array
    turn_rate: Array
    gripper_m: Array | None
    gaps_s: tuple[tuple[float, float], ...] = ()

    def __post_init__(self) -> None:
        for name in ("t_s", "path", "velocity", "acceleration", "turn_rate"):
            object.__setattr__(self, name, frozen_array(getattr(self, name)))
        if self.gripper_m is not None:
            object.__setattr__(self, "gripper_m", frozen_array(self.gripper_m))

    @property
    def speed(self) -> Array:
        """Speed of the flange in m/s, shape (n,)."""
        return np.asarray(np.linalg.norm(self.velocity, axis=1))


# Cutting and generalizing smooth the same recording, which cannot change; remembered once.
@lru_cache(maxsize=4)
def smooth(recording: Recording, settings: SmoothingSettings | None = None) -> Smoothed:
    """Return the smoothed motion of a recording.

    Parameters
    ----------
    recording : Recording
        Times may be irregular and may repeat; samples with the same time are averaged.
    settings : SmoothingSettings, optional

    Returns
    -------
    smoothed : Smoothed
        At the recording's own (distinct) times, thinned where there are too many.

    Notes
    -----
    Source: design, "Smoothing". Orientation is smoothed on the development of the hand's
    turning, the running sum of the small rotation vectors from one sample to the next, which
    knows neither half turns nor signs of quaternions.
    """
    settings = settings or SmoothingSettings()
    t_s, path, gripper_m = distinct(recording, settings.most_samples)
    turned = _development(path[:, 3:])
    states = _smoothed_states(t_s, np.hstack([path[:, :3], turned]), settings.cutoff_hz)
    change = quat_from_rotvec(states[:, 0, 3:] - turned)
    quats = quat_normalize(quat_multiply(quat_normalize(path[:, 3:]), change))
    return Smoothed(
        t_s=t_s,
        path=np.hstack([states[:, 0, :3], quats]),
        velocity=states[:, 1, :3],
        acceleration=states[:, 2, :3],
        turn_rate=states[:, 1, 3:],
        gripper_m=gripper_m,
        gaps_s=_gaps(t_s, settings),
    )


def distinct(recording: Recording, most_samples: int) -> tuple[Array, Array, Array | None]:
    """Return times, path and gripper with equal times averaged and at most `most_samples` rows."""
    order = np.argsort(recording.t_s, kind="stable")
    t_s, first, count = np.unique(recording.t_s[order], return_index=True, return_counts=True)
    path = recording.path[order][first].copy()
    gripper_m = None if recording.gripper_m is None else recording.gripper_m[order][first].copy()
    if np.any(count > 1):
        path[:, :3] = np.add.reduceat(recording.path[order][:, :3], first, axis=0) / count[:, None]
    path = _without_spikes(t_s, path)
    stride = -(-len(t_s) // max(most_samples, 2))
    if stride > 1:
        t_s, path = t_s[::stride], path[::stride]
        gripper_m = None if gripper_m is None else gripper_m[::stride]
    return t_s, path, gripper_m


def _without_spikes(t_s: Array, path: Array) -> Array:
    """Return the path with single samples that no hand could reach taken from their neighbors.

    A tracker that is wrong for one sample would bend the smoothed path by a tenth of its error.
    """
    if len(t_s) < 5:
        return path
    share = (t_s[1:-1] - t_s[:-2]) / (t_s[2:] - t_s[:-2])
    between = interpolate(path[:-2], path[2:], share)
    off_m = _apart_m(path[1:-1], between)
    reach_m = 0.5 * _MOST_M_S2 * np.diff(t_s)[:-1] * np.diff(t_s)[1:]
    # Beside a sample that is off alone, its neighbors look half as wrong; at a jump two do equally.
    alone = off_m[1:-1] > 1.5 * np.maximum(off_m[:-2], off_m[2:])
    wrong = 2 + np.flatnonzero(alone & (off_m > np.maximum(reach_m, _SPIKE_M))[1:-1])
    out = path.copy()
    out[wrong] = between[wrong - 1]
    return out


def _apart_m(first: Array, second: Array) -> Array:
    return np.asarray(
        np.hypot(distance_between(first, second), _TURN_M * angle_between(first, second))
    )


def _development(quats: Array) -> Array:
    unit = quat_normalize(quats)
    steps = quat_to_rotvec(quat_multiply(quat_inverse(unit[:-1]), unit[1:]))
    return np.vstack([np.zeros((1, 3)), np.cumsum(steps, axis=0)])


def _gaps(t_s: Array, settings: SmoothingSettings) -> tuple[tuple[float, float], ...]:
    steps = np.diff(t_s)
    if len(steps) == 0:
        return ()
    longest = max(settings.gap_s, settings.gap_steps * float(np.median(steps)))
    return tuple((float(t_s[i]), float(t_s[i + 1])) for i in np.flatnonzero(steps > longest))


def _smoothed_states(t_s: Array, values: Array, cutoff_hz: float) -> Array:
    """Return place, rate and acceleration, shape (n, 3, m), of values of shape (n, m)."""
    if len(t_s) < 3:
        rate = np.gradient(values, t_s, axis=0) if len(t_s) == 2 else np.zeros_like(values)
        return np.stack([values, rate, np.zeros_like(values)], axis=1)
    steps = np.diff(t_s)
    moves, noises = _models(steps, cutoff_hz)
    gains, spreads = _gains(steps, moves, noises)
    states = np.zeros((len(t_s), 3, values.shape[1]))
    states[0, 0] = values[0]
    for k in range(1, len(t_s)):
        ahead = moves[k - 1] @ states[k - 1]
        states[k] = ahead + gains[k] * (values[k] - ahead[0])
    ahead_spreads = moves @ spreads[:-1] @ moves.transpose(0, 2, 1) + noises
    back = np.linalg.solve(ahead_spreads, moves @ spreads[:-1]).transpose(0, 2, 1)
    for k in range(len(t_s) - 2, -1, -1):
        states[k] += back[k] @ (states[k + 1] - moves[k] @ states[k])
    return states


def _models(steps: Array, cutoff_hz: float) -> tuple[Array, Array]:
    """Return transitions and disturbances, shape (n - 1, 3, 3), in units of the noise.

    The smoother of white jerk passes 1 / (1 + (w / w_c)^6), where w_c^6 is the density of the
    jerk over that of the noise: so a cutoff says it for every sampling rate.
    """
    from filterpy.common import Q_continuous_white_noise

    density = (2.0 * np.pi * cutoff_hz) ** 6 * float(np.median(steps))
    kinds, which = np.unique(np.round(steps, 6), return_inverse=True)
    noises = np.array([Q_continuous_white_noise(3, step, density) for step in kinds])
    moves = np.zeros((len(kinds), 3, 3))
    moves[:, 0, 0] = moves[:, 1, 1] = moves[:, 2, 2] = 1.0
    moves[:, 0, 1] = moves[:, 1, 2] = kinds
    moves[:, 0, 2] = kinds**2 / 2.0
    return moves[which], noises[which]


def _gains(steps: Array, moves: Array, noises: Array) -> tuple[Array, Array]:
    """Return gains, shape (n, 3, 1), and filtered covariances, shape (n, 3, 3)."""
    from filterpy.kalman import predict, update

    still = np.zeros((3, 1))
    spread = np.diag([1.0, 1e8, 1e10])
    spreads = np.empty((len(steps) + 1, 3, 3))
    spreads[0] = spread
    settled = False
    for k, step in enumerate(steps, start=1):
        alike = k > 1 and abs(step - steps[k - 2]) <= _SAME_STEP * step
        if not (settled and alike):
            _, ahead = predict(still, spread, moves[k - 1], noises[k - 1])
            _, after = update(still, ahead, np.zeros((1, 1)), np.eye(1), _PLACE_ONLY)
            change = np.abs(after - spread)
            settled = alike and bool((change <= _SETTLED * np.abs(spread) + 1e-12).all())
            spread = after
        spreads[k] = spread
    # With the best gain, the gain is the first column of the filtered covariance over the noise.
    return spreads[:, :, :1].copy(), spreads
