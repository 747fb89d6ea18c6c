"""Questions about the robot itself, and what can be said now."""

from __future__ import annotations

import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from tests.dialogue.teaching import STEPS, Lessons


@pytest.mark.parametrize("language", ["english", "german"])
@pytest.mark.parametrize(
    "teacher",
    [
        Lessons().open(),
        Lessons().introduce(),
        Lessons().confirmed(),
        Lessons().learned(),
        Lessons().ready(),
        Lessons().ready().run(),
        Lessons().agreed(),
    ],
    ids=lambda lessons: type(lessons.dialogue.state).__name__,
)
def test_at_rest_it_tells_what_it_does_and_what_comes_next(teacher: Lessons, language: str) -> None:
    for text in ("what are you doing", "what will you do next"):
        teacher.hear(acts.RepeatLine(), text=text, sure=0.3)
        told = teacher.lines[0]
        assert told.act == "explain"
        assert told.topic.split("_")[0] in ("now", "next")
        assert "_" not in phrase(told, language)
    teacher.hear(acts.RepeatLine(), text="What now?", sure=0.4)
    assert teacher.lines[0].act == "help"


def test_before_a_run_the_steps_that_follow_are_told() -> None:
    teacher = Lessons().ready().hear(acts.Explain("x"), text="what will you do next")
    assert teacher.lines[0].slots["steps"] == list(STEPS)
    assert "50 percent" in phrase(teacher.lines[0])


def test_on_the_way_and_halted_it_tells_where_it_is() -> None:
    teacher = Lessons().ready().moving().report("primitive", 1)
    teacher.hear(acts.Unknown(), text="what are you doing now?", sure=0.2)
    assert teacher.topics == ["explain.now"]
    teacher.hear(acts.Pause()).hear(acts.Unknown(), text="what are you doing now?", sure=0.2)
    assert teacher.topics == ["explain.now_still"]
    assert "step 2 of 5" in phrase(teacher.lines[0])


def test_why_it_stopped_is_told_also_after_the_run() -> None:
    teacher = Lessons().ready().run()
    assert teacher.hear(acts.Explain("why did you stop")).topics[0] == "explain.not_stopped"
    teacher = Lessons().ready().moving().hear(acts.Stop()).hear(acts.Start()).finish()
    told = teacher.hear(acts.Explain("why did you stop")).lines[0]
    assert phrase(told) == "I stopped because you said stop."


def test_an_explanation_asked_for_on_a_guess_is_given() -> None:
    text = "why does part 3 belong to move up object"
    teacher = Lessons().learned().hear(acts.Explain(text), text=text, sure=0.5)
    assert teacher.topics[0] == "explain.assignment"


def test_another_request_lets_a_guess_go() -> None:
    teacher = Lessons().ready().hear(acts.NewSetup(), text="noo setip", sure=0.5)
    assert teacher.asked == "did_you_mean"
    teacher.hear(acts.Show("setup"), text="where is everything")
    assert teacher.asked == "ready"
    assert not teacher.did(fx.Arrange)


def test_how_sure_it_is_of_one_step() -> None:
    teacher = Lessons().learned().hear(acts.Explain("how sure are you about the grasp object"))
    told = teacher.lines[0]
    assert told.topic == "sure_of"
    assert phrase(told) == (
        'That part 2, from 2.0 to 4.0 s, is "grasp object": 90 percent. '
        "That it ends there: 84 percent."
    )


def test_a_step_is_explained_by_what_the_hand_did_in_it() -> None:
    teacher = Lessons().learned().hear(acts.Explain("why is that part grasp object"))
    assert phrase(teacher.lines[0]).endswith("It is where I close the hand on the block.")


def test_who_asks_why_nothing_was_refused_is_told_so() -> None:
    teacher = Lessons().ready().run().hear(acts.Explain("why can't you reach it"))
    assert teacher.topics[0] == "explain.no_refusal"
    teacher.hear(acts.Explain("why did you take that detour"))
    assert teacher.topics[0] == "explain.no_detour"


def test_a_step_may_be_asked_about_by_what_is_done_in_it() -> None:
    teacher = Lessons().learned().hear(acts.Explain("how certain are you about the grasp"))
    assert teacher.lines[0].topic == "sure_of"
    assert teacher.lines[0].slots["name"] == "grasp object"


def test_a_step_in_which_the_hand_does_nothing_is_explained_without_it() -> None:
    teacher = Lessons().learned().hear(acts.Explain("why is that part move up object"))
    assert "It is where" not in phrase(teacher.lines[0])


@pytest.mark.parametrize(
    ("text", "topic"),
    [
        ("how does this work?", "told.guide"),
        ("I'm new here", "told.guide"),
        ("where should I stand?", "told.stand"),
        ("What is on the table?", "told.setup"),
    ],
)
def test_who_is_here_for_the_first_time_is_guided(text: str, topic: str) -> None:
    for teacher in (Lessons().open(), Lessons().confirmed(), Lessons().ready()):
        asked = teacher.asked
        teacher.hear(acts.Unknown(), text=text, sure=0.2)
        assert teacher.topics[0] == topic
        assert teacher.asked == asked
        assert not teacher.did(fx.Record)


def test_an_empty_table_is_told() -> None:
    teacher = Lessons().happen(ev.Begun(Scene(), Setup()))
    assert teacher.hear(acts.Unknown(), text="what's on the table").topics[0] == "told.empty_table"


def test_go_is_no_yes_to_a_guessed_no() -> None:
    teacher = Lessons().ready().hear(acts.Deny(), text="the block is a metre away", sure=0.5)
    assert teacher.topics == ["confirm.did_you_mean"]
    assert teacher.hear(acts.Start(), text="go").did(fx.Check)
