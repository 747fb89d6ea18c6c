"""Setups, scenes, recordings and transcripts for people at a terminal."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from typing import Literal

import numpy as np
from rich.console import Console, Group, RenderableType
from rich.markup import escape
from rich.table import Table
from rich.text import Text

from assistant.files.wording import choice_words, robot_words, stage_direction, teacher_words
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.scene import Scene
from assistant.model.setup import Place, Setup
from assistant.model.task import Task
from assistant.model.transcript import RobotLine, Step, TeacherLine, Transcript
from assistant.shells import curves
from assistant.shells.trees import NO_LABELS, Labels, task_view

COLUMNS = 60
WIDEST_PIPE = 100
Value = Task | tuple[Setup, ...] | Scene | Demonstration | Transcript | Recording


def terminal() -> Console:
    """Return where to show things; colors and width follow the terminal and ``NO_COLOR``."""
    if not (sys.stdout.encoding or "").lower().startswith("utf") and hasattr(
        sys.stdout, "reconfigure"
    ):
        sys.stdout.reconfigure(errors="replace")
    # Rich takes NO_COLOR by the letter and would go on with bold and faint.
    colors: Literal["auto"] | None = None if os.environ.get("NO_COLOR") else "auto"
    console = Console(highlight=False, color_system=colors)
    if console.is_terminal:
        return console
    return Console(highlight=False, color_system=colors, width=WIDEST_PIPE)


def view(value: Value) -> RenderableType:
    """Return a value as it is shown to people."""
    match value:
        case Task():
            return task_view(value)
        case Scene():
            return scene_view(value)
        case Demonstration():
            return Group(*demonstration_views(value))
        case Recording():
            return Group(*recording_views(value, ()))
        case Transcript():
            return Group(*play(value))
        case _:
            return Group(*(setup_view(setup) for setup in value))


def setup_view(setup: Setup, labels: Labels = NO_LABELS) -> Table:
    """Return where things are."""
    scene, start = (labels.get(one, one) for one in ("scene", "robot start"))
    heads = (labels.get(one, one) for one in ("place", "told of", "x, y, z mm", "r, p, y"))
    table = _table(f"{setup.name} ({scene} {setup.scene})", *heads)
    for name, place in ((start, setup.robot_start), *setup.places.items()):
        of, *numbers = _place(place)
        table.add_row(escape(labels.get(name, name)), labels.get(of, of), *numbers)
    return table


def _place(place: Place) -> tuple[str, str, str]:
    told_of = "hand" if place.kind == "hand" else "body"
    return told_of, _numbers(place.xyz_mm), f"{_numbers(place.rpy_deg)} deg"


def _numbers(values: Sequence[float]) -> str:
    return ", ".join(f"{value:g}" for value in values)


def scene_view(scene: Scene) -> RenderableType:
    """Return what things look like."""
    bodies = _table(f"scene {scene.name}", "body", "shape", "size mm", "mass kg", "grasped at mm")
    for name, body in scene.bodies.items():
        size, grasp = _numbers(body.size_mm), _numbers(body.grasp_xyz_mm)
        bodies.add_row(escape(name), body.shape, size, f"{body.mass_kg:g}", grasp)
    for kind, boxes in (("table", scene.tables), ("obstacle", scene.obstacles)):
        for box in boxes:
            at = f"stands at {_numbers(box.xyz_mm)} mm"
            bodies.add_row(escape(box.name), kind, _numbers(box.size_mm), "", at)
    return Group(bodies, Text(f"the hand moves at most {scene.hand_speed_m_s * 1000:g} mm/s"))


def demonstration_views(shown: Demonstration) -> Iterator[RenderableType]:
    """Yield a recording with what was said, and where things were."""
    cues = tuple(cue.at_s for cue in shown.cues)
    yield from recording_views(shown.recording, cues)
    if shown.cues or shown.key_states:
        table = _table("said", "at s", "words", "kind")
        spoken = [(cue, "cue") for cue in shown.cues]
        spoken += [(state, "key state") for state in shown.key_states]
        for each, kind in sorted(spoken, key=lambda pair: pair[0].at_s):
            table.add_row(f"{each.at_s:.2f}", escape(each.say), kind)
        yield table
    yield setup_view(shown.setup)


def recording_views(recording: Recording, cues_s: Sequence[float]) -> Iterator[RenderableType]:
    """Yield length, extent and the course of speed and gripper."""
    t_s = recording.t_s
    step_s = float(np.median(np.diff(t_s)))
    low, high = recording.path[:, :3].min(axis=0), recording.path[:, :3].max(axis=0)
    extent = " x ".join(f"{side * 1000:.0f}" for side in high - low)
    yield Text(
        f"{len(t_s)} samples in {t_s[-1] - t_s[0]:.2f} s (usually every {step_s * 1000:.0f} ms), "
        f"within {extent} mm"
    )
    yield curves.Picture(lambda blocks, wide: speed_picture(recording, cues_s, blocks, wide))


def speed_picture(
    recording: Recording, cues_s: Sequence[float], blocks: str, columns: int = COLUMNS
) -> str:
    """Return the hand's speed over time with cues, and the opening of the gripper."""
    t_s = recording.t_s
    speeds = curves.speed(t_s, recording.path)
    lines = [f"speed, up to {speeds.max() * 1000:.0f} mm/s"]
    lines += curves.bars(curves.sampled(t_s, speeds, columns), blocks=blocks)
    if cues_s:
        lines.append(f"{curves.marks(cues_s, t_s, columns, '^'):<{columns}} cues")
    if recording.gripper_m is not None:
        lines += [f"gripper, up to {recording.gripper_m.max() * 1000:.0f} mm"]
        lines += curves.bars(
            curves.sampled(t_s, recording.gripper_m, columns), rows=2, blocks=blocks
        )
    return "\n".join([*lines, curves.axis(t_s, columns)])


def play(transcript: Transcript) -> Iterator[Text]:
    """Yield a transcript as a play."""
    yield Text(transcript.title, style="bold")
    if transcript.setup is not None:
        yield Text(f"setup: {choice_words(transcript.setup)}; arm: {transcript.arm}", style="dim")
    for step in transcript.steps:
        yield _line(step)


def _line(step: Step) -> Text:
    match step:
        case TeacherLine():
            return Text("teacher: ", style="bold").append(teacher_words(step), "default")
        case RobotLine():
            return Text("robot: ", style="magenta").append(robot_words(step), "default")
        case _:
            return Text(f"  ({stage_direction(step)})", style="dim")


def _table(title: str, *columns: str) -> Table:
    table = Table(title=escape(title), title_justify="left", box=None, pad_edge=False)
    for column in columns:
        table.add_column(column)
    return table
