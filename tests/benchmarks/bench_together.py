"""What several demonstrations of one task teach that one does not; one table.

    python -m tests.benchmarks.bench_together [--tasks N] [--most N]

For 1, 2, ... demonstrations learned together: F1 of the cuts of the lesson at 0.25 s and at
0.5 s, how far docking, grasping and releasing poses lie from what the teacher intends (median,
mm), whether free order and optional parts are asked about where the task has them (and where
it does not), and how many questions are asked.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from assistant.errors import WorkFailed
from assistant.learning.lesson import learn
from assistant.model.lesson import Lesson
from tests.benchmarks.segmentation_scores import Counts, f1, matched
from tests.generators.again import Several, several
from tests.generators.shown import Habit

FIRST_SEED = 80_000
SETS: tuple[tuple[Literal["A", "B"], Habit], ...] = (
    ("A", "fluent"),
    ("B", "fluent"),
    ("A", "slow"),
    ("B", "slow"),
)


@dataclass(slots=True)
class Tally:
    """What was found over all tasks for one number of demonstrations."""

    quarter: list[Counts]
    half: list[Counts]
    docking_mm: list[float]
    acting_mm: list[float]
    order: list[tuple[bool, bool]]
    optional: list[tuple[bool, bool]]
    questions: list[int]
    failed: int = 0


def judge(given: Several, count: int, tally: Tally) -> None:
    shows = given.shows[:count]
    try:
        lesson = learn([one.demonstration for one in shows], given.task)
    except WorkFailed:
        tally.failed += 1
        return
    best = next(one for one in shows if _is_from(lesson, one.demonstration.recording.t_s[-1]))
    cuts_s = lesson.segmentation.cuts_s
    tally.quarter.append(matched(cuts_s, best.cuts_s, 0.25))
    tally.half.append(matched(cuts_s, best.cuts_s, 0.5))
    for station in lesson.stations:
        away = station.docking_in_frame[:3] - given.docking[station.kind]
        tally.docking_mm.append(1000.0 * float(np.linalg.norm(away)))
        tally.acting_mm.append(1000.0 * float(np.linalg.norm(station.hand_in_frame[:3])))
    asked = lesson.segmentation.questions
    # Only what was shown can be inferred: another order at least once, a part left out once.
    orders = {tuple(one.names[:1]) for one in shows}
    told = {name for one in shows for name in one.names}
    leaves = {name for name in told if any(name not in one.names for one in shows)}
    tally.order.append((orders != {("approach cup",)}, any(one.asked == "order" for one in asked)))
    found = {one.about for one in asked if one.reason == "left_out_once"}
    lifts = sorted(given.optional | {"lift cup", "lift jar"})
    tally.optional += [(name in leaves, name in found) for name in lifts]
    tally.questions.append(len(asked))


def _is_from(lesson: Lesson, end_s: float) -> bool:
    told_s = lesson.segmentation.vote_t_s
    return told_s is not None and abs(float(told_s[-1]) - float(end_s)) < 1e-9


def _rates(pairs: Sequence[tuple[bool, bool]]) -> str:
    right = [found for true, found in pairs if true]
    false = [found for true, found in pairs if not true]
    return f"{sum(right)}/{len(right)} (+{sum(false)}/{len(false)})"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tasks", type=int, default=12)
    parser.add_argument("--most", type=int, default=5)
    given = parser.parse_args()
    print(
        f"  {'':10}  n  F1 ±.25  ±.5   docking mm  acting mm  "
        "order asked, true (+false)  left out, true (+false)  questions  failed"
    )
    for kind, habit in SETS:
        tasks = [several(FIRST_SEED + k, given.most, kind, habit) for k in range(given.tasks)]
        for count in range(1, given.most + 1):
            tally = Tally([], [], [], [], [], [], [])
            for task in tasks:
                judge(task, count, tally)
            print(
                f"  {kind} {habit:8} {count:2}  {f1(tally.quarter):.3f}   {f1(tally.half):.3f}  "
                f"{np.median(tally.docking_mm):8.2f}  {np.median(tally.acting_mm):9.2f}   "
                f"{_rates(tally.order):>22}      {_rates(tally.optional):>22}  "
                f"{np.mean(tally.questions):8.2f}  {tally.failed:5}",
                flush=True,
            )


if __name__ == "__main__":
    main()
