"""Can the hand be driven by keys to places on the table without a dead end?

    python -m tests.benchmarks.bench_keys [PLACES] [SEED]

From the start of the empty table the hand is driven as a newcomer drives it, one key after the
other: sideways, then ahead, then down, each as far as it goes; if it is not there, the same again,
at most three times. Places are drawn evenly over what a hand that points down reaches.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np

from assistant.cli.adapters import make_equipment
from assistant.geometry import Array, compose, inverse
from assistant.model.transcript import SetupChoice
from assistant.session.opening import chosen
from sim.driving import TIP
from sim.hands import KeyedHand
from sim.kinematics import inverse_all, limit_margin
from tests.benchmarks.intervals import share

TOP_M, ABOVE_M, NEAREST_M = 0.24, 0.04, 0.25
DOWN = (0.0, math.sqrt(0.5), 0.0, math.sqrt(0.5))
ROOM_RAD = math.radians(2.0)
KEYS = (("w", "s"), ("a", "d"), ("r", "f"))
THERE_M, TAPS, TICKS, ROUNDS = 0.006, 200, 12, 3


def places(count: int, seed: int) -> list[Array]:
    """Return so many poses of the fingers, shape (7,) each."""
    rng = np.random.default_rng(seed)
    found: list[Array] = []
    while len(found) < count:
        x, y = rng.uniform(-0.1, 0.8), rng.uniform(-0.75, 0.75)
        tip = np.array([x, y, TOP_M + ABOVE_M, *DOWN])
        answers = inverse_all(compose(tip, inverse(TIP))[None])[0, :4]
        fine = (np.isfinite(q).all() and limit_margin(q) > ROOM_RAD for q in answers)
        if math.hypot(x, y) > NEAREST_M and any(fine):
            found.append(tip)
    return found


def driven() -> KeyedHand:
    """Return a hand at the start of the empty table."""
    equipment = make_equipment("kinematic")
    scene, setup = chosen(SetupChoice(name="empty"), Path())
    equipment.arm.arrange(scene, setup)
    return KeyedHand(equipment.arm, equipment.planner, scene, setup)


def tap(hand: KeyedHand, axis: int, goal: Array) -> bool:
    """Tap one key until the hand is abreast of the goal; return whether it got there."""
    tip = compose(hand.tick().pose, TIP)
    for _ in range(TAPS):
        away = float(goal[axis] - tip[axis])
        if abs(away) < THERE_M / 2.0:
            return True
        hand.press(KEYS[axis][0 if away > 0 else 1])
        for _ in range(TICKS):
            tip = compose(hand.tick().pose, TIP)
        if hand.state.blocked is not None:
            return False
    return False


def rounds(goal: Array) -> int:
    """Return in which round the hand arrived; 0 if in none."""
    hand = driven()
    for number in range(1, ROUNDS + 1):
        for axis in (1, 0, 2):
            tap(hand, axis, goal)
        tip = compose(hand.tick().pose, TIP)
        if np.abs(tip[:3] - goal[:3]).max() < THERE_M:
            return number
    return 0


def main() -> None:
    """Print the share of places that were reached, with its interval."""
    count, seed = (int(one) for one in (*sys.argv[1:3], "60", "7")[:2])
    arrived = [rounds(goal) for goal in places(count, seed)]
    done = sum(number > 0 for number in arrived)
    print(f"reached {share(done, count)}, at once {share(arrived.count(1), count)}")


if __name__ == "__main__":
    main()
