from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from assistant.dialogue import events
from assistant.errors import BadInput
from assistant.files.finding import find_setups
from assistant.files.scenes import find_scene
from assistant.files.shipped import shipped
from assistant.files.tasks import read_task
from assistant.model.demonstration import Demonstration, Recording, Spoken
from assistant.model.listening import Understanding
from assistant.model.motion import GOING_ON, Alignment, ArmReport, Refusal
from assistant.model.teacher_acts import Affirm
from assistant.model.transcript import Happened, TeacherLine
from assistant.session.happenings import Store, from_happened, to_step

(SETUP,), PATH = find_setups("demonstration", Path())
SCENE = find_scene(SETUP.scene, PATH)
TASK = read_task(shipped("tasks") / "pick_and_place.yaml")

EVENTS: list[events.Event] = [
    events.Begun(SCENE, SETUP, TASK, ("stacking",)),
    events.Begun(SCENE, SETUP, TASK, ("version one",), "version one"),
    events.Begun(SCENE, SETUP),
    events.Shown(None, "too_short"),
    events.Learned(None, "never_closed", {"count": 3, "names": ["a", "b"]}),
    events.Checked(SETUP, None, 16.25, "went around the post"),
    events.Checked(SETUP, Refusal("joint_limit", "approach", "joint 5", 3.25, "deg", "closer")),
    events.Halted("Ctrl-C"),
    events.Arranged(SETUP, SCENE),
    events.Kept("pick and place"),
    events.Kept("pick and place", "exists"),
    events.Kept("pick and place", record="tasks/pick_and_place.md"),
    events.Loaded("stacking", TASK),
    events.Loaded("stacking", None, "unknown"),
    *(
        events.ArmReported(report)
        for report in (
            ArmReport("primitive", 0.02, 0),
            ArmReport("perceived", 3.5, 1, "on", "block", "target"),
            ArmReport("halted", 1.25, 2, "stop", "block", height_mm=12.5),
            ArmReport("halted", 1.25, 2, GOING_ON),
            ArmReport(
                "finished", 16.0, 4, alignments=(Alignment("block", "target", 0.021, 0.013),)
            ),
        )
    ),
]


@pytest.mark.parametrize("event", EVENTS, ids=lambda event: type(event).__name__)
def test_an_event_comes_back_as_it_was(event: events.Event, tmp_path: Path) -> None:
    step = to_step(event, Store(tmp_path))
    assert isinstance(step, Happened)
    back = from_happened(step.result, tmp_path)
    assert type(back) is type(event)
    assert back == event


def test_a_demonstration_comes_back_sample_by_sample(tmp_path: Path) -> None:
    t_s = 0.02 * np.arange(20, dtype=float)
    path = np.tile(np.array([0.4, 0.0, 0.6, 0.0, 0.0, 0.0, 1.0]), (20, 1))
    path[:, 0] += 0.01 * t_s
    shown = Demonstration(
        Recording(t_s, path, np.full(20, 0.08)), (Spoken(0.1, "then"),), (), SETUP, source="live"
    )
    step = to_step(events.Shown(shown), Store(tmp_path))
    assert isinstance(step, Happened)
    back = from_happened(step.result, tmp_path)
    assert isinstance(back, events.Shown)
    assert back.demonstration is not None
    np.testing.assert_array_equal(back.demonstration.recording.path, path)
    assert back.demonstration.cues == shown.cues
    assert back.demonstration.setup.places == SETUP.places


def test_what_was_heard_is_a_teacher_line(tmp_path: Path) -> None:
    heard = events.Heard("then", Understanding((Affirm(),), 1.0, "then"))
    assert to_step(heard, Store(tmp_path)) == TeacherLine("then")
    assert to_step(heard, Store(tmp_path), 2.5) == TeacherLine("then", at_s=2.5)
    spoken = replace(heard, by_voice=True, sure=0.6)
    assert to_step(spoken, Store(tmp_path)) == TeacherLine("then", by_voice=0.6)
    assert to_step(events.Ticked(1.0), Store(tmp_path)) is None


def test_equal_values_share_a_file(tmp_path: Path) -> None:
    store = Store(tmp_path)
    first, second = store.setup(SETUP), store.setup(SETUP)
    assert first == second
    later = Store(tmp_path)
    later.learn_names()
    assert later.setup(SETUP) == first
    assert len(list(tmp_path.iterdir())) == 1


def test_an_unknown_result_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="unknown result 'dreamt'"):
        from_happened({"dreamt": {}}, tmp_path)
