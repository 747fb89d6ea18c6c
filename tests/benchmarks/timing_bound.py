"""How much longer than the shortest time our timing of joint paths takes: toppra is the bound.

Both go along the same joint path within the same joint speeds and accelerations. Ours also
keeps the demonstration's own pace, the hand's speed limit and the rests; so three durations
stand beside each other: the demonstration's pace alone, ours, and the least the joints allow.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib import import_module

import numpy as np

from assistant.geometry import Array
from assistant.learning.adaptation import adapt, plan_adaptation
from assistant.model.motion import JointPath
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from sim import a465
from sim.kinematics import forward
from sim.planner import A465Planner
from sim.timing import timed

EVERY = 4
UNBOUND_M_S = 10.0


def table(task: Task, scene: Scene, places: Sequence[Setup]) -> None:
    """Print the ratios of durations over setups whose motion can be planned."""
    plan, rows = plan_adaptation(task), []
    for setup in places:
        motion = A465Planner().plan(adapt(plan, scene, setup), scene, setup)
        if not isinstance(motion, JointPath):
            continue
        try:
            rows.append(_durations(motion))
        except ImportError as error:
            print(f"toppra needs an extra: {error}", file=sys.stderr)
            return
    found = np.array(rows)
    print(f"\nduration of {len(found)} motions of the arm over the annulus, over toppra's least")
    for name, values in zip(("as planned", "moving as fast as it may"), found.T, strict=True):
        low, middle, high = np.percentile(values, [10.0, 50.0, 90.0])
        print(f"  {name:<26}median {middle:6.2f}  (first and last decile {low:.2f}, {high:.2f})")


def _durations(motion: JointPath) -> tuple[float, float]:
    """Return the durations as planned, and hurried to the joints' limits, over toppra's."""
    moving = np.concatenate([[True], np.max(np.abs(np.diff(motion.q, axis=0)), axis=1) > 1e-5])
    q = motion.q[moving][::EVERY]
    least_s = _least(q)
    # The same path asked for much too fast: what is left is what the limits cost.
    u_s = np.linspace(0.0, 0.2 * least_s, len(q))
    hurried = timed(u_s, q, forward(q)[:, :3], UNBOUND_M_S)
    return float(motion.t_s[-1]) / least_s, float(hurried.t_s[-1]) / least_s


def _least(q: Array) -> float:
    toppra = import_module("toppra")
    algorithm, constraint = (import_module(f"toppra.{one}") for one in ("algorithm", "constraint"))

    toppra.setup_logging("ERROR")
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(q, axis=0), axis=1))])
    path = toppra.SplineInterpolator(way, q)
    limits = [
        constraint.JointVelocityConstraint(np.stack([-a465.SPEEDS, a465.SPEEDS], axis=1)),
        constraint.JointAccelerationConstraint(
            np.stack([-a465.ACCELERATIONS, a465.ACCELERATIONS], axis=1)
        ),
    ]
    grid = np.linspace(0.0, way[-1], 400)
    best = algorithm.TOPPRA(limits, path, gridpoints=grid).compute_trajectory(0.0, 0.0)
    return float(best.duration)
