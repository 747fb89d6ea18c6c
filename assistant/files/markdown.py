"""A transcript as a readable play in Markdown."""

from __future__ import annotations

from collections.abc import Iterator

from assistant.files.records import plain_markdown
from assistant.files.wording import robot_words, stage_direction, teacher_words
from assistant.model.transcript import RobotLine, TeacherLine, Transcript


def play(transcript: Transcript) -> str:
    """Return a transcript as a play."""
    return "\n".join([*_lines(transcript), ""])


def _lines(transcript: Transcript) -> Iterator[str]:
    yield f"# {plain_markdown(transcript.title)}"
    for step in transcript.steps:
        match step:
            case TeacherLine():
                yield f"\n**Teacher:** {plain_markdown(teacher_words(step))}"
            case RobotLine():
                yield f"\n**Robot:** {plain_markdown(robot_words(step))}"
            case _:
                yield f"\n*{plain_markdown(stage_direction(step))}*"
