"""What was learned is gone through, changed and learned anew."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.asking import UNSURE
from assistant.dialogue.machine import public_view
from assistant.language.speech import phrase
from assistant.learning.questions import DOUBTED
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Question
from assistant.model.task import primitives
from tests.dialogue.teaching import (
    STEPS,
    Lessons,
    demonstration,
    lesson,
)


def test_a_missing_step_is_asked_and_needs_a_new_demonstration() -> None:
    facts = {"introduced": 5, "seen": 4}
    question = Question("missing_step", "move up object", "fewer_episodes", facts)
    teacher = Lessons().learned(question)
    assert teacher.asked == "missing_step"
    teacher.tell("lifting it")
    assert teacher.topics[0] == "told.needs_demonstration"
    assert teacher.asked == "ready"


def test_yes_to_optional_makes_a_step_optional() -> None:
    teacher = Lessons().learned(Question("optional", "move up object", "no_change"))
    assert teacher.asked == "optional"
    teacher.hear(acts.Affirm())
    leaves = public_view(teacher.dialogue)["task"]["primitives"]
    assert [leaf["optional"] for leaf in leaves] == [False, False, True, False, False]


def test_a_moved_cut_is_learned_anew_and_corrections_stay() -> None:
    teacher = Lessons().ready().hear(acts.Translate("up"))
    teacher.hear(acts.MoveCut("grasp object", direction="later"))
    learn = next(one for one in teacher.effects if isinstance(one, fx.Learn))
    assert learn.cuts_s == pytest.approx((2.0, 4.5, 6.0, 8.0))
    assert learn.assigned[1] == (2, "grasp object")
    teacher.happen(ev.Learned(lesson()))
    assert len(public_view(teacher.dialogue)["feedback"]) == 1


def test_renaming_reaches_into_the_lesson() -> None:
    teacher = Lessons().ready().hear(acts.Rename("move up object", "lift"))
    assert not teacher.did(fx.Learn)
    view = public_view(teacher.dialogue)
    assert "lift" in view["primitives"]
    episodes = view["lesson"]["episodes"]
    assert episodes[2]["primitive"] == "lift"


def test_removing_a_step_after_learning_learns_again() -> None:
    teacher = Lessons().ready().hear(acts.RemoveSubtask("move up object"))
    assert teacher.topics[0] == "done.removed_shown"
    assert teacher.did(fx.Learn)


def test_why_a_cut_and_why_a_step_are_answered_from_the_lesson() -> None:
    teacher = Lessons().learned()
    teacher.hear(acts.Explain("why did you cut at 4 seconds"))
    assert teacher.topics[0] == "explain.cut"
    assert teacher.lines[0].slots["signals"] == ["gripper", "voice"]
    teacher.hear(acts.Explain("why is the second part the grasp"))
    assert teacher.topics[0] == "explain.assignment"
    assert teacher.lines[0].slots["name"] == "grasp object"
    assert teacher.hear(acts.Explain("how sure are you")).topics[0] == "explain.sure"
    assert teacher.hear(acts.Explain("what did you learn")).topics[0] == "explain.learned"


def test_a_step_nobody_introduced_gets_a_name_and_its_own_part() -> None:
    facts = {"from_s": 4.0, "to_s": 6.0, "introduced": 5, "shown": 6}
    teacher = Lessons().learned(Question("missing_step", "", "never_introduced", facts))
    teacher.tell("shake it")
    assert teacher.topics[0] == "done.added"
    learn = next(one for one in teacher.effects if isinstance(one, fx.Learn))
    assert (3, "shake it") in learn.assigned
    leaves = [leaf.name for leaf in primitives(learn.task.tree)]
    assert leaves.index("shake it") == 2


def test_a_step_taken_for_part_of_another_is_cut_out_of_it() -> None:
    """The hand goes up from 6 to 8 s; a step that nobody introduced may be the end of that."""
    plain = Lessons().learned().dialogue.known.lesson
    assert plain is not None
    part = plain.segmentation.episodes[2]
    facts = {"from_s": part.from_s + 1.0, "to_s": part.to_s}
    teacher = Lessons().learned(Question("missing_step", "", "never_introduced", facts))
    teacher.tell("shake it")
    learn = next(one for one in teacher.effects if isinstance(one, fx.Learn))
    assert part.from_s + 1.0 in (learn.cuts_s or ())
    assert dict(learn.assigned)[3] == part.primitive
    assert dict(learn.assigned)[4] == "shake it"


def test_the_demonstration_can_be_seen_again() -> None:
    teacher = Lessons().learned().hear(acts.Show("trajectory"))
    assert teacher.asked == "ready"
    assert not teacher.did(fx.Replay)
    teacher.hear(acts.Affirm())
    assert teacher.did(fx.Replay)
    teacher.report("primitive", 0)
    assert teacher.topics == ["announce.primitive"]
    teacher.report("finished", 4)
    assert teacher.asked == "confirm_segmentation"


def test_what_could_not_be_learned_is_told_and_watched_again() -> None:
    teacher = Lessons().confirmed().hear(acts.Start()).hear(acts.Approve())
    teacher.happen(ev.Shown(demonstration())).happen(ev.Learned(None, "never_closed"))
    assert "the hand never closed" in phrase(teacher.lines[0])
    assert teacher.asked == "ready"


def test_who_has_said_yes_to_the_unsure_cuts_is_not_asked_about_all_of_them_again() -> None:
    question = Question("confirm_segmentation", "grasp object", "unsure_cut", {"at_s": 4.0})
    teacher = Lessons().learned(question)
    assert teacher.asked == "confirm_segmentation"
    assert teacher.hear(acts.Affirm()).asked == "ready"


@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("english", 'not sure you showed "grasp object": I took 1.0 to 2.0 s for it. Did you?'),
        ("german", "ob du „grasp object“ gezeigt hast: Ich hielt die Zeit von 1,0 bis 2,0 s dafür"),
    ],
)
def test_a_step_that_was_perhaps_not_shown_is_asked_about_with_the_part_taken_for_it(
    language: str, words: str
) -> None:
    facts = {"from_s": 1.0, "to_s": 2.0}
    question = Question("confirm_segmentation", "grasp object", DOUBTED, facts)
    teacher = Lessons().learned(question)
    assert words in phrase(teacher.lines[-1], language=language)
    assert teacher.hear(acts.Affirm()).topics == ["confirm.segmentation"]
    again = Lessons().learned(question).hear(acts.Deny())
    assert again.topics[0] == "told.needs_demonstration"
    assert again.asked == "ready"


def test_undo_after_learning_takes_back_what_the_teacher_did_and_learns_nothing_again() -> None:
    teacher = Lessons().ready()
    before = teacher.dialogue.known
    teacher.hear(acts.MoveCut(STEPS[1], direction="later"))
    teacher.happen(ev.Learned(lesson()))
    teacher.hear(acts.Undo())
    assert teacher.topics == ["done.undone", "ask.ready_slow"]
    assert teacher.dialogue.known == before
    assert not teacher.did(fx.Learn)
    assert teacher.hear(acts.Redo()).dialogue.known.cuts_s is not None


def test_none_is_no_missing_step() -> None:
    missing = Question("missing_step", STEPS[2], "never_shown", {"introduced": 5, "shown": 4})
    teacher = Lessons().learned(missing)
    assert teacher.tell("none").topics == ["confirm.segmentation"]


def test_yes_is_no_name_of_a_step_that_nobody_introduced() -> None:
    facts = {"from_s": 4.0, "to_s": 6.0, "introduced": 5, "shown": 6}
    teacher = Lessons().learned(Question("missing_step", "", "never_introduced", facts))
    teacher.hear(acts.Affirm())
    assert teacher.topics == ["told.name_it", "ask.missing_step.never_introduced"]


def _wanted(teacher: Lessons) -> fx.Learn:
    return next(one for one in teacher.effects if isinstance(one, fx.Learn))


def test_steps_merged_or_taken_out_leave_the_cuts_where_they_were() -> None:
    merging = _wanted(Lessons().ready().hear(acts.Merge(STEPS[1:3])))
    one = f"{STEPS[1]} and {STEPS[2]}"
    assert merging.cuts_s == (2.0, 4.0, 6.0, 8.0)
    assert dict(merging.assigned) == {1: STEPS[0], 2: one, 3: one, 4: STEPS[3], 5: STEPS[4]}
    removing = _wanted(Lessons().ready().hear(acts.RemoveSubtask(STEPS[2])))
    assert removing.cuts_s == (2.0, 4.0, 6.0, 8.0)
    assert 3 not in dict(removing.assigned)


def test_parts_told_by_hand_are_free_where_a_step_is_new() -> None:
    teacher = Lessons().ready().hear(acts.Assign(3, "grasp object"))
    assert dict(_wanted(teacher).assigned)[3] == "grasp object"
    teacher.happen(ev.Learned(lesson())).hear(acts.Affirm())
    teacher.hear(acts.AddSubtask("turn left", after="move up object"))
    assert _wanted(teacher).cuts_s is None
    assert _wanted(teacher).assigned == ()


def test_who_must_finish_the_plan_is_told_how_to_leave_it_as_it_was() -> None:
    teacher = Lessons().ready().hear(acts.Split("grasp object")).hear(acts.GoBack("practice"))
    assert teacher.topics[0] == "error.plan_open"
    assert teacher.hear(acts.Undo()).asked == "ready"


def test_what_is_no_step_of_its_own_belongs_to_the_step_it_leads_to() -> None:
    facts = {"from_s": 6.0, "to_s": 8.0, "introduced": 5, "shown": 5}
    question = Question("missing_step", "", "never_introduced", facts)
    teacher = Lessons().learned(question)
    known = teacher.dialogue.known
    assert known.lesson is not None
    # A part of a step that was introduced stays as it is.
    assert not Lessons(teacher.dialogue).hear(acts.Deny(), text="none").did(fx.Learn)
    found = known.lesson.segmentation
    episodes = tuple(
        replace(one, primitive=None) if number == 3 else one
        for number, one in enumerate(found.episodes)
    )
    lost = replace(known.lesson, segmentation=replace(found, episodes=episodes))
    teacher.dialogue = replace(teacher.dialogue, known=replace(known, lesson=lost))
    learn = _wanted(Lessons(teacher.dialogue).hear(acts.Deny(), text="none"))
    assert dict(learn.assigned)[4] == STEPS[4]
    assert learn.cuts_s == (2.0, 4.0, 6.0)
    assert _wanted(teacher.tell("none")) == learn


def test_what_is_taken_back_asks_what_was_asked_and_tells_the_parts() -> None:
    question = Question("optional", "move up object", "no_change")
    teacher = Lessons().learned(question)
    assert teacher.asked == "optional"
    teacher.hear(acts.MoveCut("grasp object", direction="later"))
    other = lesson()
    episodes = (replace(other.segmentation.episodes[0], to_s=1.0), *other.segmentation.episodes[1:])
    new = replace(other, segmentation=replace(other.segmentation, episodes=episodes))
    teacher.happen(ev.Learned(new)).hear(acts.Undo())
    assert teacher.topics == ["done.undone", "read_back.episodes", "confirm.optional.no_change"]
    teacher.hear(acts.Redo())
    assert teacher.topics == ["done.redone", "read_back.episodes", "confirm.segmentation"]


def test_a_no_is_not_asked_for_again_and_can_be_taken_back() -> None:
    question = Question("optional", "move up object", "no_change")
    teacher = Lessons().learned(question).hear(acts.Deny())
    assert teacher.asked == "confirm_segmentation"
    teacher.hear(acts.MoveCut("grasp object", direction="later"))
    teacher.happen(ev.Learned(lesson((question,))))
    assert teacher.asked == "confirm_segmentation"
    teacher.hear(acts.Undo()).hear(acts.Undo())
    assert teacher.asked == "optional"


def test_a_cut_before_a_part_of_no_step_is_not_told_without_a_name() -> None:
    unsure = Question("confirm_segmentation", "", UNSURE)
    teacher = Lessons().learned(unsure)
    assert teacher.lines[-1].slots["unsure"] == []


def test_a_part_given_to_a_whole_is_given_to_one_of_its_motions() -> None:
    teacher = Lessons().learned().hear(acts.Assign(3, "place object"))
    assert not teacher.did(fx.Learn)
    assert teacher.asked == "which"
    teacher.tell(STEPS[3])
    learn = next(one for one in teacher.effects if isinstance(one, fx.Learn))
    assert learn.assigned[2] == (3, STEPS[3])


@pytest.mark.parametrize(
    ("act", "text"),
    [
        (acts.Split("move object down to target"), "split move up object"),
        (acts.Split("grasp object"), "split step 1.3"),
        (acts.RemoveSubtask("move"), "remove move up object"),
    ],
)
def test_a_step_named_in_full_is_the_one_that_is_meant(act: acts.TeacherAct, text: str) -> None:
    teacher = Lessons().learned().hear(act, text=text)
    assert teacher.lines[0].slots["name"] == "move up object"


def test_splitting_what_was_shown_tells_whether_it_must_be_shown() -> None:
    assert "done.split_look" in Lessons().learned().hear(acts.Split(STEPS[0])).topics


def test_who_waited_long_is_told_that_it_is_left_out() -> None:
    quick = lesson()
    assert quick.path is not None
    long = tuple(replace(one, to_s=one.to_s + 60.0) for one in quick.segmentation.episodes[-1:])
    episodes = (*quick.segmentation.episodes[:-1], *long)
    slow = replace(quick, segmentation=replace(quick.segmentation, episodes=episodes))
    texts = []
    for learned in (quick, slow):
        teacher = Lessons().confirmed().hear(acts.Start()).hear(acts.Approve())
        teacher.happen(ev.Shown(demonstration())).happen(ev.Learned(learned))
        texts.append(phrase(teacher.lines[0]))
    assert "waited" not in texts[0]
    assert "I leave out 60 s in which nothing moved" in texts[1]
