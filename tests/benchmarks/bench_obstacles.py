"""Random obstacles in the way: led around, or refused with a name, and never touched.

python -m tests.benchmarks.bench_obstacles [--scenes N] [--contact N] [--seed S]

One to three boxes, standing or hanging, are put where the hand would have passed, though not
where it has to grasp or let go (`sim.feasibility` still calls the setup reachable). What is then
planned is judged by PyBullet alone: at every sample of the motion the distance of every link,
and of the body in the hand, from every box (`getClosestPoints`). The first scenes are carried
out in contact, too, where any contact point on a box counts, however light.
"""

from __future__ import annotations

import argparse
import tempfile
from collections import Counter
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from assistant.files.scenes import find_scene
from assistant.geometry import Array, compose, inverse, pose_from_mm_deg, transform_points
from assistant.learning.adaptation import adapt, plan_adaptation
from assistant.model.motion import JointPath, Refusal
from assistant.model.scene import Obstacle, Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from sim import a465
from sim.bullet_arm import BulletArm
from sim.bullet_client import Client
from sim.bullet_world import BulletWorld
from sim.feasibility import reachable
from sim.kinematics import forward
from sim.planner import A465Planner
from sim.sensor import InHandSensor
from sim.setups import postures, random_setup
from sim.urdf import ARM_JOINTS, FINGER_JOINTS, write_urdf
from tests.benchmarks.bench_tasks import TASKS, learned

FAR_M = 0.05


@dataclass
class Tally:
    """What became of the scenes, and how near the motions came."""

    counts: Counter[str] = field(default_factory=Counter)
    least_mm: list[float] = field(default_factory=list)
    notes: Counter[str] = field(default_factory=Counter)
    touched: list[str] = field(default_factory=list)


def obstacles(random: np.random.Generator, motion: JointPath) -> tuple[Obstacle, ...]:
    """Return boxes around places the fingers pass on free stretches."""
    near = {k for s in motion.stops for k in range(s.docking_at - 25, s.left_at + 26)}
    free = [k for k in range(25, len(motion.t_s) - 25) if k not in near]
    found = []
    for number in range(int(random.integers(1, 4))):
        hand = forward(motion.q[int(random.choice(free))])
        x, y, z = 1000.0 * transform_points(hand, np.array([a465.TCP_M, 0.0, 0.0]))
        size = random.uniform([30.0, 30.0, 60.0], [110.0, 110.0, 260.0])
        aside = random.uniform(-50.0, 50.0, 2)
        base = 240.0 if random.uniform() < 0.7 else z + random.uniform(-60.0, 60.0)
        top = (float(size[0]), float(size[1]), float(max(size[2], z - base + 30.0)))
        turn = (0.0, 0.0, float(random.uniform(-90.0, 90.0)))
        place = (float(x + aside[0]), float(y + aside[1]), float(base))
        found.append(Obstacle(f"box {number + 1}", top, place, turn))
    return tuple(found)


def blocked(
    random: np.random.Generator, task: Task, plain: Scene, setup: Setup, motion: JointPath
) -> Scene:
    """Return the scene with boxes that leave room where the hand grasps and lets go."""
    while True:
        scene = replace(plain, obstacles=obstacles(random, motion))
        if reachable(postures(task, scene, setup), scene):
            return scene


