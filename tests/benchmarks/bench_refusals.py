"""Setups that cannot be reached: refused before anything moves, with all there is to tell?

python -m tests.benchmarks.bench_refusals [--setups N] [--seed S]

Places are drawn in three ways: as for practice, but kept where the plain check
(`sim.feasibility`) says no; anywhere within 0.9 m, at any height and leaning; and just within
reach and above the table, where limits and collisions forbid more than the reach does. A full
refusal names a pose, by how much it fails, what would help, and the joint or body where one is
concerned.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator

import numpy as np

from assistant.cli.fitting import fitting_scene
from assistant.learning.adaptation import adapt, plan_adaptation
from assistant.model.motion import Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Place, Setup, Triple
from assistant.model.task import Task
from sim.feasibility import reachable
from sim.planner import A465Planner
from sim.setups import drawn_setup, drawn_start, postures
from tests.benchmarks.bench_tasks import TASKS, learned

ANYWHERE = ((150.0, 900.0), (60.0, 700.0))
NEAR = ((250.0, 680.0), (300.5, 460.0))
"""Distance from the base's axis and height of the flange, in mm."""
LEAN_DEG, LEANING = 30.0, 0.3
HALF_DEG = 180.0


def scattered(
    random: np.random.Generator, scene: Scene, bounds: tuple[tuple[float, float], ...]
) -> Setup:
    """Return a setup whose places know nothing of the arm."""
    radii, heights = bounds
    places = {}
    for name in ("block", "target"):
        ray, radius = random.uniform(-np.pi, np.pi), random.uniform(*radii)
        leans = random.uniform(-LEAN_DEG, LEAN_DEG, 2) * (random.uniform(size=2) < LEANING)
        xyz = (radius * np.cos(ray), radius * np.sin(ray), random.uniform(*heights))
        rpy = (leans[0], leans[1], random.uniform(-180.0, 180.0))
        places[name] = Place("hand", _rounded(xyz), _rounded(rpy))
    return Setup("scattered", scene.name, drawn_start(random, HALF_DEG), places)


def _rounded(values: tuple[float, float, float]) -> Triple:
    return (round(float(values[0]), 1), round(float(values[1]), 1), round(float(values[2]), 1))


def unreachable(how: str, task: Task, scene: Scene, random: np.random.Generator) -> Iterator[Setup]:
    """Yield setups the plain check says cannot be done, without end."""
    while True:
        if how == "drawn":
            found = drawn_setup(task, scene, random, "all", drawn_start(random, HALF_DEG))
        else:
            found = scattered(random, scene, ANYWHERE if how == "anywhere" else NEAR)
        if found is not None and not reachable(postures(task, scene, found), scene):
            yield found


def full(refusal: Refusal) -> bool:
    """Return whether a refusal tells all there is to tell."""
    named = bool(refusal.what) or refusal.reason == "reach"
    return bool(refusal.where and refusal.unit and refusal.hint) and named and refusal.amount > 0.0


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--setups", type=int, default=100)
    parser.add_argument("--seed", type=int, default=77)
    args = parser.parse_args()
    task = learned("pick_and_place")
    scene = fitting_scene(task, TASKS / "pick_and_place.yaml")
    plan = plan_adaptation(task)
    print(f"{'drawn':<10} {'unreachable':>11} {'refused':>8} {'in full':>8}  reasons")
    for how in ("drawn", "anywhere", "near"):
        random = np.random.default_rng(args.seed)
        setups = unreachable(how, task, scene, random)
        planner = A465Planner()
        found = [
            planner.plan(adapt(plan, scene, setup), scene, setup)
            for setup, _ in zip(setups, range(args.setups), strict=False)
        ]
        refused = [one for one in found if isinstance(one, Refusal)]
        reasons = Counter(f"{one.reason} {one.what}".strip() for one in refused).most_common()
        told = ", ".join(f"{name} {count}" for name, count in reasons)
        whole = sum(full(one) for one in refused)
        print(f"{how:<10} {len(found):>11} {len(refused):>8} {whole:>8}  {told}", flush=True)


if __name__ == "__main__":
    main()
