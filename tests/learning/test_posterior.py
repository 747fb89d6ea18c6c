from __future__ import annotations

from itertools import combinations, pairwise, product

import numpy as np
import pytest

from assistant.geometry import Array
from assistant.learning.decoding import Lattice, decode
from assistant.learning.posterior import cut_shares, unnamed_chances, unnamed_places, whole_evidence

AT_S = np.array([0.0, 1.0, 1.2, 2.5, 4.0])


def lattice(seed: int, leaves: int = 2) -> Lattice:
    rng = np.random.default_rng(seed)
    n = len(AT_S)
    cuts = np.zeros(n)
    cuts[1:-1] = rng.normal(0.0, 1.0, n - 2)
    return Lattice(
        cuts,
        rng.normal(0.0, 2.0, (n, n, leaves)),
        rng.normal(-2.0, 1.0, (n, n)),
        -np.ones(leaves),
        rng.normal(-1.0, 1.0, (n, n, leaves)),
    )


def readings(given: Lattice) -> list[tuple[tuple[int, ...], tuple[int | None, ...], float]]:
    """Return all readings one by one, with their scores: nodes, primitives, log weight."""
    n, m = len(given.cuts), len(given.skips)
    found = []
    for size in range(n - 1):
        for inner in combinations(range(1, n - 1), size):
            nodes = (0, *inner, n - 1)
            for taken in product([None, *range(m)], repeat=size + 1):
                named = [at for at in taken if at is not None]
                if any(b <= a for a, b in pairwise(named)):
                    continue
                score = float(np.sum(given.cuts[list(inner)]))
                for a, b, at in zip(nodes[:-1], nodes[1:], taken, strict=True):
                    score += float(given.unnamed[a, b] if at is None else given.steps[a, b, at])
                    if at and at - 1 not in named:
                        score += float(given.unled[a, b, at])
                score += float(sum(given.skips[at] for at in range(m) if at not in named))
                found.append((nodes, taken, score))
    return found


def total(scores: list[float]) -> float:
    return float(np.log(np.sum(np.exp(scores))))


@pytest.mark.parametrize("seed", range(5))
def test_the_share_of_readings_like_the_best_is_what_counting_gives(seed: int) -> None:
    given = lattice(seed)
    best = decode(given)
    every = readings(given)
    assert best.evidence == pytest.approx(total([score for _, _, score in every]))
    cuts_s: Array = AT_S[list(best.nodes[1:-1])]
    for within_s in (0.1, 0.3):
        alike = [
            score
            for nodes, taken, score in every
            if taken == best.taken and np.all(np.abs(AT_S[list(nodes[1:-1])] - cuts_s) <= within_s)
        ]
        told = whole_evidence(given, AT_S, cuts_s, best.taken, within_s)
        assert told == pytest.approx(total(alike))


def test_no_reading_has_a_cut_where_there_is_no_instant() -> None:
    assert whole_evidence(lattice(0), AT_S, np.array([3.3]), (0, 1), 0.2) == -np.inf


@pytest.mark.parametrize("seed", range(5))
def test_shares_of_cuts_are_sums_over_readings(seed: int) -> None:
    given = lattice(seed)
    best, every = decode(given), readings(given)
    whole = total([score for _, _, score in every])
    (share,) = cut_shares(best, AT_S, np.array([1.1]), (0, 1), 0.15)
    ends = [
        score
        for nodes, taken, score in every
        for end, at in zip(nodes[1:], taken, strict=True)
        if at == 0 and end in (1, 2)
    ]
    assert share == pytest.approx(np.exp(total(ends) - whole))


@pytest.mark.parametrize("seed", range(5))
def test_chances_of_steps_nobody_introduced_are_sums_over_readings(seed: int) -> None:
    given = lattice(seed)
    best, every = decode(given), readings(given)
    whole = total([score for _, _, score in every])
    told = unnamed_chances(given)
    for span in combinations(range(len(AT_S)), 2):
        free = [
            score
            for nodes, taken, score in every
            if (span, None) in zip(pairwise(nodes), taken, strict=True)
        ]
        assert told[span] == pytest.approx(np.exp(total(free) - whole))
    # Whatever ends at an instant is a step introduced, or none.
    ends = np.sum(told, axis=0)[1:] + np.sum(best.step_chances, axis=1)[1:]
    assert ends == pytest.approx(best.cut_chances[1:])


@pytest.mark.parametrize("seed", range(5))
def test_a_place_is_as_likely_as_the_readings_with_such_a_step_over_its_midst(seed: int) -> None:
    given = lattice(seed)
    every = readings(given)
    whole = total([score for _, _, score in every])
    shares = []
    for k in range(len(AT_S) - 1):
        spanned = [
            score
            for nodes, taken, score in every
            for (a, b), at in zip(pairwise(nodes), taken, strict=True)
            if at is None and a <= k < b
        ]
        shares.append(np.exp(total(spanned) - whole))
    places = unnamed_places(given, AT_S)
    assert places[0][2] == pytest.approx(max(shares))
    # No reading counts for two places.
    assert sum(chance for _, _, chance in places) <= np.sum(unnamed_chances(given)) + 1e-9
    assert all(0.0 <= a < b <= AT_S[-1] for a, b, _ in places)


def test_readings_that_differ_in_where_a_step_ends_tell_of_one_place() -> None:
    n = len(AT_S)
    steps = np.full((n, n, 1), -20.0)
    unnamed = np.full((n, n), -20.0)
    # A step nobody told begins at 0 s and ends at 1.0 or 1.2 s; the one told takes the rest.
    unnamed[0, 1] = unnamed[0, 2] = 0.0
    steps[1, 4, 0] = steps[2, 4, 0] = 0.0
    given = Lattice(np.zeros(n), steps, unnamed, np.array([-30.0]), np.zeros((n, n, 1)))
    ((from_s, to_s, chance),) = unnamed_places(given, AT_S)
    assert from_s == 0.0
    assert to_s in (1.0, 1.2)
    assert chance == pytest.approx(1.0, abs=1e-3)
