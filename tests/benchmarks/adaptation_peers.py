"""Ways to carry a path to another setup that others published or anybody would try first.

Each gets the same learned path, already smoothed, and each setup's grasp and release poses.
Of its settings, the best on every sixth of the very setups is shown. DMPs and ProMP come from
the package movement_primitives (the extra `bench`).
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from importlib import import_module
from typing import Any, Literal

import numpy as np

from assistant.geometry import (
    Array,
    compose,
    interpolate,
    inverse,
    quat_continuous,
    quat_normalize,
)
from assistant.learning.adaptation import AdaptationPlan, adapted_path
from assistant.learning.carrying import ADDED, EVENED, OF_STRETCH
from assistant.model.settings import BlendingSettings

Query = Callable[[Array, Array], Array]
Fit = Callable[[AdaptationPlan], Query]


@dataclass(frozen=True, slots=True)
class Method:
    """A way to carry a path: `fits` are done once a lesson, what they return once a setup."""

    name: str
    fits: Mapping[str, Fit]


def ours(scheme: Literal["smooth", "paper", "two_frame", "azimuth"], name: str) -> Method:
    """Return one of our own schemes."""

    def fit(plan: AdaptationPlan) -> Query:
        chosen = replace(plan, settings=BlendingSettings(scheme=scheme))
        return partial(adapted_path, chosen)

    return Method(name, {"": fit})


def least_jerk(plan: AdaptationPlan) -> Query:
    """Return ours with nothing of the teacher's hand left between the stretches: a floor."""
    bare = [replace(way, rows=_emptied(way.rows)) for way in plan.ways.between]
    chosen = replace(plan, ways=replace(plan.ways, between=tuple(bare), most=np.inf))
    return partial(adapted_path, chosen)


def _emptied(rows: Array) -> Array:
    # Without what the teacher's hand adds, whichever stretch it turns with.
    out = rows.copy()
    for part in (ADDED, EVENED):
        out[part] = 0.0
        out[OF_STRETCH + part.start : OF_STRETCH + part.stop] = 0.0
    return out


def hands(plan: AdaptationPlan, frames: Array) -> Array:
    """Return where the hand must be at each station, shape (stations, 7)."""
    return compose(frames, np.array(plan.hands))


def segment_transform(plan: AdaptationPlan, samples: int) -> Query:
    """Return the transform of whole segments, joined by straight interpolation."""
    path, stations = plan.ways.path, plan.stations
    edges = [0, *(one.left_at for one in stations[:-1]), len(path)]

    def query(frames: Array, start: Array) -> Array:
        out = np.empty_like(path)
        for k, one in enumerate(stations):
            move = compose(frames[k], inverse(one.frame_to_world))
            out[edges[k] : edges[k + 1]] = compose(move, path[edges[k] : edges[k + 1]])
        for k in range(len(stations)):
            begin = edges[k]
            join = min(begin + samples, stations[k].docking_at)
            here = start if k == 0 else out[begin - 1]
            share = np.linspace(0.0, 1.0, join - begin + 1)
            out[begin : join + 1] = interpolate(here, out[join], share)
        return out

    return query


def _ends(plan: AdaptationPlan, whole: bool) -> list[int]:
    inner = [] if whole else [one.at for one in plan.stations]
    return [0, *inner, len(plan.ways.path) - 1]


def _goals(plan: AdaptationPlan, frames: Array, start: Array, whole: bool) -> list[Array]:
    path = plan.ways.path
    last = compose(compose(frames[-1], inverse(plan.stations[-1].frame_to_world)), path[-1])
    return [start, last] if whole else [start, *hands(plan, frames), last]


