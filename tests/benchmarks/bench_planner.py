"""Planning in random setups over the whole annulus: what is done, how long it takes.

Every setup is one that the plain check (`sim.feasibility`) calls reachable. Without a learned
task the paths are minimum-jerk pieces; with one they are adapted from what was learned.

    python -m tests.benchmarks.bench_planner [--setups N] [--seed S] [--learned FILE]
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from collections.abc import Callable
from itertools import islice
from pathlib import Path

import numpy as np

from assistant.files.scenes import find_scene
from assistant.geometry import angle_between, distance_between
from assistant.model.motion import HandPath, JointPath
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from assistant.session.practice import success_interval
from sim.kinematics import forward
from sim.planner import A465Planner
from sim.setups import random_setups
from tests.sim.hand_paths import pick_and_place, taught
from tests.sim.test_timing import peaks


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--setups", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--sector", choices=("front", "all"), default="all")
    parser.add_argument("--learned", type=Path)
    args = parser.parse_args()
    scene = find_scene("table", Path())
    task, path_of = made() if args.learned is None else adapted(args.learned, scene)
    planner, walls, shares, longer = A465Planner(), [], [], []
    worst = np.zeros(5)
    counts: Counter[str] = Counter()
    for setup in islice(random_setups(task, scene, args.seed, args.sector), args.setups):
        path = path_of(scene, setup)
        began = time.perf_counter()
        motion = planner.plan(path, scene, setup)
        walls.append(time.perf_counter() - began)
        if not isinstance(motion, JointPath):
            print(f"{setup.name} refused: {motion}")
            counts["refused"] += 1
            continue
        counts["done"] += 1
        counts["as adapted" if not motion.note else "led around"] += 1
        worst = np.maximum(worst, (*peaks(motion.q), *stop_errors(path, motion)))
        shares.append(walls[-1] / motion.t_s[-1])
        longer.append(motion.t_s[-1] / path.t_s[-1])
    low, high = success_interval(counts["done"], args.setups)
    print(dict(counts), f"success {counts['done'] / args.setups:.1%} ({low:.1%} to {high:.1%})")
    print(
        f"plan: median {1e3 * np.median(walls):.0f} ms, 95 % {1e3 * np.quantile(walls, 0.95):.0f}"
        f" ms, worst {1e3 * max(walls):.0f} ms; {1 / np.median(shares):.0f} x real time"
    )
    print(
        f"lasts longer than the hand's own timing: median {np.median(longer):.2f} x, "
        f"worst {max(longer):.2f} x"
    )
    names = ("joint speed ratio", "acceleration ratio", "hand m/s", "stop m", "stop rad")
    print(
        "worst:", ", ".join(f"{name} {value:.3g}" for name, value in zip(names, worst, strict=True))
    )


PathOf = Callable[[Scene, Setup], HandPath]


def made() -> tuple[Task, PathOf]:
    return taught(), pick_and_place


def adapted(learned: Path, scene: Scene) -> tuple[Task, PathOf]:
    from assistant.files.tasks import read_task
    from assistant.learning.adaptation import adapt, plan_adaptation

    task = read_task(learned)
    plan = plan_adaptation(task)
    return task, lambda scene, setup: adapt(plan, scene, setup)


def stop_errors(path: HandPath, motion: JointPath) -> tuple[float, float]:
    pairs = list(zip(path.stops, motion.stops, strict=True))
    wanted = np.stack([path.path[stop.at] for stop, _ in pairs])
    reached = forward(np.stack([motion.q[stop.at] for _, stop in pairs]))
    return (
        float(distance_between(reached, wanted).max()),
        float(angle_between(reached, wanted).max()),
    )


if __name__ == "__main__":
    main()
