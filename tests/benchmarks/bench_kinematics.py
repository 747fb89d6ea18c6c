"""Inverse kinematics: ours, closed form, beside PyBullet's own iterative solver.

python -m tests.benchmarks.bench_kinematics
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from assistant.geometry import Array, angle_between, distance_between, quat_normalize
from sim import a465
from sim.kinematics import branch_of, forward, inverse, inverse_all
from sim.urdf import ARM_JOINTS, write_urdf

POSES, PEER_POSES, ROUNDS = 10_000, 500, 9


def best_us(work: Callable[[], object], count: int) -> float:
    """Return the least time of several rounds, in processor microseconds for each of `count`."""
    times = []
    for _ in range(ROUNDS):
        began = time.process_time()
        work()
        times.append(time.process_time() - began)
    return 1e6 * min(times) / count


def main() -> None:
    random = np.random.default_rng(465)
    q = random.uniform(-1.0, 1.0, (POSES, a465.JOINTS)) * a465.LIMITS
    poses, branches = forward(q), branch_of(q)
    found = inverse_all(poses)[np.arange(POSES), branches]
    error = np.abs(found - q).max(axis=1)
    singles = list(zip(poses.tolist(), branches.tolist(), strict=True))
    alone = np.array([inverse(pose, branch) for pose, branch in singles])
    print(f"{POSES} random postures within the limits")
    print(f"{'':34}{'recovered':>10}{'worst error':>13}{'us a pose':>11}")
    row("ours, all eight branches", error, best_us(lambda: inverse_all(poses), POSES))
    single_us = best_us(lambda: [inverse(pose, branch) for pose, branch in singles], POSES)
    row("ours, one pose, one branch", np.abs(alone - q).max(axis=1), single_us)
    peer(poses[:PEER_POSES])
    print("targets: 100 %, 1e-9, 2 us with all branches, 5 us for one pose")


def row(name: str, error: Array, us: float) -> None:
    print(f"{name:34}{np.mean(error <= 1e-9):10.1%}{error.max():13.1e}{us:11.2f}")


def peer(poses: Array) -> None:
    import pybullet

    client = pybullet.connect(pybullet.DIRECT)
    with tempfile.TemporaryDirectory() as folder:
        arm = pybullet.loadURDF(str(write_urdf(Path(folder))), useFixedBase=True)
    infos = [pybullet.getJointInfo(arm, k) for k in range(pybullet.getNumJoints(arm))]
    flange = next(k for k, info in enumerate(infos) if info[12] == b"flange")
    limits = {
        "lowerLimits": (-a465.LIMITS).tolist(),
        "upperLimits": a465.LIMITS.tolist(),
        "jointRanges": (2 * a465.LIMITS).tolist(),
        "restPoses": a465.READY.tolist(),
    }
    tasks = [(pose[:3].tolist(), quat_normalize(pose[3:]).tolist()) for pose in poses]
    for steps in (20, 200):

        def solve(count: int = steps) -> list[tuple[float, ...]]:
            for k, name in enumerate(ARM_JOINTS):
                assert infos[k][1].decode() == name
            return [
                pybullet.calculateInverseKinematics(
                    arm, flange, xyz, turn, maxNumIterations=count, **limits
                )
                for xyz, turn in tasks
            ]

        reached = forward(np.array(solve())[:, : a465.JOINTS])
        near = (distance_between(reached, poses) < 1e-3) & (angle_between(reached, poses) < 1e-2)
        us = best_us(solve, len(poses))
        print(f"{f'PyBullet, {steps} iterations':34}{np.mean(near):10.1%}{'':13}{us:11.1f}")
    print(f"(PyBullet counts as right within 1 mm and 0.6 deg; {len(poses)} poses)")
    pybullet.disconnect(client)


if __name__ == "__main__":
    main()
