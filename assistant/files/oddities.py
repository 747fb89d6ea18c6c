"""What can be used but looks odd: told as warnings, since the teacher may have meant it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from assistant.errors import Problem
from assistant.geometry import angle_between, distance_between
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.scene import Scene
from assistant.model.setup import Place, Setup
from assistant.model.task import Subtask, Task, walk

JUMP_M = 0.05
JUMP_RAD = 0.5
JUMP_M_S = 2.0
JUMP_RAD_S = 6.0
LONG_GAP_S = 1.0
GAP_TIMES_USUAL = 5.0
MOST_TOLD = 5
METRES_LOOK_MM = 10.0
"""A place nearer to the robot's axis than this, in mm, was most likely told in metres."""


def odd_recording(recording: Recording, file: str) -> tuple[Problem, ...]:
    """Return jumps, gaps, repeated times and a hand that is unknown or never closes."""
    found = [
        *_jumps(recording, file),
        *_gaps(recording, file),
        *_repeated(recording, file),
        *_gripper(recording, file),
    ]
    return tuple(found)


def _jumps(recording: Recording, file: str) -> list[Problem]:
    step_s = np.diff(recording.t_s)
    moved_m = distance_between(recording.path[1:], recording.path[:-1])
    turned = angle_between(recording.path[1:], recording.path[:-1])
    far = (moved_m > JUMP_M) & (moved_m > JUMP_M_S * step_s)
    wide = (turned > JUMP_RAD) & (turned > JUMP_RAD_S * step_s)
    rows = np.flatnonzero(far | wide)
    told = [
        Problem(
            file,
            f"at {recording.t_s[row + 1]:.3f} s the hand jumps {moved_m[row] * 1000:.0f} mm and "
            f"{np.rad2deg(turned[row]):.0f} degrees within {step_s[row]:.3f} s",
            "the tracking was lost? show it again if the lesson is odd",
        )
        for row in rows[:MOST_TOLD]
    ]
    return told + _more(len(rows), file, "jumps")


def _gaps(recording: Recording, file: str) -> list[Problem]:
    step_s = np.diff(recording.t_s)
    moving = step_s[step_s > 0]
    usual = float(np.median(moving)) if len(moving) else 0.0
    rows = np.flatnonzero((step_s > LONG_GAP_S) & (step_s > GAP_TIMES_USUAL * usual))
    told = [
        Problem(
            file,
            f"between {recording.t_s[row]:.3f} and {recording.t_s[row + 1]:.3f} s there "
            "are no samples",
            "what happened meanwhile is guessed",
        )
        for row in rows[:MOST_TOLD]
    ]
    return told + _more(len(rows), file, "gaps")


def _repeated(recording: Recording, file: str) -> list[Problem]:
    same = int(np.count_nonzero(np.diff(recording.t_s) == 0))
    if not same:
        return []
    many = "1 time stands" if same == 1 else f"{same} times stand"
    return [Problem(file, f"{many} there twice", "such samples are taken together")]


def _gripper(recording: Recording, file: str) -> list[Problem]:
    if recording.gripper_m is None:
        what = "there is no column gripper_m"
        return [Problem(file, what, "without it no grasp is seen, and docking poses stay unknown")]
    if np.ptp(recording.gripper_m) == 0:
        right = "without that only pushing and the like can be learned from it"
        return [Problem(file, "the hand never opens or closes", right)]
    return []


def _more(count: int, file: str, what: str) -> list[Problem]:
    return (
        [Problem(file, f"and {count - MOST_TOLD} more {what}", "see the first")]
        if count > MOST_TOLD
        else []
    )


def odd_demonstration(shown: Demonstration, file: str) -> tuple[Problem, ...]:
    """Return what is odd about a recording, and words said outside of it."""
    found = list(odd_recording(shown.recording, file))
    first, last = float(shown.recording.t_s[0]), float(shown.recording.t_s[-1])
    for spoken in (*shown.cues, *shown.key_states):
        if not first <= spoken.at_s <= last:
            told = f"{spoken.say!r} at {spoken.at_s:g} s is outside the recording"
            found.append(Problem(file, told, f"it lasts from {first:g} to {last:g} s"))
    return (*found, *odd_setup((shown.setup,), file))


def odd_setup(setups: Sequence[Setup], file: str) -> tuple[Problem, ...]:
    """Return places that look as if told in metres, and names that stand twice."""
    found: list[Problem] = []
    for setup in setups:
        places: Iterable[tuple[str, Place]] = (
            ("robot_start", setup.robot_start),
            *setup.places.items(),
        )
        for name, place in places:
            if all(abs(value) < METRES_LOOK_MM for value in place.xyz_mm):
                what = f"{setup.name}: {name} is less than {METRES_LOOK_MM:g} mm from the base"
                found.append(Problem(file, what, "xyz_mm is in millimetres (is this metres?)"))
    names = [setup.name for setup in setups]
    twice = sorted({name for name in names if names.count(name) > 1})
    return (
        *found,
        *(Problem(file, f"two setups are named {name!r}", "a name each") for name in twice),
    )


def odd_scene(scene: Scene, file: str) -> tuple[Problem, ...]:
    """Return bodies whose size looks as if told in metres."""
    return tuple(
        Problem(
            file,
            f"{name} is at most {max(body.size_mm):g} mm wide",
            "size_mm is in millimetres (is this metres?)",
        )
        for name, body in scene.bodies.items()
        if 0 < max(body.size_mm) < 1.0
    )


def odd_task(task: Task, file: str) -> tuple[Problem, ...]:
    """Return subtasks without parts, and what was learned for steps that are not in the tree."""
    found = [
        Problem(file, f"the subtask {node.name!r} has no parts", "add some, or leave it out")
        for _, node in walk(task.tree)
        if isinstance(node, Subtask) and not node.parts
    ]
    known = {node.name for _, node in walk(task.tree)}
    told = dict.fromkeys(_learned_names(task))
    right = "was it renamed by hand? rename it in the lesson too, or show the task again"
    found += [
        Problem(file, f"something was learned for {name!r}, which is not in the tree", right)
        for name in told
        if name not in known
    ]
    return tuple(found)


def _learned_names(task: Task) -> Iterator[str]:
    if task.learned is None:
        return
    yield from (each.primitive for each in task.learned.segmentation.episodes if each.primitive)
    yield from (each.primitive for each in task.learned.stations if each.primitive)
    yield from (each.primitive for each in task.learned.feedback if each.primitive)
    yield from (*task.learned.before, *task.learned.until)
