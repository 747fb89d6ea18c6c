"""Cuts of ours and of others on the same demonstrations; one table.

    python -m tests.benchmarks.bench_segmentation [--people DIR] [--seeds N] [--only SET] [--quick]

DIR holds recordings of people with their truth (folders with NAME.yaml, tree.yaml or
NAME.tree.yaml, and truth.json). Peers are shown where they are installed: pip install ruptures
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from assistant.files.demonstrations import read_demonstration
from assistant.files.tasks import read_task
from assistant.learning.smoothing import Smoothed
from assistant.model.lesson import Segmentation
from assistant.model.settings import SegmentationSettings, paper
from assistant.model.task import Action, Primitive, Subtask, Task, primitives
from tests.benchmarks import segmentation_peers as peers
from tests.benchmarks.segmentation_lessons import (
    UNSEEN,
    episodes_right,
    orders_recognized,
    other_length,
    ours,
    steps_named,
    told_coarsely,
)
from tests.benchmarks.segmentation_scores import (
    auroc,
    brier,
    calibration_error,
    f1,
    interval,
    matched,
)
from tests.generators import generator_a, generator_b
from tests.generators.shown import Habit, Shown

FIRST_SEED = 90_000
TOLERANCES_S = (0.25, 0.5)
Sets = dict[str, list[Shown]]
HABITS: tuple[Habit, ...] = ("fluent", "slow", "keys")


def made_up(seeds: int) -> Sets:
    sets: Sets = {}
    for name, generate in (("A", generator_a.generate), ("B", generator_b.generate)):
        for habit in HABITS:
            count = seeds if habit == "fluent" else seeds // 2
            sets[f"{name} {habit}"] = [generate(FIRST_SEED + k, habit) for k in range(count)]
    return sets


def of_people(folder: Path) -> Sets:
    """Read every folder with a truth.json below a folder."""
    sets: Sets = {}
    for truth_file in sorted(folder.rglob("truth.json")):
        truth = json.loads(truth_file.read_text(encoding="utf-8"))
        sets[truth_file.parent.name] = [
            _shown(truth_file.parent, name, told) for name, told in sorted(truth.items())
        ]
    return sets


def _shown(folder: Path, name: str, told: dict[str, list[float]]) -> Shown:
    own = folder / f"{name}.tree.yaml"
    task = read_task(own if own.exists() else folder / "tree.yaml")
    names = tuple(leaf.name for leaf in primitives(task.tree))[: len(told["cuts"]) + 1]
    return Shown(read_demonstration(folder / f"{name}.yaml"), task, tuple(told["cuts"]), names)


def without_cues(shown: Shown) -> Shown:
    return replace(shown, demonstration=replace(shown.demonstration, cues=()))


def without_introduction() -> SegmentationSettings:
    """Let every stretch be a step nobody introduced, at no cost."""
    usual = SegmentationSettings()
    return replace(usual, decoding=replace(usual.decoding, insert=0.0, skip_optional=0.0))


def nothing_told(shown: Shown) -> Shown:
    leaf = Primitive("anything", Action("free", "anything"), optional=True)
    return replace(shown, task=Task("unknown", Subtask("unknown", (leaf,))))


Row = tuple[str, Callable[[list[Shown]], list[Sequence[float]]]]


def rows(shows: list[Shown], smoothed: list[Smoothed], *, quick: bool) -> Iterator[Row]:
    """Yield every method's name and what it finds; if quick, ours and cues only."""
    shift_s = peers.best_shift(shows, TOLERANCES_S[-1])

    known: dict[int, list[list[float]]] = {}

    def of(cutter: peers.Cutter, cues: bool) -> Callable[[list[Shown]], list[Sequence[float]]]:
        def find(given: list[Shown]) -> list[Sequence[float]]:
            if id(cutter) not in known:
                pairs = zip(given, smoothed, strict=True)
                known[id(cutter)] = [cutter(shown, path) for shown, path in pairs]
            found = known[id(cutter)]
            if not cues:
                return list(found)
            both = zip(found, given, strict=True)
            return [peers.with_cues(cuts, shown, shift_s) for cuts, shown in both]

        return find

    def best_of(cutters: list[peers.Cutter]) -> peers.Cutter:
        def score(cutter: peers.Cutter) -> float:
            found = of(cutter, False)(shows)
            pairs = zip(found, shows, strict=True)
            return f1([matched(cuts, s.cuts_s, TOLERANCES_S[-1]) for cuts, s in pairs])

        return max(cutters, key=score)

    yield "cues alone, best constant", lambda given: [peers.shifted(s, shift_s) for s in given]
    simple: dict[str, peers.Cutter] = {
        "MSV minima": peers.msv_minima,
        "zero velocity": peers.zero_velocity,
    }
    named = simple
    if not quick:
        named |= {name: best_of(cs) for name, cs in peers.ruptures_cutters().items()}
    for name, cutter in named.items():
        yield f"{name}, count", of(cutter, False)
        yield f"{name}, count + cues", of(cutter, True)
    yield "vote, paper's constants", lambda given: [ours(s, paper()).cuts_s for s in given]
    bare = without_introduction()
    yield (
        "ours without introduction",
        lambda given: [ours(nothing_told(s), bare).cuts_s for s in given],
    )
    yield "ours without cues", lambda given: [ours(without_cues(s)).cuts_s for s in given]
    yield "ours", lambda given: [ours(s).cuts_s for s in given]
    for name, longer in (("ours, tree one step short", False), ("ours, tree one step long", True)):
        yield name, partial(_with_other_tree, longer=longer)


