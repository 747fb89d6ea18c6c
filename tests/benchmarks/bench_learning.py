"""How long learning takes, imports aside: the shipped demonstrations, and longer ones.

run: python -m tests.benchmarks.bench_learning
"""

from __future__ import annotations

import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from assistant.files.demonstrations import read_demonstration
from assistant.files.scenes import find_scene
from assistant.files.tasks import read_task
from assistant.learning.lesson import learn, load_libraries
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.task import Task

TASKS = Path(__file__).parents[2] / "tasks"
ROUNDS = 7


def finer(shown: Demonstration, times: int) -> Demonstration:
    """Return the demonstration recorded at a rate so many times higher."""
    old = shown.recording
    t_s = np.linspace(old.t_s[0], old.t_s[-1], times * len(old.t_s))
    path = np.array([np.interp(t_s, old.t_s, column) for column in old.path.T]).T
    gripper = None if old.gripper_m is None else np.interp(t_s, old.t_s, old.gripper_m)
    return replace(shown, recording=Recording(t_s, path, gripper))


def tell(name: str, task: Task, shown: list[Demonstration], path: Path) -> None:
    """Print the median and the best time of learning."""
    scene = find_scene(shown[-1].setup.scene, path)
    times = []
    for _ in range(ROUNDS):
        # A copy, so that nothing remembered of an earlier round helps.
        fresh = [replace(one, recording=replace(one.recording)) for one in shown]
        begun = time.perf_counter()
        learn(fresh, task, scene=scene)
        times.append(time.perf_counter() - begun)
    samples = sum(len(one.recording.t_s) for one in shown)
    print(f"{name:<34}{samples:>9}{np.median(times):>11.3f}{min(times):>9.3f}")


def main() -> int:
    """Print one table."""
    load_libraries()
    print(f"{'demonstration':<34}{'samples':>9}{'median s':>11}{'best s':>9}")
    for name in ("pick_and_place", "stacking"):
        task = read_task(TASKS / f"{name}.yaml")
        path = TASKS / "demonstrations" / f"{name}.yaml"
        shown = read_demonstration(path)
        tell(name, task, [shown], path)
        if name == "pick_and_place":
            tell("  recorded 4 times as fast", task, [finer(shown, 4)], path)
            tell("  three together", task, [shown] * 3, path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