def movement_primitive(
    plan: AdaptationPlan, *, cartesian: bool, whole: bool, samples_each: int, **given: Any
) -> Query:
    """Return DMPs, one a part between stations, or one for the whole path."""
    dmp = import_module("movement_primitives.dmp")
    step_s, ends = float(np.median(plan.steps_s)), _ends(plan, whole)
    made: list[Any] = []
    for first, last in itertools.pairwise(ends):
        shown = _wxyz(plan.ways.path[first : last + 1])
        given |= {
            "execution_time": (last - first) * step_s,
            "dt": step_s,
            "n_weights_per_dim": max(10, (last - first) // samples_each),
        }
        one = dmp.CartesianDMP(**given) if cartesian else dmp.DMP(n_dims=7, **given)
        one.imitate(np.arange(len(shown)) * step_s, shown)
        made.append(one)

    def query(frames: Array, start: Array) -> Array:
        goals = _goals(plan, frames, start, whole)
        out = np.empty_like(plan.ways.path)
        for k, (first, last) in enumerate(itertools.pairwise(ends)):
            made[k].configure(start_y=_wxyz(goals[k]), goal_y=_wxyz(goals[k + 1]))
            _, path = made[k].open_loop()
            at = np.linspace(0, len(path) - 1, last - first + 1).round().astype(int)
            out[first : last + 1] = _xyzw(path[at])
        return out

    return query


def promp(plan: AdaptationPlan, weights: int, spread_m: float) -> Query:
    """Return a ProMP of places, taught by smooth variations, conditioned at the stations."""
    path = plan.ways.path
    rng, count = np.random.default_rng(0), len(path)
    share = np.linspace(0.0, 1.0, count)
    at = _ends(plan, whole=False)
    variations = []
    for _ in range(30):
        knots = rng.normal(0.0, spread_m, (len(at), 3))
        moved = [np.interp(np.arange(count), at, knots[:, k]) for k in range(3)]
        variations.append(path[:, :3] + np.array(moved).T)
    model = import_module("movement_primitives.promp").ProMP(n_dims=3, n_weights_per_dim=weights)
    model.imitate(np.tile(share, (30, 1)), np.array(variations))

    def query(frames: Array, start: Array) -> Array:
        conditioned, goals = model, _goals(plan, frames, start, whole=False)
        for sample, goal in zip(at, goals, strict=True):
            conditioned = conditioned.condition_position(goal[:3], np.zeros((3, 3)), share[sample])
        out = path.copy()
        out[:, :3] = conditioned.mean_trajectory(share)
        for k, (first, last) in enumerate(itertools.pairwise(at)):
            way = np.linspace(0.0, 1.0, last - first + 1)
            out[first : last + 1, 3:] = interpolate(goals[k], goals[k + 1], way)[:, 3:]
        return out

    return query


def _wxyz(poses: Array) -> Array:
    return np.concatenate([poses[..., :3], poses[..., 6:], poses[..., 3:6]], axis=-1)


def _xyzw(poses: Array) -> Array:
    quats = quat_normalize(np.concatenate([poses[..., 4:], poses[..., 3:4]], axis=-1))
    return np.concatenate([poses[..., :3], quat_continuous(quats)], axis=-1)


def _dmps(*, cartesian: bool, whole: bool) -> Iterator[tuple[str, Fit]]:
    """Yield settings: samples a weight, stiffness of the spring, smooth scaling of the forcing."""
    for each, alpha, smooth in itertools.product((2, 3, 6), (25.0, 50.0, 100.0), (False, True)):
        name = f"1/{each}, alpha {alpha:.0f}{', smooth' if smooth else ''}"
        yield (
            name,
            partial(
                movement_primitive,
                cartesian=cartesian,
                whole=whole,
                samples_each=each,
                smooth_scaling=smooth,
                alpha_y=alpha,
                beta_y=alpha / 4.0,
            ),
        )


METHODS = (
    ours("smooth", "ours (default)"),
    Method("floor: no detail between", {"": least_jerk}),
    ours("two_frame", "two-frame blend"),
    ours("azimuth", "eq. (6), azimuth-turned"),
    ours("paper", "eq. (6) as printed"),
    Method(
        "segment transform + linear",
        {f"{n} samples": partial(segment_transform, samples=n) for n in (25, 50, 100, 200, 400)},
    ),
    Method("DMP, a segment each", dict(_dmps(cartesian=False, whole=False))),
    Method("Cartesian DMP, a segment each", dict(_dmps(cartesian=True, whole=False))),
    Method("Cartesian DMP, whole path", dict(_dmps(cartesian=True, whole=True))),
    Method(
        "ProMP, conditioned",
        {
            f"{n} weights, {s} m": partial(promp, weights=n, spread_m=s)
            for n in (30, 60, 120)
            for s in (0.08, 0.3)
        },
    ),
)
