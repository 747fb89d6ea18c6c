"""The six ways in the base frame: x forward, y left, z up (design, conventions)."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

Triple = tuple[float, float, float]

WAYS: Mapping[str, Triple] = MappingProxyType(
    {
        "left": (0.0, 1.0, 0.0),
        "right": (0.0, -1.0, 0.0),
        "forward": (1.0, 0.0, 0.0),
        "backward": (-1.0, 0.0, 0.0),
        "up": (0.0, 0.0, 1.0),
        "down": (0.0, 0.0, -1.0),
    }
)
"""Unit steps of the hand or of a thing, as the robot sees it."""
