"""Paths carried to moved setups, ours beside the peers, on the same learned path.

Two tables: 60 setups near the demonstration's, and 60 drawn over the whole annulus that the arm
can reach, with random starts. The path is that of the shipped demonstration, already smoothed;
every method gets it and each setup's grasp and release poses. Speed and jerk are at the
demonstration's own timing for everybody; "axis" is how near any path comes to the axis of the
base, which a way straight across would hit; ours after timing as well, and the arm's timing of our
joint paths beside toppra's, the time-optimal one within the same limits.

run: python -m tests.benchmarks.bench_adaptation [--near | --annulus | --timing]
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from assistant.files.demonstrations import read_demonstration
from assistant.files.scenes import read_scene
from assistant.files.tasks import read_task
from assistant.geometry import (
    Array,
    angle_between,
    distance_between,
    quat_normalize,
    relative,
)
from assistant.learning.adaptation import AdaptationPlan, adapt, frames_in, plan_adaptation
from assistant.learning.lesson import learn
from assistant.learning.measures import measured
from assistant.learning.timing import hand_speeds, rms_jerk
from assistant.model.lesson import LearnedPath
from assistant.model.scene import Scene
from assistant.model.setup import Place, Setup
from assistant.model.task import Task
from sim.setups import random_setup
from tests.benchmarks.adaptation_peers import METHODS, Method, Query, hands

TASKS = Path(__file__).parents[2] / "tasks"
SETUPS, SWEPT, LAST_M, NEAR = 60, 15, 0.10, 1.05
Known = Sequence[tuple[Array, Array]]
"""Frames of the stations, and the start, of each setup."""


def taught() -> Task:
    """Return the shipped pick-and-place task as learned from the shipped demonstration."""
    task = read_task(TASKS / "pick_and_place.yaml")
    shown = read_demonstration(TASKS / "demonstrations" / "pick_and_place.yaml")
    scene = read_scene(TASKS / "scenes" / "demonstration_table.yaml")
    return replace(task, learned=learn([shown], task, scene=scene))


def thinned(task: Task, samples: int) -> Task:
    """Return the lesson with another number of samples."""
    lesson = task.learned
    assert lesson is not None
    assert lesson.path is not None
    old = lesson.path
    count = len(old.t_s)
    at = np.linspace(0, count - 1, samples)
    path = np.array([np.interp(at, np.arange(count), column) for column in old.path.T]).T
    path[:, 3:] = quat_normalize(path[:, 3:])
    gripper = np.interp(at, np.arange(count), old.gripper_m) if old.gripper_m is not None else None
    moved = [round(k * (samples - 1) / (count - 1)) for k in range(count)]
    stations = tuple(
        replace(one, at=moved[one.at], docking_at=moved[one.docking_at], left_at=moved[one.left_at])
        for one in lesson.stations
    )
    t_s = np.linspace(0.0, old.t_s[-1], samples)
    learned = LearnedPath(t_s, path, gripper, old.primitive_at[np.round(at).astype(int)])
    return replace(task, learned=replace(lesson, path=learned, stations=stations))


def near_setups(seed: int = 7) -> list[Setup]:
    """Return random moved setups: places within 15 cm, turns within 45 degrees."""
    rng = np.random.default_rng(seed)

    def place(xyz_mm: tuple[float, float, float], yaw_deg: float) -> Place:
        away = rng.uniform((-120, -120, -100), (60, 120, 20))
        x, y, z = (float(a + b) for a, b in zip(xyz_mm, away, strict=True))
        return Place("hand", (x, y, z), (0.0, 0.0, yaw_deg + float(rng.uniform(-45, 45))))

    return [
        Setup(
            f"moved {k}",
            robot_start=Place("hand", (406.4, float(rng.uniform(-150, 150)), 635.0)),
            places={
                "block": place((560.3, 196.8, 396.7), 0.0),
                "target": place((588.8, -201.7, 403.0), 0.0),
            },
        )
        for k in range(SETUPS)
    ]


def far_setups(task: Task, seed: int = 5) -> list[Setup]:
    """Return reachable setups over the whole annulus."""
    table = read_scene(TASKS / "scenes" / "table.yaml")
    return [random_setup(task, table, seed, number) for number in range(SETUPS)]


def scored(plan: AdaptationPlan, path: Array, frames: Array) -> list[float]:
    """Return errors (mm, deg), jerk and speed ratio, shape error and nearest to the axis (mm)."""
    shown, step_s = plan.ways.path, float(np.median(plan.steps_s))
    t_s = step_s * np.arange(len(shown), dtype=np.float64)
    out = []
    for goal, one in zip(hands(plan, frames), plan.stations, strict=True):
        out.append(1000.0 * float(distance_between(path[one.at], goal)))
        out.append(float(np.degrees(angle_between(path[one.at], goal))))
    out.append(rms_jerk(path[:, :3], step_s) / rms_jerk(shown[:, :3], step_s))
    out.append(float(np.max(hand_speeds(t_s, path)) / np.max(hand_speeds(t_s, shown))))
    steps = np.linalg.norm(np.diff(shown[:, :3], axis=0), axis=1)
    travel = np.concatenate([[0.0], np.cumsum(steps)])
    worst = 0.0
    for frame, one in zip(frames, plan.stations, strict=True):
        last = (travel >= travel[one.at] - LAST_M) & (np.arange(len(travel)) <= one.at)
        here, there = relative(frame, path[last]), relative(one.frame_to_world, shown[last])
        worst = max(worst, 1000.0 * float(np.max(distance_between(here, there))))
    return [*out, worst, 1000.0 * float(np.min(np.hypot(path[:, 0], path[:, 1])))]


def timed(call: Callable[[], object], least: int = 3) -> float:
    """Return the least processor time of a call in microseconds: other work only adds to it."""
    times: list[float] = []
    begun = time.perf_counter()
    while len(times) < least or (time.perf_counter() - begun < 0.3 and len(times) < 500):
        at = time.process_time()
        call()
        times.append(time.process_time() - at)
    return 1e6 * min(times)


def told(
    method: Method, plan: AdaptationPlan, thin: Sequence[AdaptationPlan], known: Known
) -> None:
    """Print a method's best setting: least jerk of those with about the least change of shape."""
    found: list[tuple[float, float, str, float, Query]] = []
    for setting, fit in method.fits.items():
        begun = time.process_time()
        query = fit(plan)
        fit_ms = 1000.0 * (time.process_time() - begun)
        few = known[::SWEPT] if len(method.fits) > 1 else known[:1]
        row = np.median([scored(plan, query(*one), one[0]) for one in few], axis=0)
        off = float(row[0] + row[2] + row[6])
        found.append((off, float(row[4]), setting, fit_ms, query))
    near = NEAR * min(one[0] for one in found) + 0.01
    _, _, setting, fit_ms, query = min(
        (one for one in found if one[0] <= near), key=lambda one: one[1]
    )
    rows = np.array([scored(plan, query(*one), one[0]) for one in known])
    medians, worst = np.median(rows, axis=0), np.percentile(rows[:, 4], 90)
    times = [timed(partial(method.fits[setting](one), *known[0])) for one in thin]
    print(
        f"{method.name:<30}{medians[0]:>9.2g}{medians[1]:>8.2g}{medians[2]:>9.2g}"
        f"{medians[3]:>8.2g}{medians[4]:>7.2f}{worst:>7.2f}{medians[5]:>8.2f}{medians[6]:>9.2g}"
        f"{np.min(rows[:, 7]):>9.0f}"
        f"{fit_ms:>9.1f}{times[0]:>9.0f}{times[1]:>9.0f}  {setting}",
        flush=True,
    )


