"""Other ways to cut, each given what it can use: the count, and cues at their best shift."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from scipy.signal import find_peaks

from assistant.geometry import Array
from assistant.learning.smoothing import Smoothed, smooth
from tests.benchmarks.segmentation_scores import f1, matched
from tests.generators.shown import Shown

Cutter = Callable[[Shown, Smoothed], list[float]]


def msv_minima(shown: Shown, smoothed: Smoothed) -> list[float]:
    """Minima of the mean squared velocity below its mean, the deepest as many as there are."""
    squared = smoothed.speed**2
    found, _ = find_peaks(-squared)
    found = found[squared[found] < np.mean(squared)]
    deepest = found[np.argsort(squared[found])][: len(shown.cuts_s)]
    return sorted(float(smoothed.t_s[k]) for k in deepest)


def zero_velocity(shown: Shown, smoothed: Smoothed) -> list[float]:
    """Middles of the longest stretches that hardly move."""
    still = smoothed.speed < 0.1 * np.mean(smoothed.speed)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], still.astype(int), [0]])))
    runs = sorted(zip(edges[::2], edges[1::2], strict=True), key=lambda run: run[0] - run[1])
    inner = [run for run in runs if run[0] > 0 and run[1] < len(still)]
    t_s = smoothed.t_s
    return sorted(float(0.5 * (t_s[a] + t_s[b - 1])) for a, b in inner[: len(shown.cuts_s)])


def ruptures_cutters() -> dict[str, list[Cutter]]:
    """Return the peer's methods with many settings each; the best on the set is shown.

    Every method sees every feature, at up to ten samples a second.
    """
    try:
        import ruptures
    except ImportError:
        return {}

    def cutter(make: Callable[[], Any], feature: str) -> Cutter:
        def cut(shown: Shown, smoothed: Smoothed) -> list[float]:
            t_s, rows = _features(smoothed, feature)
            count = min(len(shown.cuts_s), len(t_s) // 16)
            fitted = make().fit(rows)
            if isinstance(fitted, ruptures.Pelt):
                ends = _with_count(fitted, count)
            else:
                ends = fitted.predict(n_bkps=count)
            return [float(t_s[k]) for k in ends[:-1]]

        return cut

    sizes = (2, 5, 15)
    kinds: dict[str, list[Callable[[], Any]]] = {
        # With the count known, Pelt finds what KernelCPD finds with its linear kernel.
        "ruptures Pelt": [partial(ruptures.Pelt, model="l2", min_size=5, jump=5)],
        "ruptures Binseg": [
            *(partial(ruptures.Binseg, model="l2", min_size=size, jump=1) for size in sizes),
            partial(ruptures.Binseg, model="rbf", min_size=5, jump=5),
        ],
        "ruptures BottomUp": [
            partial(ruptures.BottomUp, model="l2", min_size=size, jump=2) for size in sizes[:2]
        ],
        "ruptures KernelCPD": [
            partial(ruptures.KernelCPD, kernel=kernel, min_size=size)
            for kernel in ("linear", "rbf", "cosine")
            for size in sizes
        ],
    }
    return {
        name: [cutter(make, feature) for make in makes for feature in FEATURES]
        for name, makes in kinds.items()
    }


def _with_count(fitted: Any, count: int) -> list[int]:
    """Return Pelt's cuts at the penalty that gives the count, or comes nearest."""
    low, high = -6.0, 12.0
    best: list[int] = []
    for _ in range(8):
        middle = 0.5 * (low + high)
        ends = fitted.predict(pen=float(np.exp(middle)))
        if not best or abs(len(ends) - 1 - count) < abs(len(best) - 1 - count):
            best = list(ends)
        if len(ends) - 1 == count:
            break
        low, high = (middle, high) if len(ends) - 1 > count else (low, middle)
    return best


FEATURES = ("velocity", "place", "log", "place and velocity", "log and place", "pose", "all")


def _features(smoothed: Smoothed, feature: str) -> tuple[Array, Array]:
    """Return times and standardized rows, at most ten a second."""
    step = float(np.median(np.diff(smoothed.t_s)))
    stride = max(round(0.1 / step), 1, len(smoothed.t_s) // 400)
    speed = smoothed.speed[:, None]
    turning = np.linalg.norm(smoothed.turn_rate, axis=1)[:, None]
    single = {
        "velocity": np.hstack([smoothed.velocity, speed]),
        "place": smoothed.path[:, :3],
        "log": np.log(speed + 0.05 * np.mean(speed)),
        "turning": np.log(turning + 0.05 * np.mean(turning) + 1e-6),
        "turned": smoothed.path[:, 3:],
    }
    joined = {
        "place and velocity": ("place", "velocity"),
        "log and place": ("log", "place"),
        "pose": ("place", "turned"),
        "all": ("place", "velocity", "log", "turning", "turned"),
    }
    names = joined.get(feature, (feature,))
    rows = np.hstack([single[name] for name in names])[::stride]
    if smoothed.gripper_m is not None and feature in ("pose", "all"):
        rows = np.hstack([rows, smoothed.gripper_m[::stride, None]])
    return smoothed.t_s[::stride], (rows - rows.mean(axis=0)) / (rows.std(axis=0) + 1e-9)


def best_shift(shows: Sequence[Shown], within_s: float) -> float:
    """Return the constant that suits all cues of a set best, chosen on the very set."""
    shifts = np.arange(0.0, 2.51, 0.05)
    scores = [
        f1([matched(shifted(shown, float(s)), shown.cuts_s, within_s) for shown in shows])
        for s in shifts
    ]
    return float(shifts[int(np.argmax(scores))])


def shifted(shown: Shown, shift_s: float) -> list[float]:
    return [cue.at_s - shift_s for cue in shown.demonstration.cues if cue.at_s > shift_s]


def with_cues(found: list[float], shown: Shown, shift_s: float) -> list[float]:
    """Return cues, each at the peer's cut near it if there is one, then its other cuts.

    Up to the count.
    """
    cuts = []
    for told in shifted(shown, shift_s):
        near = [cut for cut in found if abs(cut - told) < 0.6]
        cuts.append(min(near, key=lambda cut: abs(cut - told)) if near else told)
    for cut in found:
        if len(cuts) < len(shown.cuts_s) and all(abs(cut - known) > 0.5 for known in cuts):
            cuts.append(cut)
    return sorted(cuts)


def smoothed_of(shows: Sequence[Shown]) -> list[Smoothed]:
    return [smooth(shown.demonstration.recording) for shown in shows]
