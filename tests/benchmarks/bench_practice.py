"""Table I in contact physics: the shipped demonstration and seeds of the scripted hand.

python -m tests.benchmarks.bench_practice [SEEDS] [--noise]

Prints, for each demonstration, the worst row of Table I with the in-hand sensor and without;
with ``--noise`` the block stands up to 1 mm and 1 degree from where it was told to be. Then
how many times faster than real time the arms ran (CPU time, all checks on).
"""

from __future__ import annotations

import argparse
import time
from dataclasses import replace
from pathlib import Path

from assistant.errors import AssistantError
from assistant.files.demonstrations import read_demonstration
from assistant.files.scenes import find_scene
from assistant.files.setups import read_setups
from assistant.files.tasks import read_task
from assistant.learning.lesson import learn
from assistant.model.demonstration import Demonstration
from assistant.model.task import Task
from assistant.ports import Arm
from assistant.session.practice import SetupResult, practice_setup
from sim.bullet_arm import BulletArm
from sim.hands import ScriptedHand
from sim.kinematic_arm import KinematicArm
from sim.planner import A465Planner
from sim.sensor import InHandSensor, PlaceNoise

TASKS = Path(__file__).parents[2] / "tasks"
TABLE1 = TASKS / "setups" / "table1.yaml"
SHOWN = TASKS / "setups" / "demonstration.yaml"


def learned(shown: Demonstration) -> Task:
    task = read_task(TASKS / "pick_and_place.yaml")
    scene = find_scene(shown.setup.scene, SHOWN)
    return replace(task, learned=learn([shown], task, scene=scene))


def scripted(seed: int) -> Demonstration:
    task = read_task(TASKS / "pick_and_place.yaml")
    setup = read_setups(SHOWN)[0]
    return ScriptedHand(task, find_scene(setup.scene, SHOWN), setup, seed).demonstration()


def table(task: Task, arm: Arm) -> list[SetupResult]:
    found = []
    for setup in read_setups(TABLE1):
        scene = find_scene(setup.scene, TABLE1)
        found.append(practice_setup(task, scene, setup, arm=arm, planner=A465Planner()))
    return found


def line(label: str, results: list[SetupResult]) -> str:
    missed = [f"{r.name}: {r.reason}" for r in results if r.status != "done"]
    cells = [f"{r.distance_mm:.3f}/{r.angle_deg:.3f}" for r in results if r.distance_mm is not None]
    worst = max((r.distance_mm or 0.0 for r in results), default=0.0)
    turned = max((r.angle_deg or 0.0 for r in results), default=0.0)
    return f"{label:<28} {'  '.join(cells)}  worst {worst:.3f} mm {turned:.3f} deg {missed or ''}"


def practiced(label: str, shown: Demonstration, noise: PlaceNoise | None) -> None:
    try:
        task = learned(shown)
    except AssistantError as error:
        print(f"{label:<28} not learned: {error}")
        return
    for name, sensor in (("sensor", InHandSensor()), ("no sensor", None)):
        arm = BulletArm(sensor=sensor, noise=noise)
        print(line(f"{label}, {name}", table(task, arm)), flush=True)


def pace(label: str, arm: Arm, task: Task) -> None:
    setup = read_setups(TABLE1)[0]
    scene = find_scene(setup.scene, TABLE1)
    begun = time.process_time()
    whole = practice_setup(task, scene, setup, arm=arm, planner=A465Planner())
    all_s = time.process_time() - begun
    assert whole.motion is not None
    arm.arrange(scene, setup)
    arm.start(whole.motion)
    begun = time.process_time()
    while arm.look().moving:
        arm.tick()
    run_s = time.process_time() - begun
    print(
        f"{label:<12} {whole.sim_s / run_s:8.1f} x real time, planned too {whole.sim_s / all_s:.1f}"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("seeds", nargs="?", type=int, default=20)
    parser.add_argument("--noise", action="store_true")
    args = parser.parse_args()
    shipped = read_demonstration(TASKS / "demonstrations" / "pick_and_place.yaml")
    print("Table I rows 1-4: distance mm / angle deg")
    practiced("shipped", shipped, PlaceNoise(seed=0) if args.noise else None)
    for seed in range(args.seeds):
        practiced(f"seed {seed}", scripted(seed), PlaceNoise(seed=seed) if args.noise else None)
    pace("kinematic", KinematicArm(), learned(shipped))
    pace("pybullet", BulletArm(sensor=InHandSensor()), learned(shipped))


if __name__ == "__main__":
    main()
