"""A step is split into parts that one sentence names, in either language."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue.sketch import at
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import Lessons


@pytest.mark.parametrize(
    ("language", "text", "parts"),
    [
        (
            "english",
            "split move up object into raise it and hold it up",
            ["raise it", "hold it up"],
        ),
        (
            "english",
            "please divide move up object into lift it, then hold it",
            ["lift it", "hold it"],
        ),
        ("german", "teile move up object in hebe es und halte es", ["hebe es", "halte es"]),
        ("english", "split move up object into lift and travel", ["lift", "travel"]),
        ("german", "teile move up object in heben und halten auf", ["heben", "halten"]),
    ],
)
def test_the_parts_are_the_ones_that_were_named(language: str, text: str, parts: list[str]) -> None:
    teacher = Lessons().introduce()
    known = replace(teacher.dialogue.known, language=language)
    teacher.dialogue = replace(teacher.dialogue, known=known)
    teacher.hear(acts.Split("move up object"), text=text)
    node = at(teacher.dialogue.known.root, (1, 3))
    assert [part.name for part in node.parts] == parts


def test_into_two_parts_names_none() -> None:
    teacher = Lessons().introduce()
    teacher.hear(acts.Split("move up object"), text="split move up object into two parts")
    assert teacher.asked == "subtask_name"
