"""How well a path carried to a setup keeps what was shown: errors, jerk, speed, duration."""

from __future__ import annotations

import numpy as np

from assistant.errors import WorkFailed
from assistant.geometry import angle_between, compose, distance_between, relative
from assistant.learning.adaptation import AdaptationPlan, adapted_path, frames_in
from assistant.learning.timing import hand_speeds, rms_jerk
from assistant.model.motion import HandPath
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task


def measured(
    task: Task, plan: AdaptationPlan, path: HandPath, scene: Scene, setup: Setup
) -> dict[str, float]:
    """Return the measures of `adapt` (contract) of a path made for a setup.

    Errors: the greatest over all grasps (releases), against the demonstration with the
    teacher's corrections. Jerk: at the demonstration's own timing, against the smoothed
    demonstration's; a lesson that does not tell it is measured against its learned path. Where
    the hand only turns, both are as shown.
    """
    if task.learned is None or task.learned.path is None:
        raise WorkFailed(f"{task.name!r} has not been learned yet; demonstrate it first")
    shown = task.learned.path
    frames = frames_in(plan, scene, setup)
    errors = {
        "grasp_error_m": 0.0,
        "grasp_error_rad": 0.0,
        "release_error_m": 0.0,
        "release_error_rad": 0.0,
    }
    for frame, moved, one in zip(frames, plan.station_moves, plan.stations, strict=True):
        seen = relative(frame, path.path[one.at])
        right = compose(moved, one.hand_in_frame)
        kind = "grasp" if one.kind == "grasp" else "release"
        away, turn = float(distance_between(seen, right)), float(angle_between(seen, right))
        errors[f"{kind}_error_m"] = max(errors[f"{kind}_error_m"], away)
        errors[f"{kind}_error_rad"] = max(errors[f"{kind}_error_rad"], turn)
    step_s = float(shown.t_s[1] - shown.t_s[0])
    jerk = task.learned.jerk_m_s3 or rms_jerk(shown.path[:, :3], step_s)
    even = adapted_path(plan, frames, path.path[0])
    speeds = hand_speeds(path.t_s, path.path), hand_speeds(shown.t_s, shown.path)
    return {
        **errors,
        "jerk_ratio": _ratio(rms_jerk(even[:, :3], step_s), jerk),
        "peak_speed_ratio": _ratio(float(np.max(speeds[0])), float(np.max(speeds[1]))),
        "duration_ratio": float(path.t_s[-1] / (shown.t_s[-1] - shown.t_s[0])),
    }


def _ratio(value: float, shown: float) -> float:
    return value / shown if shown > 0.0 else 1.0
