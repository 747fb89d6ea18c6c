"""What a generator of demonstrations returns: the showing, the introduction and the truth."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from assistant.model.demonstration import Demonstration, Spoken
from assistant.model.task import Task

Habit = Literal["fluent", "slow", "keys"]


@dataclass(frozen=True, slots=True, eq=False)
class Shown:
    """A demonstration whose cuts are known.

    Parameters
    ----------
    cuts_s : tuple of float
        True cuts between primitives: the middle of a rest or the gripper's instant within it.
    names : tuple of str
        The primitive of each episode, as shown.
    """

    demonstration: Demonstration
    task: Task
    cuts_s: tuple[float, ...]
    names: tuple[str, ...]


WORDS = ("then", "next step", "and then", "next", "after that", "now the next step")


def spoken_cues(
    cuts_s: list[float], end_s: float, rng: np.random.Generator, lag_s: float | None = None
) -> tuple[Spoken, ...]:
    """Return the cues of a teacher with an own lag: jittered, some missing, some false."""
    drawn_s = rng.uniform(0.1, 1.8)
    lag_s = drawn_s if lag_s is None else lag_s
    jitter_s = rng.uniform(0.05, 0.25)
    missing = rng.uniform(0.10, 0.15)
    times = [cut + max(lag_s + rng.normal(0.0, jitter_s), 0.0) for cut in cuts_s]
    times = [at for at in times if at < end_s and rng.random() > missing]
    if rng.random() < 0.35:
        times += list(rng.uniform(0.05 * end_s, 0.95 * end_s, size=int(rng.integers(1, 3))))
    times.sort()
    said = ["first step"] + [str(rng.choice(WORDS)) for _ in times]
    return tuple(Spoken(round(at, 3), say) for at, say in zip(times, said, strict=False))
