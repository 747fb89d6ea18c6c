"""Any value of ours as plain values, as it would stand in its file."""

from __future__ import annotations

from typing import Any

from assistant.files.demonstrations import demonstration_values
from assistant.files.scenes import scene_values
from assistant.files.setups import setup_file_values
from assistant.files.tasks import task_values
from assistant.files.transcripts import transcript_values
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from assistant.model.transcript import Transcript


def plain_values(
    value: Task | tuple[Setup, ...] | Scene | Demonstration | Transcript | Recording,
    recording: str = "",
) -> Any:
    """Return mappings, lists, numbers and text; several setups become a list.

    Parameters
    ----------
    value : any value of ours
    recording : str
        Of a demonstration: the CSV file it names.
    """
    match value:
        case Task():
            return task_values(value)
        case Scene():
            return scene_values(value)
        case Demonstration():
            return demonstration_values(value, recording)
        case Transcript():
            return transcript_values(value)
        case Recording():
            return recording_values(value)
        case _:
            return [setup_file_values(setup) for setup in value]


def recording_values(recording: Recording) -> dict[str, Any]:
    """Return a recording as columns of numbers, named as in CSV."""
    columns: dict[str, Any] = {"t_s": recording.t_s.tolist()}
    for at, name in enumerate(("x_m", "y_m", "z_m", "qx", "qy", "qz", "qw")):
        columns[name] = recording.path[:, at].tolist()
    if recording.gripper_m is not None:
        columns["gripper_m"] = recording.gripper_m.tolist()
    return columns
