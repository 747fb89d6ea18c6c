"""Several matters told in one sentence."""

from __future__ import annotations

import pytest

from assistant.language.matters import Told, told_matters


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "the task is called tidy up, the goal is that all is put away, and you need the box",
            [("task_name", "tidy up"), ("goal", "all is put away"), ("objects", "the box")],
        ),
        (
            "stacking, first take the cube, then put it down; you need the cube",
            [
                ("", "stacking"),
                ("steps", "take the cube, then put it down"),
                ("objects", "the cube"),
            ],
        ),
        (
            "So, you need the two blocks. In the end they stand on each other!",
            [("objects", "the two blocks"), ("goal", "they stand on each other")],
        ),
        ("it stands there at last", [("", "it stands there at last")]),
        ("the two steps of the ladder", [("", "the two steps of the ladder")]),
    ],
)
def test_each_matter_has_the_topic_that_opens_it(text: str, told: list[tuple[str, str]]) -> None:
    assert [(one.topic, one.text) for one in told_matters(text)] == told


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("it has three steps: grab it, lift it", Told("count", "grab it, lift it", 3, True)),
        ("in 4 small steps, namely a, b", Told("count", "a, b", 4, True)),
        ("two parts, open it and close it", Told("count", "open it and close it", 2)),
        ("well, there are about 5 steps", Told("count", "", 5)),
    ],
)
def test_a_number_of_steps_keeps_what_follows(text: str, told: Told) -> None:
    assert told_matters(text)[-1] == told


def test_german_matters() -> None:
    text = "sie heißt Umsetzen, das Ziel ist, dass alles steht, und man braucht den Block"
    assert [(one.topic, one.text) for one in told_matters(text, "german")] == [
        ("task_name", "Umsetzen"),
        ("goal", "alles steht"),
        ("objects", "den Block"),
    ]
    counted = told_matters("es hat zwei Schritte: Block holen, Block ablegen", "german")
    assert counted == (Told("count", "Block holen, Block ablegen", 2, True),)
