"""Writes the demonstrations that ship: ``python -m sim.hands.shipping tasks [NAME...]``.

They are what the scripted hand shows with fixed seeds and a brisk teacher's habits, so that
anyone can make them again.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from assistant.files.demonstrations import write_demonstration
from assistant.files.recordings import recording_of, recording_text
from assistant.files.scenes import read_scene
from assistant.files.setups import read_setups
from assistant.files.tasks import read_task
from assistant.geometry import quat_normalize
from assistant.model.demonstration import Recording
from assistant.model.task import Subtask
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
SHIPPED = (
    ("pick_and_place", "demonstration", 7),
    ("stacking", "stacking", 11),
    ("sorting", "sorting", 5),
    ("insertion", "insertion", 3),
    ("pushing", "pushing", 4),
    ("wiping", "wiping", 6),
    ("pouring", "pouring", 8),
)
"""Task, setup and seed of each."""
LAST_FIRST = ("sorting",)
"""Tasks whose parts of any order are shown in the opposite order of their telling."""


def ship(folder: Path, names: Sequence[str] = ()) -> None:
    """Write shipped demonstrations, all or some, into ``demonstrations`` of the tasks' folder."""
    for name, where, seed in SHIPPED:
        if names and name not in names:
            continue
        task = read_task(folder / f"{name}.yaml")
        task = replace(task, tree=last_first(task.tree)) if name in LAST_FIRST else task
        setup = read_setups(folder / "setups" / f"{where}.yaml")[0]
        scene = read_scene(folder / "scenes" / f"{setup.scene}.yaml")
        shown = ScriptedHand(task, scene, setup, seed, habits=BRISK).demonstration()
        path = folder / "demonstrations" / f"{name}.yaml"
        write_demonstration(replace(shown, recording=_rounded(shown.recording)), path)


def last_first(tree: Subtask) -> Subtask:
    """Return a tree whose parts of any order stand in the opposite order."""
    parts = tuple(last_first(part) if isinstance(part, Subtask) else part for part in tree.parts)
    return replace(tree, parts=parts[::-1] if tree.order == "any" else parts)


def _rounded(recording: Recording) -> Recording:
    # Tracked hands are known to a hundredth of a millimetre at best; files stay readable.
    openings = None if recording.gripper_m is None else np.round(recording.gripper_m, 6)
    path = np.concatenate([np.round(recording.path[:, :3], 7), recording.path[:, 3:]], axis=1)
    path[:, 3:] = np.round(quat_normalize(path[:, 3:]), 9)
    rounded = Recording(np.round(recording.t_s, 4), path, openings)
    # As it will be read, with quaternions of length 1: what ships is written as it is read.
    return recording_of(recording_text(rounded), "a demonstration")


if __name__ == "__main__":
    ship(Path(sys.argv[1] if len(sys.argv) > 1 else "tasks"), sys.argv[2:])
