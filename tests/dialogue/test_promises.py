"""What holds whatever is said and whatever happens: safety, answers, undo."""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.machine import listening, public_view
from assistant.dialogue.state import Closed, Dialogue, Opening, Thinking, Watching
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Question
from assistant.model.listening import Understanding
from assistant.model.motion import ArmReport, Refusal
from assistant.model.teacher_acts import STAGES
from tests.dialogue.teaching import (
    SCENE,
    SETUP,
    STEPS,
    Lessons,
    demonstration,
    lesson,
    moved,
    tree_task,
)

MOTION = (fx.Move, fx.GoOn, fx.Replay, fx.SetHand, fx.Jog)
STARTS: dict[str, Callable[[], Lessons]] = {
    "opening": Lessons,
    "begun": lambda: Lessons().open(saved=("pick and place", "other")),
    "introduced": lambda: Lessons().introduce(),
    "awaiting": lambda: Lessons().confirmed(),
    "watching": lambda: Lessons().confirmed().hear(acts.Start()),
    "learned": lambda: Lessons().learned(
        Question("missing_step", "move up object", "never_shown", {"introduced": 5, "shown": 4}),
        Question("missing_step", "", "never_introduced", {"from_s": 4.0, "to_s": 6.0}),
        Question("optional", "move up object", "no_change"),
        Question("order", "pick up object", "any"),
        Question("confirm_segmentation", "grasp object", "unsure_cut", {"at_s": 4.0}),
    ),
    "ready": lambda: Lessons().ready(),
    "checking": lambda: Lessons().ready().hear(acts.Start()),
    "moving": lambda: Lessons().ready().moving().report("primitive", 1),
    "paused": lambda: Lessons().ready().moving().hear(acts.Pause()),
    "stopped": lambda: Lessons().ready().moving().hear(acts.Stop()),
    "ran": lambda: Lessons().ready().run(),
    "normal": lambda: Lessons().ready().run().hear(acts.Affirm()).moving(),
    "leaving": lambda: Lessons().ready().hear(acts.Quit()),
    "taught": lambda: Lessons().open(tree_task(lesson())),
}

