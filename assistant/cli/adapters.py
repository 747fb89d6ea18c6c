"""Picks arm, planner and hands for the verbs that move or teach."""

from __future__ import annotations

import argparse
import importlib
import os
import sys
import threading
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.errors import BadInput

if TYPE_CHECKING:
    from assistant.model.scene import Scene
    from assistant.model.setup import Setup
    from assistant.model.task import Task
    from assistant.model.transcript import Demonstrate
    from assistant.ports import Arm, Hand
    from assistant.session.equipment import Equipment

ARMS = ("pybullet", "kinematic")
LANGUAGES = {"en": "english", "de": "german", "english": "english", "german": "german"}


def arm_argument(parser: argparse.ArgumentParser, default: str | None = "pybullet") -> None:
    """Add the choice of the arm."""
    parser.add_argument(
        "--arm", choices=ARMS, default=default, help="with contact physics, or without (fast)"
    )


def make_arm(name: str, stop_flag: threading.Event | None = None, *, window: bool = False) -> Arm:
    """Return the simulated arm of that name, shown in a window on request."""
    from sim.sensor import InHandSensor

    if window:
        check_window(name)
    if name == "kinematic":
        from sim.kinematic_arm import KinematicArm

        return KinematicArm(stop_flag, sensor=InHandSensor())
    from sim.bullet_arm import BulletArm

    return BulletArm(stop_flag, sensor=InHandSensor(), window=window)


def check_window(arm: str) -> None:
    """Refuse a window for an arm that has none, and where there is no display."""
    if arm != "pybullet":
        raise BadInput.one("--window", f"the {arm} arm has none", "use --arm pybullet")
    shown = os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    if sys.platform.startswith("linux") and not shown:
        raise BadInput.one("--window", "there is no display", "leave it out, or set DISPLAY")


def make_equipment(arm: str, *, window: bool = False) -> Equipment:
    """Return arm, planner and hands of a session, the arm shown in a window on request."""
    from assistant.session.equipment import Equipment
    from sim.hands.keyed import KeyedHand
    from sim.planner import A465Planner
    from sim.setups import new_setup

    stop_flag = threading.Event()
    made = make_arm(arm, stop_flag, window=window)
    return Equipment(made, A465Planner(), make_hand, new_setup, stop_flag, KeyedHand)


def warm_up() -> None:
    """Import beside the first words what the first motion and learning need (2 s)."""

    def load() -> None:
        for name in ("scipy.interpolate", "assistant.learning.lesson"):
            importlib.import_module(name)

    threading.Thread(target=load, name="warm up", daemon=True).start()


def make_hand(step: Demonstrate, task: Task, scene: Scene, setup: Setup) -> Hand:
    """Return the hand a ``demonstrate`` step asks for."""
    from assistant.files.demonstrations import read_demonstration
    from assistant.files.recordings import read_recording
    from assistant.model.demonstration import Demonstration
    from sim.hands import RecordedHand, ScriptedHand
    from sim.hands.untold import filled

    if step.recording is None:
        # Whoever shows a task knows where its things are, told or not.
        setup = filled(task, scene, setup, step.seed)
        if step.cues is None:
            return ScriptedHand(task, scene, setup, step.seed)
        return ScriptedHand(task, scene, setup, step.seed, (*step.cues, *step.key_states))
    path = Path(step.recording)
    if path.suffix == ".csv":
        shown = Demonstration(read_recording(path), step.cues or (), step.key_states, setup)
    else:
        shown = read_demonstration(path)
    return RecordedHand(shown)