class Judge:
    """An arm, a body and boxes in a PyBullet of its own, moved by hand from pose to pose."""

    def __init__(self, scene: Scene) -> None:
        self.client = client = Client()
        with tempfile.TemporaryDirectory() as folder:
            self.arm = client.loadURDF(str(write_urdf(Path(folder))), useFixedBase=True)
        infos = [client.getJointInfo(self.arm, k) for k in range(client.getNumJoints(self.arm))]
        number = {info[1].decode(): info[0] for info in infos}
        self.joints = [number[name] for name in (*ARM_JOINTS, *FINGER_JOINTS)]
        self.boxes = [self._box(o.size_mm, _middle(o)) for o in scene.obstacles]
        self.size_m = np.array(scene.bodies["block"].size_mm) / 1000.0
        self.block = self._box(scene.bodies["block"].size_mm, np.array([0, 0, 9.0, 0, 0, 0, 1.0]))

    def _box(self, size_mm: tuple[float, float, float], pose: Array) -> int:
        half = [edge / 2000.0 for edge in size_mm]
        shape = self.client.createCollisionShape(self.client.GEOM_BOX, halfExtents=half)
        return int(
            self.client.createMultiBody(0.0, shape, -1, pose[:3].tolist(), pose[3:].tolist())
        )

    def least_m(self, motion: JointPath, block: Array) -> float:
        """Return how near arm and carried block come to any box."""
        grasp, release = (stop.at for stop in motion.stops)
        hands = forward(motion.q)
        in_hand = compose(inverse(hands[grasp]), block)
        raised = np.array([0.0, 0.0, self.size_m[2] / 2, 0.0, 0.0, 0.0, 1.0])
        least = FAR_M
        for k in range(len(motion.t_s)):
            self._put(motion.q[k], float(motion.gripper_m[k]))
            carried = grasp <= k < release
            pose = compose(compose(hands[k], in_hand), raised)
            place = pose if carried else np.array([0, 0, 9.0, 0, 0, 0, 1.0])
            self.client.resetBasePositionAndOrientation(
                self.block, place[:3].tolist(), place[3:].tolist()
            )
            for box in self.boxes:
                for mover in (self.arm, self.block):
                    points = self.client.getClosestPoints(mover, box, FAR_M)
                    least = min([least, *(point[8] for point in points)])
        return least

    def _put(self, q: Array, gripper_m: float) -> None:
        values = [*q.tolist(), gripper_m / 2, gripper_m / 2]
        for joint, value in zip(self.joints, values, strict=True):
            self.client.resetJointState(self.arm, joint, value)


def _middle(box: Obstacle) -> Array:
    raised = np.array([0.0, 0.0, box.size_mm[2] / 2000.0, 0.0, 0.0, 0.0, 1.0])
    return compose(pose_from_mm_deg(box.xyz_mm, box.rpy_deg), raised)


def in_contact(scene: Scene, setup: Setup, motion: JointPath, number: int) -> tuple[str, str]:
    """Carry out a motion and return how it ended, and which box had a contact point."""
    arm = BulletArm(sensor=InHandSensor(seed=number))
    arm.arrange(scene, setup)
    arm.start(motion)
    world, boxes = arm.world, {box.name for box in scene.obstacles}
    assert isinstance(world, BulletWorld)
    numbers = {number: name for number, name in world._names.items() if name in boxes}
    end, touched = "", ""
    while arm.look().moving:
        for report in arm.tick():
            end = f"{report.kind} {report.text} {report.object}".strip()
        for box, name in numbers.items():
            touched = touched or (name if world._client.getContactPoints(bodyA=box) else "")
    return end, touched


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--scenes", type=int, default=100)
    parser.add_argument("--contact", type=int, default=20)
    parser.add_argument("--seed", type=int, default=7)
    args = parser.parse_args()
    task, plain = learned("pick_and_place"), find_scene("table", TASKS)
    plan, planner, tally, contact = plan_adaptation(task), A465Planner(), Tally(), Tally()
    for number in range(1, args.scenes + 1):
        random = np.random.default_rng([args.seed, number])
        setup = random_setup(task, plain, args.seed, number)
        path = adapt(plan, plain, setup)
        before = planner.plan(path, plain, setup)
        if isinstance(before, Refusal):
            tally.counts["refused without obstacles"] += 1
            continue
        scene = blocked(random, task, plain, setup, before)
        motion = planner.plan(path, scene, setup)
        if isinstance(motion, Refusal):
            named = any(box.name in str(motion) for box in scene.obstacles)
            tally.counts["refused, naming a box" if named else f"refused: {motion}"] += 1
            continue
        least = Judge(scene).least_m(motion, plain.body_pose("block", setup.places["block"]))
        tally.counts["touched" if least < 0.0 else "done"] += 1
        tally.least_mm.append(1000.0 * least)
        tally.notes["around a box" if "around box" in motion.note else "otherwise"] += 1
        if contact.counts.total() < args.contact:
            end, box = in_contact(scene, setup, motion, number)
            contact.counts[f"touched {box}" if box else end] += 1
    print(f"{args.scenes} scenes: {dict(tally.counts)}; led {dict(tally.notes)}")
    print(f"nearest to a box: {min(tally.least_mm, default=np.nan):.1f} mm")
    print(f"in contact, {contact.counts.total()} of them: {dict(contact.counts)}")


if __name__ == "__main__":
    main()