def table(name: str, task: Task, scene: Scene, places: list[Setup]) -> None:
    """Print one table of all methods, then ours after timing."""
    plan = plan_adaptation(task)
    thin = [plan_adaptation(thinned(task, samples)) for samples in (200, 1000)]
    known = [(frames_in(plan, scene, one), one.robot_start.pose) for one in places]
    print(f"\n{len(places)} setups {name}, path of {len(plan.ways.path)} samples; medians")
    print(
        f"{'method':<30}{'grasp mm':>9}{'deg':>8}{'release':>9}{'deg':>8}{'jerk x':>7}{'p90':>7}"
        f"{'speed x':>8}{'10 cm mm':>9}{'axis mm':>9}{'fit ms':>9}{'200: us':>9}{'1000: us':>9}"
    )
    for method in METHODS:
        try:
            told(method, plan, thin, known)
        except ImportError as error:
            print(f"{method.name:<30} needs an extra: {error}", file=sys.stderr)
    rows = [measured(task, plan, adapt(plan, scene, one), scene, one) for one in places]
    print("ours after timing (median, 9th decile, worst):")
    for measure in rows[0]:
        values = np.percentile([row[measure] for row in rows], [50.0, 90.0, 100.0])
        print(f"  {measure:<20}" + "".join(f"{value:>12.3g}" for value in values))
    once = timed(lambda: plan_adaptation(task))
    for each in (plan, thin[-1]):
        times = [timed(partial(adapt, each, scene, one), 300) for one in places[::5]]
        print(
            f"  adapt with timing, {len(each.ways.path)} samples: median {np.median(times):.0f} us "
            f"a setup, worst {np.max(times):.0f} us; plan_adaptation {once:.0f} us a lesson"
        )


def main(chosen: Sequence[str]) -> int:
    """Print the tables asked for, or all."""
    task, scene = taught(), Scene(hand_speed_m_s=1.0)
    if not chosen or "--near" in chosen:
        table("near the demonstration's", task, scene, near_setups())
    if not chosen or "--annulus" in chosen:
        table("over the whole annulus", task, scene, far_setups(task))
    if not chosen or "--timing" in chosen:
        from tests.benchmarks.timing_bound import table as bound

        bound(task, read_scene(TASKS / "scenes" / "table.yaml"), far_setups(task)[:20])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
