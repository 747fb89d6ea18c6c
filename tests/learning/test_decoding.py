from __future__ import annotations

from itertools import combinations, product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.learning.decoding import Lattice, decode


def random_lattice(seed: int, instants: int, leaves: int) -> Lattice:
    rng = np.random.default_rng(seed)
    cuts = rng.normal(0.0, 2.0, instants)
    cuts[0] = cuts[-1] = 0.0
    return Lattice(
        cuts=cuts,
        steps=rng.normal(0.0, 2.0, (instants, instants, leaves)),
        unnamed=rng.normal(-2.0, 1.0, (instants, instants)),
        skips=rng.normal(-3.0, 1.0, leaves),
        unled=rng.normal(-1.0, 2.0, (instants, instants, leaves)),
    )


Way = tuple[tuple[int, ...], tuple[int | None, ...]]


def all_readings(lattice: Lattice) -> dict[Way, float]:
    """Return every reading with its score, by brute force."""
    n, leaves = len(lattice.cuts), len(lattice.skips)
    found: dict[Way, float] = {}
    for count in range(n - 1):
        for inner in combinations(range(1, n - 1), count):
            nodes = (0, *inner, n - 1)
            for taken in product([None, *range(leaves)], repeat=len(nodes) - 1):
                named = [leaf for leaf in taken if leaf is not None]
                if named != sorted(set(named)):
                    continue
                score = sum(lattice.cuts[k] for k in inner)
                score += sum(lattice.skips[k] for k in range(leaves) if k not in named)
                for a, b, leaf in zip(nodes[:-1], nodes[1:], taken, strict=True):
                    score += lattice.unnamed[a, b] if leaf is None else lattice.steps[a, b, leaf]
                    if leaf and leaf - 1 not in named:
                        score += lattice.unled[a, b, leaf]
                found[nodes, tuple(taken)] = float(score)
    return found


@given(seed=st.integers(0, 10_000), instants=st.integers(2, 6), leaves=st.integers(1, 3))
@settings(max_examples=30, deadline=None)
def test_agrees_with_trying_all_readings(seed: int, instants: int, leaves: int) -> None:
    lattice = random_lattice(seed, instants, leaves)
    readings = all_readings(lattice)
    best = max(readings, key=lambda way: readings[way])
    total = float(np.logaddexp.reduce(list(readings.values())))
    found = decode(lattice)
    assert (found.nodes, found.taken) == best
    assert found.score == pytest.approx(readings[best])
    assert found.evidence == pytest.approx(total)
    for node in range(1, instants - 1):
        chance = sum(np.exp(s - total) for (nodes, _), s in readings.items() if node in nodes)
        assert found.cut_chances[node] == pytest.approx(chance)
    for leaf in range(leaves):
        chance = sum(
            np.exp(s - total)
            for (nodes, taken), s in readings.items()
            if leaf in taken and nodes[taken.index(leaf) + 1] == instants - 1
        )
        assert found.step_chances[-1, leaf] == pytest.approx(chance)
