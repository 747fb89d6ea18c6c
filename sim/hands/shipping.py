"""Writes the demonstrations that ship: ``python -m sim.hands.shipping tasks``.

They are what the scripted hand shows with fixed seeds and a brisk teacher's habits, so that
anyone can make them again.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from assistant.files.demonstrations import write_demonstration
from assistant.files.scenes import read_scene
from assistant.files.setups import read_setups
from assistant.files.tasks import read_task
from assistant.geometry import quat_normalize
from assistant.model.demonstration import Recording
from sim.hands.habits import Habits
from sim.hands.scripted import ScriptedHand

BRISK = Habits(
    peak_speed_m_s=0.235,
    careful_speed_m_s=0.10,
    rest_s=0.3,
    hesitation=0.0,
    gripper_s=0.4,
    retreat_m=0.06,
    cue_lag_s=0.35,
    cue_missing=0.0,
    key_states=1.0,
)
SHIPPED = (("pick_and_place", "demonstration", 7), ("stacking", "stacking", 11))
"""Task, setup and seed of each."""


def ship(folder: Path) -> None:
    """Write every shipped demonstration into ``demonstrations`` of the folder of tasks."""
    for name, where, seed in SHIPPED:
        task = read_task(folder / f"{name}.yaml")
        setup = read_setups(folder / "setups" / f"{where}.yaml")[0]
        scene = read_scene(folder / "scenes" / f"{setup.scene}.yaml")
        shown = ScriptedHand(task, scene, setup, seed, habits=BRISK).demonstration()
        path = folder / "demonstrations" / f"{name}.yaml"
        write_demonstration(replace(shown, recording=_rounded(shown.recording)), path)


def _rounded(recording: Recording) -> Recording:
    # Tracked hands are known to a hundredth of a millimetre at best; files stay readable.
    openings = None if recording.gripper_m is None else np.round(recording.gripper_m, 6)
    path = np.concatenate([np.round(recording.path[:, :3], 7), recording.path[:, 3:]], axis=1)
    path[:, 3:] = np.round(quat_normalize(path[:, 3:]), 9)
    return Recording(np.round(recording.t_s, 4), path, openings)


if __name__ == "__main__":
    ship(Path(sys.argv[1] if len(sys.argv) > 1 else "tasks"))
