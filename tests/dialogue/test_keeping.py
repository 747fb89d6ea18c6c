"""Saving, leaving, overwriting and comparing: nothing is lost without a question."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.task import Task
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


def test_saving_and_leaving_at_once_asks_nothing() -> None:
    teacher = Lessons().ready().hear(acts.Save("probe"), acts.Quit())
    assert teacher.did(fx.Keep)
    assert teacher.asked != "unsaved"
    assert teacher.happen(ev.Kept("probe")).did(fx.Leave)


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


def _saved() -> Lessons:
    """Return a lesson that was saved, and corrected since."""
    teacher = Lessons().ready()
    teacher.happen(ev.Kept("version one"))
    return teacher.hear(acts.Translate("up"), text="up a bit")


def test_replacing_ones_own_saved_version_asks_too() -> None:
    unchanged = Lessons().ready().happen(ev.Kept("version one")).hear(acts.Save())
    assert unchanged.did(fx.Keep)
    teacher = _saved().hear(acts.Save())
    assert teacher.topics == ["confirm.overwrite_own"]
    assert not teacher.did(fx.Keep)
    refused = Lessons(teacher.dialogue).hear(acts.Deny())
    assert refused.dialogue.unsaved
    (keep,) = teacher.hear(acts.Affirm()).effects
    assert keep == fx.Keep(teacher.dialogue.known.task, "version one", overwrite=True)


def test_leaving_asks_once_whether_the_saved_version_is_replaced() -> None:
    for act in (acts.Affirm(), acts.Save()):
        teacher = _saved().hear(acts.Quit())
        assert teacher.topics == ["ask.unsaved.again"]
        teacher.hear(act)
        assert fx.Keep(teacher.dialogue.known.task, "version one", overwrite=True) in (
            teacher.effects
        )
        assert teacher.happen(ev.Kept("version one")).did(fx.Leave)
    assert _saved().hear(acts.Quit()).hear(acts.Deny()).did(fx.Leave)
    other = _saved().hear(acts.Quit()).hear(acts.Save("two"))
    assert fx.Keep(other.dialogue.known.task, "two") in other.effects


def test_a_name_told_alone_is_the_one_to_save_under() -> None:
    teacher = _saved().hear(acts.Save()).hear(acts.Affirm(), text="version two", sure=0.4)
    assert teacher.effects == (fx.Keep(teacher.dialogue.known.task, "version two"),)
    for text in ("yes please", "do not replace it", "what is that?"):
        asked = _saved().hear(acts.Save()).hear(acts.Unknown(), text=text, sure=0.4)
        assert not asked.did(fx.Keep)


def _compared(teacher: Lessons, other: Task) -> Lessons:
    teacher.happen(ev.Kept("old")).hear(acts.Compare("old"))
    return teacher.happen(ev.Loaded("old", other))


def test_comparing_tells_each_difference() -> None:
    teacher = Lessons().ready()
    kept = teacher.dialogue.known.task
    assert _compared(teacher, kept).topics[0] == "told.comparison_same"
    teacher.hear(acts.Translate("up"), text="up a bit").hear(acts.Optional("grasp object"))
    teacher.hear(acts.Unordered(("pick up object", "place object")))
    _compared(teacher, replace(kept, goal="another"))
    told = teacher.lines[0].slots
    assert told["corrected"] == ["up a bit"]
    assert told["optional"] == ["grasp object"]
    assert told["unordered"] == ["pick and place"]
    assert told["goal"] == "another"
    said = phrase(teacher.lines[0])
    assert "up a bit" in said
    assert ";" not in said
    assert phrase(teacher.lines[0], language="german")
    back = Lessons(teacher.dialogue)
    back.hear(acts.RemoveSubtask("move up object"))
    assert _compared(back, kept).lines[0].slots["removed"] == ["move up object"]


def test_a_task_shown_anew_is_not_the_same() -> None:
    teacher = Lessons().ready()
    kept = teacher.dialogue.known.task
    assert kept.learned is not None
    assert kept.learned.path is not None
    path = replace(kept.learned.path, path=kept.learned.path.path + 0.01)
    shown = replace(kept, learned=replace(kept.learned, path=path))
    assert _compared(teacher, shown).topics[0] == "told.comparison_shown"


def test_a_kept_task_whose_motions_are_changed_must_be_shown_again() -> None:
    teacher = Lessons().open(tree_task(lesson()), saved=("pick and place",))
    assert teacher.asked == "ready"
    teacher.hear(acts.AddSubtask("turn left", after="grasp object"))
    assert teacher.topics[1:] == ["told.must_be_shown", "ask.ready_to_watch"]
    assert not teacher.did(fx.Learn)
    assert teacher.hear(acts.Undo()).topics[-1].startswith("ask.ready_")
    assert not teacher.did(fx.Learn)
    # Names, order and what may be left out need no demonstration.
    for act in (acts.Rename("grasp object", "grip"), acts.Optional("move up object")):
        assert "told.must_be_shown" not in teacher.hear(act).topics


def test_who_wants_to_leave_while_showing_is_asked_and_may_stay() -> None:
    teacher = Lessons().confirmed().hear(acts.Start()).hear(acts.Quit())
    assert teacher.asked == "unsaved"
    teacher.hear(acts.Pause())
    assert teacher.topics[0] == "told.as_it_was"
    assert not teacher.did(fx.EndRecording)
    teacher.hear(acts.Cue("next"), text="then")
    assert teacher.topics == []
    # Heard beside the showing it may be talk.
    assert teacher.hear(acts.Quit(), voice=True).topics == []
    teacher.hear(acts.Quit()).hear(acts.Deny())
    assert teacher.topics == ["told.goodbye"]


def test_what_was_never_done_to_its_end_is_saved_with_a_warning() -> None:
    teacher = Lessons().ready().hear(acts.Save("a")).happen(ev.Kept("a"))
    assert "even once" in phrase(teacher.lines[0])
    teacher = Lessons().ready().run().hear(acts.Save("a")).happen(ev.Kept("a"))
    assert "even once" not in phrase(teacher.lines[0])
    # Of a task that was loaded it is not known what it did before.
    teacher = Lessons().open(tree_task(lesson())).hear(acts.Save("a")).happen(ev.Kept("a"))
    assert "even once" not in phrase(teacher.lines[0])


def test_a_guessed_save_still_answers_the_question_before_leaving() -> None:
    teacher = Lessons().ready().hear(acts.Quit())
    teacher.hear(acts.Save(), text="save it I guess", sure=0.5)
    assert teacher.asked == "did_you_mean"
    assert teacher.hear(acts.Affirm()).did(fx.Keep)
    assert teacher.happen(ev.Kept("pick and place")).did(fx.Leave)


def test_a_guess_denied_leaves_the_question_before_it_open() -> None:
    teacher = Lessons().ready().hear(acts.Quit())
    teacher.hear(acts.Save(), text="save it I guess", sure=0.5).hear(acts.Deny())
    assert teacher.asked == "unsaved"
    assert teacher.hear(acts.Deny()).did(fx.Leave)
