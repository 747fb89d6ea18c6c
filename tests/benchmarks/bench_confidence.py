"""How much the robot's confidence is worth, and where its weights come from; one table.

    python -m tests.benchmarks.bench_confidence [--people DIR] [--seeds N] [--fit]

Judged are the shipped weights on seeds and drawn cues that no fit has seen (people's own
recordings were seen), then weights fitted without one kind of demonstrations on that kind:
a generator, or a person. `--fit` prints the weights that `assistant.learning.confidence` holds,
and judges these. Of a people's few cuts even perfect chances look a little wrong: by how much is
printed beside their error.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

from assistant.errors import WorkFailed
from assistant.geometry import Array
from assistant.learning import confidence
from assistant.learning.questions import LEFT_OUT, UNHEARD, UNSURE
from assistant.learning.reading import Understood, read
from assistant.learning.segmentation import gathered
from assistant.model.settings import SegmentationSettings
from tests.benchmarks.bench_segmentation import HABITS, of_people, without_cues
from tests.benchmarks.segmentation_lessons import other_length
from tests.benchmarks.segmentation_scores import auroc, brier, calibration_error, matched
from tests.generators import generator_a, generator_b
from tests.generators.shown import Shown, spoken_cues

FIT_SEED, JUDGE_SEED = 20_000, 63_000
WITHIN_S = 0.5
STRENGTHS = (3.0, 1.0)
"""Of the ridge, for cuts and for lessons."""


@dataclass(frozen=True, slots=True, eq=False)
class Judged:
    """One demonstration, what the robot knew of its cuts, and which of them were right."""

    kind: str
    way: str
    cuts: Array
    right: Array
    whole: Array
    all_right: bool
    step_asked: bool
    """A step is asked about that was not introduced, or not shown."""

    @property
    def weight(self) -> float:
        # Teachers seldom say nothing or introduce another task; but they may.
        return 1.0 if self.way == "as shown" else 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Weights:
    cuts: Array
    cut_bias: float
    whole: Array
    whole_bias: float

    def of_cuts(self, one: Judged) -> Array:
        return _sigmoid(one.cuts @ self.cuts + self.cut_bias)

    def of_lesson(self, one: Judged) -> float:
        return float(_sigmoid(self.whole_features(one) @ self.whole + self.whole_bias))

    def whole_features(self, one: Judged) -> Array:
        chance = min(max(float(np.prod(self.of_cuts(one))), 1e-3), 1.0 - 1e-3)
        return np.array([np.log(chance / (1.0 - chance)), *one.whole[1:]])


def shipped() -> Weights:
    return Weights(
        confidence.WEIGHTS, confidence.BIAS, confidence.WHOLE_WEIGHTS, confidence.WHOLE_BIAS
    )


def drawn(people: dict[str, list[Shown]], seeds: int, first: int) -> list[Judged]:
    """Return the lessons of both generators, and of people with cues drawn anew."""
    found: list[Judged | None] = []
    for name, generate in (("A", generator_a.generate), ("B", generator_b.generate)):
        for habit in HABITS:
            for k in range(seeds if habit != "keys" else seeds // 2):
                shown = generate(first + k, habit)
                found.append(judged(f"{name} {habit}", "as shown", shown))
                if k % 4 == 0:
                    found.append(judged(f"{name} {habit}", "no cues", without_cues(shown)))
                if k % 4 == 2:
                    longer = other_length(shown, k, longer=k % 8 == 2)
                    found.append(judged(f"{name} {habit}", "one step off", longer))
                if k % 6 == 3:
                    other = replace(shown, task=generate(first - 1 - k, habit).task)
                    found.append(judged(f"{name} {habit}", "another tree", other))
                if k % 3 == 1:
                    found.append(judged(f"{name} {habit}", "no gripper", without_gripper(shown)))
    for kind, shows in people.items():
        for shown in shows:
            drawn_anew = [redrawn(shown, first + k) for k in range(seeds // 12)]
            found += [judged(kind, "as shown", one) for one in drawn_anew]
    return [one for one in found if one is not None]


def by_person(folder: Path) -> dict[str, list[Shown]]:
    """Return people's recordings by who made them: the beginning of a recording's name."""
    found: dict[str, list[Shown]] = {}
    for shows in of_people(folder).values():
        for shown in shows:
            person = Path(shown.demonstration.source).stem.split("_")[0]
            found.setdefault(person, []).append(shown)
    return found


def redrawn(shown: Shown, seed: int) -> Shown:
    """Return the same showing with other cues, of another teacher."""
    end_s = float(shown.demonstration.recording.t_s[-1])
    cues = spoken_cues(list(shown.cuts_s), end_s, np.random.default_rng([seed, 77]))
    return replace(shown, demonstration=replace(shown.demonstration, cues=cues))


def without_gripper(shown: Shown) -> Shown:
    recording = replace(shown.demonstration.recording, gripper_m=None)
    return replace(shown, demonstration=replace(shown.demonstration, recording=recording))


def judged(kind: str, way: str, shown: Shown) -> Judged | None:
    settings = SegmentationSettings()
    try:
        evidence = gathered(shown.demonstration, shown.task, settings)
    except WorkFailed:
        return None
    told = read(shown.demonstration, shown.task, evidence, settings)
    nodes = told.reading.nodes[1:-1]
    cuts_s = told.at_s[list(nodes)]
    cues_s = np.array([cue.at_s for cue in shown.demonstration.cues])
    cues_s = cues_s - (told.lag.best_s if told.lag else 0.0)
    hits, mine, true = matched(cuts_s.tolist(), shown.cuts_s, WITHIN_S)
    away = np.abs(cuts_s[:, None] - np.array(shown.cuts_s)[None, :])
    return Judged(
        kind,
        way,
        _features(told, cues_s),
        np.min(away, axis=1, initial=np.inf) <= WITHIN_S,
        confidence.whole_features(told, np.ones(len(nodes)), cues_s),
        hits == mine == true,
        _step_asked(told),
    )


def _step_asked(told: Understood) -> bool:
    taken = told.reading.taken
    seen = None not in taken and len(taken) == len(told.order)
    chances = [*told.left_out().values(), 0.0]
    unheard = any(chance > UNHEARD for _, _, chance in told.unheard())
    return not seen or unheard or max(chances) > LEFT_OUT


def _features(told: Understood, cues_s: Array) -> Array:
    rows = [confidence.features(told, node, cues_s) for node in told.reading.nodes[1:-1]]
    return np.array(rows).reshape(len(rows), len(confidence.FEATURES))


def fitted(shown: Sequence[Judged]) -> Weights:
    """Return the weights that explain best which cuts, and which lessons, were right."""
    # Steps that were not shown, or not told, are asked about anyway.
    lessons = [one for one in shown if one.way not in ("one step off", "another tree")]
    rows = np.concatenate([one.cuts for one in lessons])
    right = np.concatenate([one.right for one in lessons])
    counted = np.concatenate([np.full(len(one.right), one.weight) for one in lessons])
    cuts, cut_bias = _regression(rows, right, counted, STRENGTHS[0])
    half = Weights(cuts, cut_bias, np.zeros(0), 0.0)
    whole, whole_bias = _regression(
        np.array([half.whole_features(one) for one in lessons]),
        np.array([one.all_right for one in lessons]),
        np.array([one.weight for one in lessons]),
        STRENGTHS[1],
    )
    return Weights(cuts, cut_bias, whole, whole_bias)


def _regression(rows: Array, right: Array, counted: Array, ridge: float) -> tuple[Array, float]:
    y = right.astype(float)

    def loss(given: Array) -> tuple[float, Array]:
        odds = rows @ given[:-1] + given[-1]
        off = counted * (_sigmoid(odds) - y)
        value = np.sum(counted * (np.logaddexp(0.0, odds) - y * odds))
        slope = np.append(rows.T @ off + ridge * given[:-1], np.sum(off))
        return float(value + 0.5 * ridge * np.sum(given[:-1] ** 2)), slope

    best = minimize(loss, np.zeros(rows.shape[1] + 1), jac=True, method="L-BFGS-B").x
    return best[:-1], float(best[-1])


def _sigmoid(odds: Array) -> Array:
    return np.asarray(1.0 / (1.0 + np.exp(-odds)))


def line(name: str, lessons: Sequence[Judged], weights: Weights) -> str:
    """Return calibration of cuts and of lessons, and what is asked about."""
    p = np.concatenate([weights.of_cuts(one) for one in lessons])
    y = np.concatenate([one.right for one in lessons]).astype(float)
    sure = np.array([weights.of_lesson(one) for one in lessons])
    fine = np.array([one.all_right for one in lessons])
    asked = (sure < UNSURE) | np.array([one.step_asked for one in lessons])
    return (
        f"  {name:26}{len(lessons):5}  {np.mean(y):.3f}  {calibration_error(p, y):.3f} "
        f"{_unavoidable(p):.3f}  {brier(p, y):.3f}  {auroc(p, y):.3f}     {np.mean(fine):.2f}   "
        f"{calibration_error(sure, fine.astype(float)):.3f}  "
        f"{auroc(sure, fine.astype(float)):.3f}   "
        f"{_share(asked[~fine])}   {_share(asked[fine])}"
    )


def _unavoidable(p: Array, rounds: int = 200) -> float:
    """Return the mean calibration error of so many cuts if their chances were perfect."""
    drawn = np.random.default_rng(0).random((rounds, len(p))) < p
    return float(np.mean([calibration_error(p, y.astype(float)) for y in drawn]))


def _share(told: Array) -> str:
    return f"{np.mean(told):.2f}" if len(told) else "   -"


HEADER = (
    f"  {'':26}    n  right  ECE   (by chance) Brier AUROC lessons: right  ECE    AUROC   "
    "asked: of wrong, of right"
)


def report(title: str, lessons: Sequence[Judged], of: Callable[[str], Weights]) -> None:
    """Print a line for each kind and for each way of showing."""
    print(f"\n{title}\n{HEADER}")
    plain = [one for one in lessons if one.way == "as shown"]
    for kind in dict.fromkeys(one.kind for one in plain):
        print(line(kind, [one for one in plain if one.kind == kind], of(kind)))
    for way in ("no cues", "no gripper", "one step off", "another tree"):
        mine = [one for one in lessons if one.way == way]
        print(line(f"generators, {way}", mine, of(mine[0].kind)))


def curve(lessons: Sequence[Judged], weights: Weights) -> str:
    """Return the shares of wrong and of right lessons asked about, over the threshold."""
    plain = [one for one in lessons if one.way == "as shown"]
    sure = np.array([weights.of_lesson(one) for one in plain])
    fine = np.array([one.all_right for one in plain])
    told = []
    for below in (0.3, 0.4, 0.5, 0.6, 0.65, 0.7, 0.8, 0.9):
        asked = (sure < below) | np.array([one.step_asked for one in plain])
        told.append(f"{below:.2f}: {np.mean(asked[~fine]):.2f}/{np.mean(asked[fine]):.2f}")
    ranked, best = auroc(sure, fine.astype(float)), best_possible(sure)
    return "  ".join(told) + f"\n  AUROC {ranked:.3f}; at best {best:.2f} of wrong at .05 of right"


def best_possible(sure: Array) -> float:
    """Return the share of wrong lessons that asking about 5 % of right ones can find.

    That is, if the chances were perfect: no threshold on them finds more.
    """
    order = np.argsort(sure)
    wrong = np.cumsum(1.0 - sure[order]) / np.sum(1.0 - sure)
    right = np.cumsum(sure[order]) / np.sum(sure)
    return float(np.interp(0.05, right, wrong))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--people", type=Path, help="folder of recordings of people")
    parser.add_argument("--seeds", type=int, default=48)
    parser.add_argument("--fit", action="store_true", help="print the weights as fitted")
    given = parser.parse_args()
    people = by_person(given.people) if given.people else {}
    seen = drawn(people, 2 * given.seeds, FIT_SEED)
    lessons = drawn(people, given.seeds, JUDGE_SEED)
    found = fitted(seen) if given.fit else shipped()
    if given.fit:
        print(f"WEIGHTS = {np.round(found.cuts, 2).tolist()}  BIAS = {found.cut_bias:.2f}")
        print(f"WHOLE_WEIGHTS = {np.round(found.whole, 2).tolist()}", end="  ")
        print(f"WHOLE_BIAS = {found.whole_bias:.2f}")
    which = "as fitted" if given.fit else "as shipped"
    report(f"{which}, unseen seeds and cues", lessons, lambda kind: found)
    made_up = [one for one in lessons if one.kind[:2] in ("A ", "B ")]
    for name, group in (("all", lessons), ("generators", made_up)):
        print(f"  {name}, of wrong/of right asked, over the threshold: {curve(group, found)}")
    families = {kind: kind.split()[0] for kind in dict.fromkeys(one.kind for one in lessons)}
    without = {
        family: fitted([one for one in seen if families[one.kind] != family])
        for family in dict.fromkeys(families.values())
    }
    report("fitted without that generator or person", lessons, lambda k: without[families[k]])


if __name__ == "__main__":
    main()
