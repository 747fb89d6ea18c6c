"""The goal can be told anew in plain words, whatever is asked."""

from __future__ import annotations

import pytest

from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import Lessons


@pytest.mark.parametrize(
    "text",
    [
        "no, that's silly. when its done the jar stands on the coaster",
        "the jar stands on the coaster when it's done",
        "no, the goal is that the jar stands on the coaster",
    ],
)
def test_the_goal_is_told_anew_where_the_plan_is_confirmed(text: str) -> None:
    teacher = Lessons().introduce().hear(acts.Deny(), text=text)
    assert teacher.dialogue.known.goal == "the jar stands on the coaster"
    assert teacher.asked == "confirm_tree"
    before = teacher.hear(acts.Undo()).dialogue.known.goal
    assert before != "the jar stands on the coaster"


def test_a_wrong_goal_is_asked_for_again() -> None:
    teacher = Lessons().introduce().hear(acts.Deny(), text="the goal is wrong")
    assert teacher.asked == "goal"
    teacher.tell("the jar is full")
    assert teacher.asked == "confirm_tree"


def test_after_the_introduction_the_goal_must_be_named() -> None:
    teacher = Lessons().ready()
    goal = teacher.dialogue.known.goal
    teacher.hear(acts.Unknown(), text="when it is done, the lamp is on")
    assert teacher.dialogue.known.goal == goal
    teacher.hear(acts.Unknown(), text="the goal is that all is tidy")
    assert teacher.dialogue.known.goal == "all is tidy"
    assert teacher.asked == "ready"
    teacher.hear(acts.Unknown(), text="the goal is at 588, -250, 403")
    assert teacher.dialogue.known.goal == "all is tidy"
