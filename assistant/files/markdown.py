"""A task or a session as a readable record in Markdown."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from assistant.files.wording import (
    action_words,
    conditions_words,
    feedback_words,
    numbers_words,
    robot_words,
    stage_direction,
    teacher_words,
)
from assistant.geometry import pose_to_mm_deg
from assistant.model.lesson import Episode, Lesson, Station
from assistant.model.task import Subtask, Task
from assistant.model.transcript import RobotLine, TeacherLine, Transcript


def markdown(value: Task | Transcript) -> str:
    """Return the record of a task with its lesson, or a transcript as a play."""
    lines = _task(value) if isinstance(value, Task) else _play(value)
    return "\n".join([*lines, ""])


def _task(task: Task) -> Iterator[str]:
    yield f"# {_plain(task.name)}"
    if task.goal:
        yield f"\nGoal: {_plain(task.goal)}."
    if task.objects:
        told = ", ".join(f"{_plain(each.name)} ({each.role})" for each in task.objects)
        yield f"\nObjects: {told}."
    yield "\n## Steps\n"
    yield from _parts(task.tree, 0)
    if task.learned is not None:
        yield from _lesson(task.learned)


def _parts(subtask: Subtask, depth: int) -> Iterator[str]:
    for number, part in enumerate(subtask.parts, start=1):
        optional = " (optional)" if part.optional else ""
        head = f"{'   ' * depth}{number}. "
        if isinstance(part, Subtask):
            order = ", in any order" if part.order == "any" else ""
            goal = f": {_plain(part.goal)}" if part.goal else ""
            yield f"{head}**{_plain(part.name)}**{goal}{order}{optional}"
            yield from _parts(part, depth + 1)
        else:
            told = [action_words(part), conditions_words(part)]
            yield f"{head}{_plain(part.name)} ({_plain('; '.join(filter(None, told)))}){optional}"


def _lesson(lesson: Lesson) -> Iterator[str]:
    cuts = lesson.segmentation
    yield "\n## What was learned\n"
    sources = ", ".join(Path(source).name for source in lesson.sources)
    yield f"From {_plain(sources or 'a demonstration')}."
    if cuts.episodes:
        head: tuple[str, ...] = ("from s", "to s", "step", "sure", "motion")
        yield from _table(head, [_episode(each) for each in cuts.episodes])
    if lesson.stations:
        head = ("docking", "object", "seen from", "x, y, z mm", "roll, pitch, yaw deg")
        yield from _table(head, [_docking(each) for each in lesson.stations])
    if lesson.feedback:
        yield "\n## Corrections\n"
        yield from (f"* {_plain(feedback_words(each))}" for each in lesson.feedback)


def _episode(one: Episode) -> tuple[str, ...]:
    name = one.primitive or "(nobody introduced it)"
    return f"{one.from_s:.2f}", f"{one.to_s:.2f}", name, f"{one.probability:.0%}", one.character


def _docking(one: Station) -> tuple[str, ...]:
    mm, deg = pose_to_mm_deg(one.docking_in_frame)
    return one.kind, one.object, one.frame, numbers_words(mm), numbers_words(deg)


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    yield f"\n| {' | '.join(head)} |"
    yield f"|{'---|' * len(head)}"
    for row in rows:
        yield f"| {' | '.join(_plain(cell) for cell in row)} |"


def _play(transcript: Transcript) -> Iterator[str]:
    yield f"# {_plain(transcript.title)}"
    for step in transcript.steps:
        match step:
            case TeacherLine():
                yield f"\n**Teacher:** {_plain(teacher_words(step))}"
            case RobotLine():
                yield f"\n**Robot:** {_plain(robot_words(step))}"
            case _:
                yield f"\n*{_plain(stage_direction(step))}*"


def _plain(text: str) -> str:
    """Return text in which no sign means anything to Markdown."""
    return re.sub(r"([\\`*_\[\]<>|#])", r"\\\1", " ".join(text.split()))