def _with_other_tree(given: Sequence[Shown], *, longer: bool) -> list[Sequence[float]]:
    return [ours(other_length(s, k, longer=longer)).cuts_s for k, s in enumerate(given)]


def asked_about(shown: Shown, found: Segmentation) -> tuple[bool, bool]:
    """Return whether the robot asks about the cutting at all, and about what is wrong.

    A wrong cut is asked about if it is named; a missing one if a step is said to be missing, or
    a cut next to it is named.
    """
    edges = [-np.inf, *found.cuts_s, np.inf]
    wrong = [c for c in found.cuts_s if min(abs(c - t) for t in shown.cuts_s) > TOLERANCES_S[-1]]
    for true in shown.cuts_s:
        if min((abs(c - true) for c in found.cuts_s), default=np.inf) > TOLERANCES_S[-1]:
            after = int(np.searchsorted(edges, true))
            wrong += [edges[after - 1], edges[after]]
    asked = about = False
    for question in found.questions:
        at_s = float(str(question.facts.get("at_s", "nan")))
        if question.reason in (*UNSEEN, "never_introduced", "unsure_cut"):
            asked = True
            about |= question.reason != "unsure_cut" or any(abs(at_s - c) < 1e-6 for c in wrong)
    return asked, about


def confidence_line(shows: list[Shown]) -> str:
    """Return calibration of cuts and how well questions find the lessons that went wrong."""
    chances, right, asked = [], [], {True: [0, 0, 0], False: [0, 0, 0]}
    for shown in shows:
        found = ours(shown)
        cuts = [p for p in found.points if p.kept and not p.internal]
        near = [min((abs(p.at_s - t) for t in shown.cuts_s), default=9.0) <= 0.5 for p in cuts]
        chances += [p.confidence for p in cuts]
        right += near
        hits, mine, true = matched(found.cuts_s, shown.cuts_s, 0.5)
        tally = asked[hits == mine == true]
        for k, told in enumerate((*asked_about(shown, found), True)):
            tally[k] += told
    p, y = np.array(chances), np.array(right, dtype=float)
    wrong, fine = asked[False], asked[True]
    return (
        f"ECE {calibration_error(p, y):.3f}  Brier {brier(p, y):.3f}  AUROC {auroc(p, y):.3f}  "
        f"asked in {wrong[0]}/{wrong[2]} wrong lessons (about what is wrong in {wrong[1]}), "
        f"in {fine[0]}/{fine[2]} right ones"
    )


def report(name: str, shows: list[Shown], *, quick: bool) -> None:
    cuts = sum(len(shown.cuts_s) for shown in shows)
    print(f"\n{name}: {len(shows)} demonstrations, {cuts} cuts")
    print(
        f"  {'method':34}"
        + "".join(f"  F1 ±{t} s [95 %]      " for t in TOLERANCES_S)
        + "  ms each"
    )
    smoothed = peers.smoothed_of(shows)
    for label, find in rows(shows, smoothed, quick=quick):
        if quick and not label.startswith(("ours", "cues")):
            continue
        began = time.perf_counter()
        found = find(shows)
        each_ms = 1000.0 * (time.perf_counter() - began) / len(shows)
        line = f"  {label:34}"
        for within_s in TOLERANCES_S:
            pairs = zip(found, shows, strict=True)
            counts = [matched(cut, shown.cuts_s, within_s) for cut, shown in pairs]
            low, high = interval(counts)
            line += f"  {f1(counts):.3f} [{low:.2f}, {high:.2f}]  "
        print(line + f"  {each_ms:7.1f}", flush=True)
    own, true = (episodes_right(shows, true_cuts=given) for given in (False, True))
    print(f"  episodes right: on own cuts {own:.3f}, on true cuts {true:.3f}")
    coarse = [one for k, s in enumerate(shows) if (one := told_coarsely(s, k)) is not None]
    told = [matched(ours(s).cuts_s, s.cuts_s, TOLERANCES_S[-1]) for s in coarse]
    if told:
        print(f"  told by steps of the hand only: F1 ±{TOLERANCES_S[-1]} s {f1(told):.3f}")
    print(f"  shown in another order than told, recognized: {orders_recognized(shows)}")
    print(f"  steps named in a question: {steps_named(shows)}")
    print(f"  confidence: {confidence_line(shows)}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--people", type=Path, help="folder of recordings of people")
    parser.add_argument("--seeds", type=int, default=40)
    parser.add_argument("--quick", action="store_true", help="ours and cues only")
    parser.add_argument("--only", default="", help="sets whose name begins so")
    given = parser.parse_args()
    sets = made_up(given.seeds)
    if given.people is not None:
        sets |= of_people(given.people)
    for name in [name for name in sets if name.startswith(given.only)]:
        shows = sets[name]
        report(name, shows, quick=given.quick)


if __name__ == "__main__":
    main()