name = st.sampled_from([*STEPS, "pick up object", "the second one", "block", "", "lift it", "it"])
number = st.floats(-50, 50, allow_nan=False)
triple = st.tuples(number, number, number)
degree = st.sampled_from([None, "little", "much"])
where = st.none() | st.builds(acts.Where, name, st.sampled_from(["before", "during", "after"]))
moves = st.sampled_from(["left", "right", "up", "down", "forward", "backward"])
turns = moves | st.sampled_from(["clockwise", "counterclockwise"])
listed = st.lists(name, max_size=4).map(tuple)
act: st.SearchStrategy[acts.TeacherAct] = st.one_of(
    st.builds(acts.Inform, st.one_of(name, st.integers(-3, 40), listed)),
    st.sampled_from(
        [
            acts.Affirm(),
            acts.Deny(),
            acts.Approve(),
            acts.Start(),
            acts.Pause(),
            acts.Resume(),
            acts.Stop(),
            acts.Again(),
            acts.Undo(),
            acts.Redo(),
            acts.RepeatLine(),
            acts.Help(),
            acts.NewSetup(),
            acts.BeBrief(),
            acts.BeThorough(),
            acts.Unknown(),
            acts.Cue("next"),
            acts.KeyState("look"),
        ]
    ),
    st.builds(acts.GoBack, st.sampled_from(STAGES)),
    st.builds(acts.AdjustSpeed, st.sampled_from(["faster", "slower"]), degree, st.none(), where),
    st.builds(acts.AdjustSpeed, factor=st.floats(0.01, 20.0)),
    st.builds(acts.Translate, moves, degree, st.none() | st.floats(0.0, 0.3), where),
    st.builds(acts.Rotate, turns, degree, st.none() | st.floats(0.0, 180.0), where),
    st.builds(acts.Gripper, st.sampled_from(["open", "close"]), where),
    st.builds(
        acts.AdjustLast, st.sampled_from([None, "more", "less", "opposite"]), degree, st.none()
    ),
    st.builds(acts.AdjustLast, factor=st.floats(0.1, 4.0)),
    st.builds(acts.Show, st.sampled_from(["tree", "segmentation", "plan", "setup", "lessons"])),
    st.builds(acts.Show, st.sampled_from(["corrections", "conditions", "trajectory"])),
    st.builds(acts.Explain, st.sampled_from(["why", "why did you cut at 4", "how sure", "next"])),
    st.builds(acts.Rename, name, name),
    st.builds(acts.Optional, name),
    st.builds(acts.Required, name),
    st.builds(acts.Unordered, listed),
    st.builds(acts.Ordered, name, name),
    st.builds(acts.AddSubtask, name, st.none() | name, st.none() | name),
    st.builds(acts.RemoveSubtask, name),
    st.builds(acts.Merge, listed),
    st.builds(acts.Split, name),
    st.builds(acts.MoveCut, name, st.none() | number, st.sampled_from([None, "earlier", "later"])),
    st.builds(acts.Assign, st.integers(-1, 9), name),
    st.builds(acts.SetPose, name, st.none() | triple, st.none() | triple, st.none() | triple),
    st.builds(acts.Save, st.none() | name),
    st.builds(acts.Load, st.none() | name),
    st.builds(acts.Compare, st.none() | name),
    st.builds(acts.Quit),
)
heard = st.builds(
    ev.Heard,
    st.sampled_from(["", "a bit more left", "facing you", "pick up the block, then place it"]),
    st.builds(
        Understanding,
        st.lists(act, min_size=1, max_size=3).map(tuple),
        st.sampled_from([1.0, 1.0, 0.9, 0.5]),
        st.just(""),
    ),
    st.booleans(),
)
refusal = Refusal("reach", "the block", "", 12.0, "mm", "closer")
report = st.builds(
    ArmReport,
    st.sampled_from(["primitive", "perceived", "unmet", "halted", "finished"]),
    st.just(1.0),
    st.integers(-1, 6),
    st.sampled_from(["held", "on", "hand", "contact", "stop", ""]),
    st.sampled_from(["block", ""]),
)
happening = st.one_of(
    st.sampled_from(
        [
            ev.Checked(SETUP, None, 9.0),
            ev.Checked(SETUP, refusal),
            ev.Checked(moved("two", 20.0), None, 9.0, "around the post"),
            ev.Learned(lesson()),
            ev.Learned(None, "never_closed"),
            ev.Shown(demonstration()),
            ev.Shown(None, "nothing moved"),
            ev.Arranged(moved("two", 20.0), SCENE),
            ev.Halted("a key"),
            ev.Kept("pick and place"),
            ev.Kept("other", "the disk is full"),
            ev.Loaded("other", tree_task(lesson())),
            ev.Loaded("other", None, "it is gone"),
            ev.Ticked(1.0),
        ]
    ),
    st.builds(ev.ArmReported, report),
)
events = st.lists(st.one_of(heard, heard, happening), min_size=1, max_size=14)


def _keeps_promises(before: Dialogue, event: ev.Event, teacher: Lessons) -> None:
    effects = teacher.effects
    moves_now = [one for one in effects if isinstance(one, MOTION)]
    if teacher.did(fx.Move):
        assert isinstance(event, ev.Checked)
        assert event.refusal is None
        assert before.arm == "checking"
    if isinstance(event, ev.Heard):
        meant = event.understanding.acts
        if any(isinstance(one, acts.Stop) for one in meant):
            assert not moves_now
            if before.arm in ("moving", "checking", "paused") and _is_open(before):
                assert fx.Halt("stop") in effects
        if event.understanding.confidence < 0.85 or all(
            isinstance(one, acts.Unknown) for one in meant
        ):
            assert not moves_now
            assert not teacher.did(fx.Check)
    asks = [one for one in teacher.lines if one.act in ("ask", "confirm")]
    assert len(asks) <= 1 or isinstance(event, ev.Begun) or before.said


