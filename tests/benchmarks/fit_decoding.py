"""Where the weights of the decoder come from: what makes the true readings likeliest.

    python -m tests.benchmarks.fit_decoding [--people DIR] [--seeds N] [--rounds N]

The decoder's chain is a conditional random field, linear in its weights. They are those under
which the true cuts and primitives are likeliest among all readings, of lessons of both
generators and of people, with and without cues and gripper, with steps left out or not told;
held to the shipped ones by a ridge. No seed or drawn cue of another benchmark is used.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

from assistant.errors import WorkFailed
from assistant.geometry import Array
from assistant.learning.decoding import Lattice, backward, forward, log_sum, named_into
from assistant.learning.reading import Understood, read
from assistant.learning.scoring import heard_lattice, motion_lattice, reordered
from assistant.learning.segmentation import gathered
from assistant.model.motion import Indices
from assistant.model.settings import DecodingSettings, SegmentationSettings
from assistant.model.task import primitives
from tests.benchmarks.bench_confidence import by_person, redrawn, without_gripper
from tests.benchmarks.bench_segmentation import HABITS, without_cues
from tests.benchmarks.segmentation_lessons import other_length, told_coarsely
from tests.generators import generator_a, generator_b
from tests.generators.shown import Shown

FIRST_SEED = 20_000
OF_CUTS = (
    *("bias", "slow", "rest", "bend", "veer"),
    *("gripper", "jolt", "part", "heard", "settling"),
)
OF_STEPS = (
    *("direction", "astray", "still", "straight", "wide"),
    *("turned", "idle", "event", "lasting"),
)
NAMES = (*OF_CUTS, *OF_STEPS, "skip", "insert")
RIDGE = 2.0
SPREAD_S, FARTHEST_S = 0.2, 1.5
"""How far from a true cut one that stands for it lies, mostly and at most."""

Weighed = tuple[float, Array]
"""A log of a sum over readings, and its slope by the weights."""


@dataclass(frozen=True, slots=True, eq=False)
class Lesson:
    """A lesson whose truth is known, as sums of evidence to be weighed.

    Parameters
    ----------
    rest : Lattice
        What no weight of ours scales.
    cuts : array, shape (n, len(OF_CUTS))
    steps : array, shape (n, n, m, len(OF_STEPS))
    plain : array of bool, shape (m,)
        Primitives that are not optional.
    nodes : tuple of array of int
        For each true cut the instants that may stand for it.
    near : tuple of array
        Log of how well each of them does.
    taken : tuple of (int or None)
    """

    rest: Lattice
    cuts: Array
    steps: Array
    plain: Array
    nodes: tuple[Indices, ...]
    near: tuple[Array, ...]
    taken: tuple[int | None, ...]
    weight: float


def lessons(people: Path | None, seeds: int) -> Iterator[tuple[Shown, float]]:
    """Yield lessons with how much each counts."""
    for generate in (generator_a.generate, generator_b.generate):
        for habit in HABITS:
            for k in range(seeds):
                shown = generate(FIRST_SEED + k, habit)
                yield from ((one, weight) for one, weight in _ways(shown, k))
    for shows in by_person(people).values() if people else ():
        for number, shown in enumerate(shows):
            for k in range(4):
                again = redrawn(shown, FIRST_SEED + k)
                yield from ((one, 0.6 * weight) for one, weight in _ways(again, 4 * number + k))


def _ways(shown: Shown, k: int) -> Iterator[tuple[Shown, float]]:
    yield shown, 1.0
    if k % 2 == 0:
        yield other_length(shown, k, longer=k % 4 == 2), 1.0
    if k % 4 == 0:
        yield without_cues(shown), 0.5
    if k % 4 == 1:
        yield without_gripper(shown), 0.5
    if k % 4 == 3 and (coarse := told_coarsely(shown, k)) is not None:
        yield coarse, 1.0


def taken_apart(shown: Shown, weight: float) -> Lesson | None:
    """Return a lesson as sums of evidence; None where nothing can be read, or not truly."""
    usual = SegmentationSettings()
    try:
        evidence = gathered(shown.demonstration, shown.task, usual)
    except WorkFailed:
        return None
    found = read(shown.demonstration, shown.task, evidence, usual)
    none = replace(usual.decoding, **dict.fromkeys(NAMES, 0.0))

    def lattice(given: DecodingSettings) -> Lattice:
        settings = replace(usual, decoding=given)
        spots = found.candidates
        told = motion_lattice(shown.demonstration, shown.task, evidence, spots, settings)
        return reordered(told, found.order)

    empty = lattice(none)
    single = [lattice(replace(none, **{name: 1.0})) for name in (*OF_CUTS, *OF_STEPS)]
    cuts = np.stack([one.cuts - empty.cuts for one in single[: len(OF_CUTS)]], axis=-1)
    steps = np.stack([one.steps - empty.steps for one in single[len(OF_CUTS) :]], axis=-1)
    leaves = [primitives(shown.task.tree)[k] for k in found.order]
    where = {leaf.name: k for k, leaf in enumerate(leaves)}
    taken = tuple(where.get(name) for name in shown.names)
    named = [position for position in taken if position is not None]
    nodes, near = _standing_for(shown, found)
    if named != sorted(named) or any(len(each) == 0 for each in nodes):
        return None
    plain = np.array([not leaf.optional for leaf in leaves], dtype=float)
    rest = _heard(shown, found, empty, usual)
    return Lesson(rest, cuts, steps, plain, nodes, near, taken, weight)


def _heard(
    shown: Shown, found: Understood, lattice: Lattice, usual: SegmentationSettings
) -> Lattice:
    if found.lag is None:
        return lattice
    cues_s = np.array([cue.at_s for cue in shown.demonstration.cues])
    blur_s = np.array([spot.blur_s for spot in found.candidates])
    at_s = _instants(found)
    return heard_lattice(lattice, at_s, cues_s, blur_s, found.lag, usual)


def _instants(found: Understood) -> Array:
    """Return start, candidates and end, before the cues refined the cuts."""
    return np.array([found.at_s[0], *(spot.at_s for spot in found.candidates), found.at_s[-1]])


def _standing_for(shown: Shown, found: Understood) -> tuple[tuple[Indices, ...], tuple[Array, ...]]:
    at_s = _instants(found)[1:-1]
    spread_s = np.hypot(SPREAD_S, [min(spot.blur_s, 0.6) for spot in found.candidates])
    nodes, near = [], []
    for cut_s in shown.cuts_s:
        away = at_s - cut_s
        told = np.exp(-0.5 * (away / spread_s) ** 2) + 0.02 * np.exp(-0.5 * away**2)
        inside = np.flatnonzero(np.abs(away) < FARTHEST_S)
        nodes.append(inside + 1)
        near.append(np.log(told[inside] + 1e-9))
    return tuple(nodes), tuple(near)


def weighed(lesson: Lesson, weights: Array) -> Lattice:
    """Return the lattice with these weights, in the order of `NAMES`."""
    of_cuts, of_steps = weights[: len(OF_CUTS)], weights[len(OF_CUTS) : -2]
    return Lattice(
        lesson.rest.cuts + lesson.cuts @ of_cuts,
        lesson.rest.steps + lesson.steps @ of_steps,
        lesson.rest.unnamed - weights[-1],
        lesson.rest.skips - weights[-2] * lesson.plain,
        lesson.rest.unled,
    )


def every_reading(lesson: Lesson, lattice: Lattice) -> Weighed:
    """Return the log of the sum over all readings."""
    ahead, skipped = forward(lattice)
    behind, total = backward(lattice), float(skipped[-1, -1])
    onward = behind + lattice.cuts[:, None] - total
    later = np.triu(np.zeros(lattice.unnamed.shape), 1) + np.tril(np.full(len(ahead), -np.inf))
    named = np.zeros(lattice.steps.shape)
    for k in range(1, len(ahead)):
        named[:k, k] = np.exp(named_into(lattice, ahead, skipped, k) + onward[k, 1:])
    free = ahead[:, None] + lattice.unnamed[:, :, None] + onward + later[:, :, None]
    cut = np.exp(log_sum(ahead + behind, 1) - total)
    slope = np.concatenate(
        [
            cut @ lesson.cuts,
            np.tensordot(named, lesson.steps, 3),
            [-float((1.0 - np.sum(named, axis=(0, 1))) @ lesson.plain), -float(np.exp(free).sum())],
        ]
    )
    return total, slope


def true_readings(lesson: Lesson, lattice: Lattice) -> Weighed:
    """Return the log of the sum over the readings that tell the truth, by how well they do."""
    nodes = [np.array([0]), *lesson.nodes, np.array([len(lattice.cuts) - 1])]
    near = [np.zeros(1), *lesson.near, np.zeros(1)]
    gains = [lattice.cuts[here] + told for here, told in zip(nodes, near, strict=True)]
    spent = []
    for before, after, position in zip(nodes[:-1], nodes[1:], lesson.taken, strict=True):
        score = lattice.unnamed if position is None else lattice.steps[:, :, position]
        if position is not None and position > 0 and position - 1 not in lesson.taken:
            score = score + lattice.unled[:, :, position]
        later = after[None, :] > before[:, None]
        spent.append(np.where(later, score[np.ix_(before, after)], -np.inf))
    ahead, behind = [np.zeros(1)], [np.zeros(1)]
    for score, gain in zip(spent, gains[1:], strict=True):
        ahead.append(log_sum(ahead[-1][:, None] + score, 0) + gain)
    for score, gain in zip(spent[::-1], gains[:0:-1], strict=True):
        behind.insert(0, log_sum(score + (gain + behind[0])[None, :], 1))
    total = float(ahead[-1][0])
    if not np.isfinite(total):
        return -np.inf, np.zeros(len(NAMES))
    slope = np.zeros(len(NAMES))
    for k, position in enumerate(lesson.taken):
        rows, columns = nodes[k], nodes[k + 1]
        share = np.exp(ahead[k][:, None] + spent[k] + gains[k + 1] + behind[k + 1] - total)
        slope[: len(OF_CUTS)] += np.sum(share, axis=0) @ lesson.cuts[columns]
        if position is None:
            slope[-1] -= 1.0
        else:
            features = lesson.steps[:, :, position][np.ix_(rows, columns)]
            slope[len(OF_CUTS) : -2] += np.tensordot(share, features, 2)
    left_out = [k for k in range(len(lesson.plain)) if k not in lesson.taken]
    slope[-2] = -float(np.sum(lesson.plain[left_out]))
    return total + float(np.sum(lattice.skips[left_out])), slope


def fitted(known: Sequence[Lesson], begin: Array, rounds: int) -> Array:
    """Return the weights under which the truth is likeliest."""
    scale = np.maximum(np.abs(begin), 0.5)

    def loss(weights: Array) -> Weighed:
        off = (weights - begin) / scale
        value, slope = 0.5 * RIDGE * float(off @ off), RIDGE * off / scale
        for lesson in known:
            lattice = weighed(lesson, weights)
            true, true_slope = true_readings(lesson, lattice)
            if np.isfinite(true):
                every, every_slope = every_reading(lesson, lattice)
                value += lesson.weight * (every - true)
                slope += lesson.weight * (every_slope - true_slope)
        return value, slope

    found = minimize(loss, begin, jac=True, method="L-BFGS-B", options={"maxiter": rounds})
    print(f"{len(known)} lessons, {found.fun:.1f} nats off")
    return np.asarray(found.x)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--people", type=Path, help="folder of recordings of people")
    parser.add_argument("--seeds", type=int, default=24)
    parser.add_argument("--rounds", type=int, default=25)
    given = parser.parse_args()
    shown = lessons(given.people, given.seeds)
    known = [one for one in (taken_apart(*each) for each in shown) if one is not None]
    usual = SegmentationSettings().decoding
    begin = np.array([float(getattr(usual, name)) for name in NAMES])
    for name, old, new in zip(NAMES, begin, fitted(known, begin, given.rounds), strict=True):
        print(f"{name:12}{old:8.2f}{new:8.2f}")


if __name__ == "__main__":
    main()
