"""One step shown again: only its stretch is replaced, then all is learned anew and told."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.one_step import before_step, stretch
from assistant.dialogue.state import AwaitingShow, Watching
from assistant.model import teacher_acts as acts
from assistant.model.demonstration import Demonstration, Recording
from tests.dialogue.teaching import STEPS, Lessons, demonstration, lesson

SHOW_ONE = "let me show you moving up again"


def offered(text: str = SHOW_ONE) -> Lessons:
    return Lessons().ready().hear(acts.GoBack("demonstration"), text=text)


def shown(seconds: float = 4.0, aside_m: float = 0.0) -> ev.Shown:
    """Return a showing of one step: the hand of the little lesson rests."""
    t_s = np.linspace(0.0, seconds, 21)
    pose = demonstration().recording.path[0] + np.array([0.0, aside_m, 0.0, 0.0, 0.0, 0.0, 0.0])
    return ev.Shown(Demonstration(Recording(t_s, np.tile(pose, (21, 1)), np.full(21, 0.08))))


def taken() -> Lessons:
    teacher = offered().hear(acts.Affirm()).hear(acts.Approve(), text="finished")
    return teacher.happen(shown())


def test_only_the_named_step_is_watched() -> None:
    teacher = offered()
    assert teacher.topics == ["told.one_step_again", "ask.ready_step"]
    assert teacher.lines[0].slots["from_s"] == 4.0
    assert teacher.lines[0].slots["to_s"] == 6.0
    assert teacher.dialogue.state == AwaitingShow(STEPS[2])
    assert teacher.hear(acts.Affirm()).dialogue.state == Watching(step=STEPS[2])
    assert teacher.did(fx.Record)
    # Begun anew, it is that step that is begun anew.
    assert teacher.hear(acts.Again()).dialogue.state == AwaitingShow(STEPS[2])


def test_its_stretch_is_replaced_and_all_other_cuts_are_kept() -> None:
    teacher = taken()
    (effect,) = (one for one in teacher.effects if isinstance(one, fx.Learn))
    assert len(effect.demonstrations) == 1
    # Two seconds became four: what comes later is two seconds later.
    assert effect.cuts_s == pytest.approx((2.0, 4.0, 8.0, 10.0), abs=0.2)
    assert effect.assigned == tuple(enumerate(STEPS, start=1))
    assert effect.demonstrations[0].recording.t_s[-1] == pytest.approx(12.0, abs=0.2)
    assert teacher.topics == ["done.step_shown", "report.learning"]
    learned = teacher.happen(ev.Learned(lesson()))
    assert learned.topics[0] == "read_back.episodes"


def test_of_a_step_with_parts_its_own_cuts_are_found_anew() -> None:
    # A step and a part of it are called so: the step is meant.
    whole = offered("let me show you placing the object again").hear(acts.Affirm())
    assert whole.dialogue.state == Watching(step="place object")
    whole.hear(acts.Approve()).happen(shown())
    (effect,) = (one for one in whole.effects if isinstance(one, fx.Learn))
    assert effect.cuts_s is None
    assert effect.assigned == ()


def test_what_does_not_fit_is_told_and_nothing_changes() -> None:
    teacher = offered().hear(acts.Affirm()).hear(acts.Approve())
    before = teacher.dialogue.known
    teacher.happen(shown(aside_m=0.12))
    assert teacher.topics == ["error.step_apart.begins", "ask.ready_step"]
    assert teacher.lines[0].slots["away_mm"] == pytest.approx(120.0)
    assert teacher.dialogue.known == before


def test_the_old_stretch_comes_back_by_undo_and_where_nothing_is_learned() -> None:
    old = Lessons().ready().dialogue.known.demonstrations[0].recording.t_s[-1]
    undone = taken().happen(ev.Learned(lesson())).hear(acts.Undo())
    assert undone.dialogue.known.demonstrations[0].recording.t_s[-1] == old
    failed = taken().happen(ev.Learned(None, "never_closed"))
    assert failed.dialogue.known.demonstrations[0].recording.t_s[-1] == old
    assert failed.dialogue.known.lesson is not None


def test_the_whole_can_be_shown_instead() -> None:
    teacher = offered().hear(acts.GoBack("demonstration"), text="let me show you again")
    assert teacher.dialogue.state == AwaitingShow()
    # A step that is in two pieces, or of a task that was loaded, is not shown for itself.
    known = teacher.dialogue.known
    assert stretch(known, STEPS[2]) is not None
    assert stretch(replace(known, demonstrations=()), STEPS[2]) is None
    assert stretch(known, "no such step") is None


def test_the_hand_is_brought_to_where_the_step_begins() -> None:
    known = Lessons().ready().dialogue.known
    ahead = before_step(known, STEPS[2])
    assert ahead is not None
    assert ahead[0].recording.t_s[-1] < 4.0
    assert set(ahead[1].places) == {"block", "target"}
    assert before_step(known, STEPS[0]) is None


@pytest.mark.parametrize(
    "text",
    [
        "I'd like to show you only moving up once more",
        "can I show moving up once more",
        "let me do just moving up again",
        "let me show you moving the object up another time",
    ],
)
def test_many_ways_to_ask_for_it(text: str) -> None:
    assert offered(text).dialogue.state == AwaitingShow(STEPS[2])
