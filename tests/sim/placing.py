"""A pick and place that is planned once and carried out by many tests."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from assistant.files.scenes import find_scene
from assistant.files.setups import read_setups
from assistant.files.tasks import read_task
from assistant.model.motion import ArmReport, HandPath, HandStop, JointPath
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from sim.hands import ScriptedHand
from sim.hands.shipping import BRISK
from sim.planner import A465Planner
from sim.simulated_arm import SimulatedArm

TASKS = Path(__file__).parents[2] / "tasks"
ENDS = ("finished", "halted", "unmet")
LONGEST = 3000


@cache
def lesson(number: int = 1) -> tuple[Task, Scene, Setup]:
    """The introduced pick and place, with one of Table I's setups, counted from 1."""
    task = read_task(TASKS / "pick_and_place.yaml")
    path = TASKS / "setups" / "table1.yaml"
    setup = read_setups(path)[number - 1]
    return task, find_scene(setup.scene, path), setup


@cache
def motion(number: int = 1) -> JointPath:
    """The scripted hand's own way through that setup, planned for the arm."""
    task, scene, setup = lesson(number)
    hand = ScriptedHand(task, scene, setup, seed=3, habits=BRISK)
    recording = hand.recording
    assert recording.gripper_m is not None
    closed = recording.gripper_m < 0.06
    close, open_ = (int(k) + 1 for k in np.flatnonzero(np.diff(closed.astype(int))))
    primitives = np.searchsorted(np.array(hand.cuts_s), recording.t_s, side="right")
    last = len(recording.t_s) - 1
    stops = (
        HandStop(close, "grasp", "block", "block", close - 60, close + 60),
        HandStop(open_, "release", "block", "target", open_ - 60, last - 5),
    )
    path = HandPath(recording.t_s, recording.path, recording.gripper_m, primitives, stops)
    planned = A465Planner().plan(path, scene, setup)
    assert isinstance(planned, JointPath), planned
    return planned


def begun(arm: SimulatedArm, number: int = 1) -> None:
    """Arrange everything and start the motion."""
    _, scene, setup = lesson(number)
    arm.arrange(scene, setup)
    arm.start(motion(number))


def told_until_rest(arm: SimulatedArm) -> list[ArmReport]:
    """Tick until the run is over and return all reports."""
    reports: list[ArmReport] = []
    for _ in range(LONGEST):
        reports.extend(arm.tick())
        if reports and reports[-1].kind in ENDS:
            return reports
    raise AssertionError("the run did not end")


def ticked_to(arm: SimulatedArm, text: str) -> None:
    """Tick until a perceived state of that kind is told."""
    for _ in range(LONGEST):
        if any(report.text == text for report in arm.tick()):
            return
    raise AssertionError(f"{text} was never told")
