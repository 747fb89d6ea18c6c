"""A hand driven by keys, for the tests of what it does."""

from __future__ import annotations

from assistant.ports import HandSample
from sim.hands import KeyedHand


def settled(hand: KeyedHand, key: str, count: int = 1, ticks: int = 150) -> HandSample:
    """Return where the hand is after a key was tapped so often and all has come to rest."""
    for _ in range(count):
        hand.press(key)
    return [hand.tick() for _ in range(ticks)][-1]
