"""Saving, leaving, overwriting and comparing: nothing is lost without a question."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import (
    SCENE,
    Lessons,
    lesson,
    moved,
    tree_task,
)


def test_leaving_with_unsaved_work_asks() -> None:
    teacher = Lessons().ready().hear(acts.Quit())
    assert teacher.asked == "unsaved"
    teacher.hear(acts.Affirm())
    assert teacher.did(fx.Keep)
    assert teacher.happen(ev.Kept("pick and place")).did(fx.Leave)
    refused = Lessons().ready().hear(acts.Quit()).hear(acts.Deny())
    assert refused.did(fx.Leave)


def test_overwriting_asks() -> None:
    teacher = Lessons()
    teacher.ready()
    teacher.dialogue = Lessons(teacher.dialogue).happen(ev.Kept("pick and place")).dialogue
    other = Lessons().open(tree_task(lesson()), saved=("stacking",))
    other.hear(acts.Save("stacking"))
    assert other.asked == "unsaved"
    assert not other.did(fx.Keep)
    keep = next(one for one in other.hear(acts.Affirm()).effects if isinstance(one, fx.Keep))
    assert keep.overwrite


def test_comparing_tells_what_differs() -> None:
    teacher = Lessons().open(tree_task(lesson()), saved=("old",)).hear(acts.Compare("old"))
    assert fx.Load("old") in teacher.effects
    teacher.hear(acts.Undo())
    known = teacher.dialogue.known
    teacher.happen(ev.Loaded("old", tree_task(lesson())))
    assert teacher.topics[0] in ("told.comparison", "told.comparison_same")
    assert teacher.dialogue.known == known


def test_agreeing_on_a_name_that_is_taken_asks_before_it_is_replaced() -> None:
    teacher = Lessons().open(tree_task(lesson()), saved=("pick and place", "other"))
    teacher.dialogue = replace(teacher.dialogue, saved_as="", pace="normal")
    for setup in (moved("two", 30.0), moved("three", 40.0)):
        teacher.happen(ev.Arranged(setup, SCENE))
        teacher.happen(ev.Checked(setup, None)).run()
    teacher.hear(acts.Affirm())
    assert teacher.topics[0] == "done.agreed"
    assert teacher.asked == "unsaved"
    assert not teacher.did(fx.Keep)
    assert fx.Keep(teacher.dialogue.known.task, "mine") in teacher.hear(acts.Save("mine")).effects


def test_a_name_to_save_under_is_taken_whole() -> None:
    teacher = Lessons().ready().hear(acts.Save(), text="save it as version one")
    assert teacher.effects == (fx.Keep(teacher.dialogue.known.task, "version one"),)


def test_comparing_without_a_name_takes_the_tasks_own_kept_version_or_asks() -> None:
    teacher = Lessons().ready()
    for name in ("one", "two"):
        teacher.happen(ev.Kept(name))
    assert teacher.hear(acts.Compare(), text="compare").effects == (fx.Load("two"),)
    assert teacher.hear(acts.Load(), text="load").topics[0] == "error.which_task"
    told = teacher.hear(acts.Compare(), text="compare it with version nine").lines[0]
    assert (told.topic, told.slots["name"]) == ("no_such_task", "version nine")


def test_a_task_is_written_down_for_people_when_that_is_asked_for() -> None:
    teacher = Lessons().ready().hear(acts.Unknown(), text="please write the lesson down for me")
    assert teacher.effects == (fx.WriteDown(teacher.dialogue.known.task, "pick and place"),)
    teacher.happen(ev.Kept("pick and place", record="/home/x/pick_and_place.md"))
    assert "/home/x/pick_and_place.md" in phrase(teacher.lines[0])
    assert teacher.happen(ev.Kept("x", "no room", record="")).topics[0] == "error.not_written"


def test_a_step_may_be_called_writing_down() -> None:
    teacher = Lessons().open().tell("note").tell("it is written").tell(("block", "target")).tell(2)
    assert not teacher.hear(acts.Inform("write it down"), text="write it down").did(fx.WriteDown)
