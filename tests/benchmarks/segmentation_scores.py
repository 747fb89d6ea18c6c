"""How cuts are scored: one-to-one matching, F1 with intervals by recording, calibration."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.stats import rankdata

from assistant.geometry import Array

Counts = tuple[int, int, int]


def matched(found: Sequence[float], true: Sequence[float], within_s: float) -> Counts:
    """Return hits, found and true, each true cut matched at most once, nearest pairs first."""
    pairs = sorted(
        (abs(f - t), i, j)
        for i, f in enumerate(found)
        for j, t in enumerate(true)
        if abs(f - t) <= within_s
    )
    left: set[int] = set()
    right: set[int] = set()
    for _, i, j in pairs:
        if i not in left and j not in right:
            left.add(i)
            right.add(j)
    return len(left), len(found), len(true)


def f1(counts: Sequence[Counts]) -> float:
    hits, found, true = np.sum(np.array(counts), axis=0)
    return float(2.0 * hits / max(found + true, 1))


def interval(counts: Sequence[Counts], rounds: int = 1000) -> tuple[float, float]:
    """Return the 95 % interval of F1 by drawing recordings anew."""
    rng = np.random.default_rng(0)
    rows = np.array(counts)
    drawn = rows[rng.integers(0, len(rows), (rounds, len(rows)))].sum(axis=1)
    values = 2.0 * drawn[:, 0] / np.maximum(drawn[:, 1] + drawn[:, 2], 1)
    low, high = np.percentile(values, [2.5, 97.5])
    return float(low), float(high)


def calibration_error(chances: Array, right: Array, bins: int = 10) -> float:
    """Return the expected calibration error over equal bins."""
    which = np.minimum((chances * bins).astype(int), bins - 1)
    error = 0.0
    for k in range(bins):
        mine = which == k
        if np.any(mine):
            error += float(np.mean(mine) * abs(np.mean(chances[mine]) - np.mean(right[mine])))
    return error


def brier(chances: Array, right: Array) -> float:
    return float(np.mean((chances - right) ** 2))


def auroc(chances: Array, right: Array) -> float:
    """Return the chance that a right one is given more confidence than a wrong one."""
    good = float(np.sum(right))
    bad = len(right) - good
    if good == 0 or bad == 0:
        return float("nan")
    ranks = rankdata(chances)
    return float((np.sum(ranks[right == 1]) - good * (good + 1) / 2) / (good * bad))
