"""Shares with their intervals, for tables."""

from __future__ import annotations

from math import sqrt


def interval(count: int, total: int) -> tuple[float, float]:
    """Return Wilson's 95 % interval of a share."""
    z, part = 1.96, count / total
    middle = (part + z * z / (2 * total)) / (1 + z * z / total)
    half = z * sqrt(part * (1 - part) / total + z * z / (4 * total**2)) / (1 + z * z / total)
    return max(middle - half, 0.0), min(middle + half, 1.0)


def share(count: int, total: int) -> str:
    """Return a count of a total with its interval, such as ``1/20 [.01, .24]``."""
    low, high = interval(count, total)
    return f"{count}/{total} [{low:.3f}, {high:.3f}]"
