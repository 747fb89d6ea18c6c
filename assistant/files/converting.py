"""Turns a file of ours into another dress, by the ending of the name wanted."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from assistant.errors import BadInput
from assistant.files.arrays import write_npz
from assistant.files.demonstrations import demonstration_text
from assistant.files.graphs import behavior_tree, dot
from assistant.files.kinds import Known, Value
from assistant.files.markdown import play
from assistant.files.plain import plain_values
from assistant.files.recordings import recording_text
from assistant.files.records import record
from assistant.files.scenes import scene_text
from assistant.files.setups import setup_text
from assistant.files.tasks import task_text
from assistant.files.transcripts import transcript_text
from assistant.files.writing import write_text
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.scene import Scene
from assistant.model.task import Task
from assistant.model.transcript import Transcript
from assistant.plain_yaml import json_word

_OF_TASKS: dict[str, Callable[[Task], str]] = {".xml": behavior_tree, ".dot": dot}
ENDINGS = {
    "recording": (".csv", ".json", ".npz"),
    "task": (".yaml", ".json", ".md", ".xml", ".dot"),
    "transcript": (".yaml", ".json", ".md"),
    "demonstration": (".yaml", ".json"),
    "setup": (".yaml", ".json"),
    "scene": (".yaml", ".json"),
}


def convert(known: Known, source: Path, goal: Path) -> None:
    """Write what was read from `source` under another ending.

    Raises
    ------
    BadInput
        If that kind of file cannot have the ending; the message lists those it can.
    """
    ending = goal.suffix.lower().replace(".yml", ".yaml")
    allowed = ENDINGS[known.kind]
    if ending not in allowed:
        right = f"a name that ends in {', '.join(allowed)}"
        raise BadInput.one(str(goal), f"a {known.kind} cannot become {ending or goal.name}", right)
    if ending == ".npz" and isinstance(known.value, Recording):
        write_npz(known.value, goal)
    else:
        # A demonstration that moves must still find its recording.
        recording = os.path.relpath(source.parent / known.recording, goal.parent)
        write_text(goal, _text(known.value, ending, recording))


def _text(value: Value, ending: str, recording: str) -> str:
    if ending == ".json":
        plain = plain_values(value, recording)
        single = isinstance(plain, list) and len(plain) == 1
        return json_text(plain[0] if single else plain)
    if isinstance(value, Task) and ending in _OF_TASKS:
        return _OF_TASKS[ending](value)
    if isinstance(value, Task | Transcript) and ending == ".md":
        return record(value) if isinstance(value, Task) else play(value)
    match value:
        case Task():
            return task_text(value)
        case Scene():
            return scene_text(value)
        case Demonstration():
            return demonstration_text(value, recording)
        case Transcript():
            return transcript_text(value)
        case Recording():
            return recording_text(value)
        case _:
            return "---\n".join(setup_text(setup) for setup in value)


def json_text(value: Any) -> str:
    """Return JSON with lists of numbers on one line each."""
    return "".join(_json(value, 0)) + "\n"


def _json(value: Any, depth: int) -> Sequence[str]:
    pad, end = "  " * (depth + 1), "  " * depth
    flat = json_word(value)
    numbers = isinstance(value, list) and not any(isinstance(x, dict | list) for x in value)
    if not isinstance(value, dict | list) or not value or numbers or len(flat) + depth * 2 <= 80:
        return [flat]
    if isinstance(value, dict):
        items = [
            f"{pad}{json_word(key)}: {''.join(_json(part, depth + 1))}"
            for key, part in value.items()
        ]
        return ["{\n", ",\n".join(items), f"\n{end}}}"]
    items = [f"{pad}{''.join(_json(part, depth + 1))}" for part in value]
    return ["[\n", ",\n".join(items), f"\n{end}]"]
