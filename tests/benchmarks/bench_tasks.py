"""Every shipped task in random setups it can be done in, by its own measure of success.

python -m tests.benchmarks.bench_tasks [--setups N] [--seed S] [--sector all] [--arm kinematic]
                                       [TASK ...]

Each task is learned from the demonstration that ships and practiced in setups drawn for it
(`sim.setups`): what is pushed stands before its line, what is poured lies in its cup. One line
a task, then every setup that was not done, with the reason.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from assistant.cli.fitting import fitting_scene
from assistant.files.demonstrations import read_demonstration
from assistant.files.scenes import find_scene
from assistant.files.tasks import read_task
from assistant.learning.adaptation import plan_adaptation
from assistant.learning.lesson import learn
from assistant.model.task import Task
from assistant.ports import Arm
from assistant.session.practice import SetupResult, practice_setup, success_interval
from sim.bullet_arm import BulletArm
from sim.kinematic_arm import KinematicArm
from sim.planner import A465Planner
from sim.sensor import InHandSensor
from sim.setups import random_setup

TASKS = Path(__file__).parents[2] / "tasks"
NAMES = tuple(sorted(path.stem for path in (TASKS / "demonstrations").glob("*.yaml")))


@dataclass
class Row:
    """What became of one task's setups."""

    name: str
    results: list[SetupResult] = field(default_factory=list)
    cpu_s: float = 0.0

    def count(self, status: str) -> int:
        return sum(result.status == status for result in self.results)

    def measures(self) -> str:
        """Return median and worst of what tells success."""
        placed = [r.distance_mm for r in self.results if r.distance_mm is not None]
        turned = [r.angle_deg for r in self.results if r.angle_deg is not None]
        told = []
        if placed:
            told.append(f"off {np.median(placed):.3f} mm (worst {max(placed):.3f})")
            told.append(f"turned {np.median(turned):.3f} deg (worst {max(turned):.3f})")
        kinds: dict[tuple[str, str], list[float]] = {}
        for result in self.results:
            for one in result.measures:
                kinds.setdefault((one["kind"], one["unit"]), []).append(one["value"])
        for (kind, unit), values in kinds.items():
            worst = max(values) if kind == "edge" else min(values)
            told.append(f"{kind} {np.median(values):.2f} {unit} (worst {worst:.2f})")
        return ", ".join(told)

    def line(self) -> str:
        done, total = self.count("done"), len(self.results)
        low, high = success_interval(done, total)
        counts = f"{done:>3}/{total:<3} [{low:4.0%},{high:5.0%}]"
        failed = f"{self.count('missed'):>6} {self.count('refused'):>7}"
        return f"{self.name:<15} {counts} {failed} {self.cpu_s / total:7.1f}  {self.measures()}"


def learned(name: str) -> Task:
    task = read_task(TASKS / f"{name}.yaml")
    path = TASKS / "demonstrations" / f"{name}.yaml"
    shown = read_demonstration(path)
    return replace(task, learned=learn([shown], task, scene=find_scene(shown.setup.scene, path)))


def practiced(name: str, args: argparse.Namespace) -> Row:
    task = learned(name)
    scene = fitting_scene(task, TASKS / f"{name}.yaml")
    plan, row = plan_adaptation(task), Row(name)
    begun = time.process_time()
    for number in range(1, args.setups + 1):
        setup = random_setup(task, scene, args.seed, number, args.sector)
        sensor = InHandSensor(seed=number)
        arm: Arm = (
            KinematicArm(sensor=sensor) if args.arm == "kinematic" else BulletArm(sensor=sensor)
        )
        row.results.append(
            practice_setup(task, scene, setup, arm=arm, planner=A465Planner(), plan=plan)
        )
    row.cpu_s = time.process_time() - begun
    return row


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("tasks", nargs="*", choices=(*NAMES, []), metavar="TASK")
    parser.add_argument("--setups", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--sector", choices=("front", "all"), default="all")
    parser.add_argument("--arm", choices=("pybullet", "kinematic"), default="pybullet")
    args = parser.parse_args()
    print(f"{'task':<15} {'done':>8} {'95 %':<12} missed refused   CPU s  success by")
    rows = []
    for name in args.tasks or NAMES:
        rows.append(practiced(name, args))
        print(rows[-1].line(), flush=True)
    for row in rows:
        for result in row.results:
            if result.status != "done":
                print(f"  {row.name} {result.name} {result.status}: {result.reason}")


if __name__ == "__main__":
    main()