def _is_open(dialogue: Dialogue) -> bool:
    return not isinstance(dialogue.state, Opening | Closed)


@settings(max_examples=100, deadline=None, derandomize=True)
@given(st.sampled_from(sorted(STARTS)), events)
def test_nothing_that_is_said_or_happens_breaks_a_promise(start: str, told: list[ev.Event]) -> None:
    teacher = STARTS[start]()
    for event in told:
        before = teacher.dialogue
        teacher.happen(event)
        _keeps_promises(before, event, teacher)
        for line in teacher.lines:
            assert phrase(line).strip()
            assert "{" not in phrase(line)
            assert "None" not in phrase(line)
        json.dumps(public_view(teacher.dialogue))
        assert listening(teacher.dialogue).stage in STAGES


@settings(max_examples=40, deadline=None, derandomize=True)
@given(st.sampled_from(sorted(STARTS)), st.lists(heard, max_size=6))
def test_help_repeat_and_why_are_answered_in_every_state(start: str, told: list[ev.Event]) -> None:
    teacher = STARTS[start]()
    for event in told:
        teacher.happen(event)
    if not _is_open(teacher.dialogue):
        return
    state = teacher.dialogue.state
    known = teacher.dialogue.known
    assert any(line.act == "help" for line in teacher.hear(acts.Help()).lines)
    assert teacher.hear(acts.RepeatLine()).lines
    assert teacher.hear(acts.Explain("why")).lines
    assert (teacher.dialogue.state, teacher.dialogue.known) == (state, known)
    if not isinstance(state, Watching | Thinking):
        assert teacher.hear(acts.Undo()).effects
        assert teacher.hear(acts.Redo()).effects
        assert teacher.hear(acts.Pause()).effects
        assert teacher.hear(acts.Stop()).effects
    if not isinstance(state, Watching):
        assert teacher.hear(acts.GoBack("introduction")).effects


@settings(max_examples=80, deadline=None, derandomize=True)
@given(st.sampled_from(["introduced", "ready", "ran", "taught", "begun"]), act)
def test_undo_is_the_inverse_of_a_change_and_redo_brings_it_back(
    start: str, change: acts.TeacherAct
) -> None:
    teacher = STARTS[start]()
    before = teacher.dialogue
    teacher.hear(change, text="change it")
    after = teacher.dialogue
    if len(after.past) != len(before.past) + 1 or isinstance(after.state, Thinking | Closed):
        return
    assert teacher.hear(acts.Undo()).dialogue.known == before.known
    assert teacher.hear(acts.Redo()).dialogue.known == after.known


@pytest.mark.parametrize("start", sorted(STARTS))
def test_stop_is_heard_even_when_in_doubt(start: str) -> None:
    teacher = STARTS[start]()
    moving = teacher.dialogue.arm in ("moving", "checking", "paused")
    teacher.hear(acts.Stop(), sure=0.3, text="stob")
    assert teacher.did(fx.Halt) or not moving


@pytest.mark.parametrize("start", ["moving", "normal", "checking", "paused"])
def test_after_a_stop_nothing_moves_before_a_new_start(start: str) -> None:
    teacher = STARTS[start]().hear(acts.Stop())
    for quiet in (
        acts.Affirm(),
        acts.Resume(),
        acts.Translate("up"),
        acts.Unknown(),
        acts.Help(),
        acts.AdjustLast("more"),
        acts.Undo(),
        acts.Deny(),
    ):
        teacher.hear(quiet)
        assert not any(isinstance(one, MOTION) for one in teacher.effects)
    late = ev.Checked(teacher.dialogue.known.setup, None, 9.0)
    assert not teacher.happen(late).did(fx.Move)
    teacher.hear(acts.Start())
    assert teacher.did(fx.GoOn) or teacher.did(fx.Check)
