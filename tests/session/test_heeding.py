"""A run halts where a before- or until-condition of its primitives is not met."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from assistant.cli import main
from assistant.files.scenes import find_scene
from assistant.files.setups import read_setups
from assistant.files.tasks import write_task
from assistant.model.conditions import CONDITIONS, Condition
from assistant.model.motion import ArmReport
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Primitive, Subtask, Task
from assistant.model.transcript import SetupChoice
from assistant.ports import ArmLook
from assistant.session.heeding import Heeding
from assistant.session.loop import Session
from assistant.session.opening import open_session
from assistant.session.practice import SetupResult, practice_setup
from sim.bullet_arm import BulletArm
from sim.kinematic_arm import KinematicArm
from sim.planner import A465Planner
from sim.sensor import InHandSensor
from sim.simulated_arm import SimulatedArm
from tests.session.lessons import HEAD, Heard, opening
from tests.session.test_conditions import AROUND, CARRIED, FAR, look
from tests.session.test_practice import TABLE1, learned

GRASP, PLACE = "grasp object", "place object on target"


def told(task: Task, name: str, *, before: str = "", until: str = "") -> Task:
    """Return a task with one condition put by a teacher on a primitive."""

    def edited(node: Subtask | Primitive) -> Subtask | Primitive:
        if isinstance(node, Subtask):
            return replace(node, parts=tuple(edited(part) for part in node.parts))
        if node.name != name:
            return node
        return replace(node, before=written(before), until=written(until))

    tree = edited(task.tree)
    assert isinstance(tree, Subtask)
    return replace(task, tree=tree)


def written(text: str) -> tuple[Condition, ...]:
    if not text:
        return ()
    told, *named = text.split()
    kind = next(one for one in CONDITIONS if one == told)
    return (Condition(kind, *named),)


def setup(number: int = 1) -> tuple[Scene, Setup]:
    found = read_setups(TABLE1)[number]
    return find_scene(found.scene, TABLE1), found


def practiced(task: Task, arm: SimulatedArm | None = None) -> SetupResult:
    arm = arm or KinematicArm(sensor=InHandSensor())
    return practice_setup(task, *setup(), arm=arm, planner=A465Planner())


@pytest.mark.parametrize(
    ("name", "wanted", "words"),
    [
        (GRASP, "hand closed", "to start when the hand is closed, but the hand is open"),
        (GRASP, "held block", "but the block is not in my hand"),
        (GRASP, "docked target", "but I am not where I should be at the target"),
        (GRASP, "on block target", "but the block is not on the target"),
        (GRASP, "aligned block target", "but the block is not in line with the target"),
        (GRASP, "above block target", "but the block is not above the target"),
        (PLACE, "clear block", "but the block is not clear of my hand"),
    ],
)
def test_each_kind_unmet_before_a_step_halts_it(name: str, wanted: str, words: str) -> None:
    result = practiced(told(learned("pick_and_place"), name, before=wanted))
    assert result.status == "missed"
    assert f'Stopped: "{name}" was to start' in result.reason
    assert words in result.reason
    last = result.reports[-1]
    assert (last.kind, last.when, last.text) == ("unmet", "before", wanted.split()[0])


@pytest.mark.parametrize(
    ("name", "wanted", "when"),
    [
        (GRASP, "hand open", "before"),
        (GRASP, "docked block", "before"),
        (GRASP, "clear target", "before"),
        (GRASP, "hand closed", "until"),
        (GRASP, "held block", "until"),
        (PLACE, "docked target", "before"),
        (PLACE, "above block target", "before"),
        (PLACE, "on block target", "until"),
        (PLACE, "aligned block target", "until"),
        (PLACE, "clear block", "until"),
    ],
)
def test_conditions_that_are_met_halt_nothing(name: str, wanted: str, when: str) -> None:
    task = learned("pick_and_place")
    edited = told(task, name, **{when: wanted})
    result = practiced(edited)
    assert result.status == "done", result.reason


def test_a_step_that_did_not_end_as_told_is_not_followed_by_the_next() -> None:
    result = practiced(told(learned("pick_and_place"), "move up object", until="docked target"))
    assert result.reason.endswith(
        'Stopped: "move up object" was to end when I am in front of the target, '
        "but I am not where I should be at the target."
    )
    begun = [report.primitive_at for report in result.reports if report.kind == "primitive"]
    assert begun[-1] == 2
    assert result.reports[-1].primitive_at == 2


def test_a_step_that_ends_above_the_target_lasts_until_it_is_there() -> None:
    plain = practiced(learned("pick_and_place"))
    task = told(learned("pick_and_place"), "move up object", until="above block target")
    result = practiced(task)
    assert result.status == "done", result.reason
    begun = {told.primitive_at: k for k, told in enumerate(result.reports) if _begins(told)}
    # It is told before the hand docks, as ever, but later than a free way would have ended.
    docked = [told.object for told in result.reports if told.text == "docked"]
    assert docked == ["block", "target"]
    assert result.reports[begun[3] + 1].object == "target"
    assert [t.primitive_at for t in plain.reports if _begins(t)] == list(begun)


def test_a_step_that_cannot_end_above_the_target_halts_at_once() -> None:
    result = practiced(told(learned("pick_and_place"), GRASP, until="above block target"))
    assert result.status == "missed"
    assert "but the block is not above the target" in result.reason
    begun = [report.primitive_at for report in result.reports if _begins(report)]
    assert begun[-1] == 1


@pytest.mark.parametrize(("over", "halted"), [(True, False), (False, True)])
def test_at_the_docking_pose_it_is_there_or_the_next_step_does_not_begin(
    over: bool, halted: bool
) -> None:
    path = replace(AROUND.path, primitive_at=np.array([0, 0, 1, 2, 3, 3, 4, 4]))
    around = replace(AROUND, path=path)
    above = (Condition("above", "block", "target"),)
    expected = (*[((), ())] * 2, ((), above), *[((), ())] * 2)
    crossing = ArmReport("primitive", 1.0, 3)
    arm = Told([[crossing], [], [ArmReport("perceived", 2.0, 3, "docked", "target")], []])
    heeding = Heeding(arm, expected, around, done=2)
    assert heeding.tick() == heeding.tick() == ()
    arm.seen = look(CARRIED, 0.04, "block", CARRIED) if over else arm.seen
    told = heeding.tick()
    assert (crossing in told) != halted
    assert arm.stopped == (["unmet"] if halted else [])


class Told(KinematicArm):
    """An arm that tells what it is told to tell, tick by tick, and sees what it is shown."""

    def __init__(self, reports: list[list[ArmReport]]) -> None:
        super().__init__()
        self._reports = reports
        self.stopped: list[str] = []
        self.seen = look(FAR, 0.04, "block")

    def tick(self) -> tuple[ArmReport, ...]:
        return tuple(self._reports.pop(0))

    def look(self) -> ArmLook:
        return self.seen

    def stop(self, why: str) -> None:
        self.stopped.append(why)


def _begins(report: ArmReport) -> bool:
    return report.kind == "primitive"


def test_the_last_step_is_judged_too_and_what_was_placed_is_measured() -> None:
    result = practiced(told(learned("pick_and_place"), PLACE, until="held block"))
    assert result.status == "missed"
    assert f'"{PLACE}" was to end when the block is in the hand' in result.reason
    assert result.distance_mm is not None
    assert result.distance_mm < 1.0


def test_in_contact_a_step_is_not_begun_either() -> None:
    arm = BulletArm(sensor=InHandSensor())
    result = practiced(told(learned("pick_and_place"), GRASP, before="hand closed"), arm)
    assert (result.status, result.reports[-1].when) == ("missed", "before")
    look = arm.look()
    assert not look.moving
    assert look.held == ""
    assert look.gripper_m > 0.07


def test_a_condition_written_into_the_file_ends_practice_with_1(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "learned.yaml"
    write_task(learned("pick_and_place"), file)
    text = file.read_text("utf-8")
    step = "{primitive: grasp object, action: {hand: close, object: block}, "
    assert step in text
    file.write_text(text.replace(step, f"{step}before: [{{hand: closed}}], "), "utf-8")
    words = ["practice", str(file), "--setup", str(TABLE1), "--arm", "kinematic"]
    assert main(words) == 1
    shown = capsys.readouterr().out
    assert shown.count('"grasp object" was to start when the hand is closed') == 4
    assert "0 of 4 done" in shown


def practicing(tmp_path: Path, task: Task) -> tuple[Session, Heard]:
    """A session with a learned task, just started slowly."""
    file, heard = tmp_path / "learned.yaml", Heard()
    write_task(task, file)
    head = replace(HEAD, setup=SetupChoice(setup=setup()[1]), task=str(file))
    session = open_session(opening(tmp_path, heard), head)
    for words in ("yes", "yes", "go"):
        if not session.moving:
            session.hear(words)
    assert session.moving
    return session, heard


def test_a_lesson_halts_tells_why_and_waits(tmp_path: Path) -> None:
    edited = told(learned("pick_and_place"), GRASP, before="hand closed")
    session, heard = practicing(tmp_path, edited)
    session.rest()
    assert heard.topics[-2:] == ["announce.primitive", "stopped.unmet_before.hand"]
    assert '"grasp object" was to start when the hand is closed' in heard.lines[-1][1]
    assert session.dialogue.arm == "stopped"
    where = session.mover.look.hand.copy()
    session.pass_s(2.0)
    assert (session.mover.look.hand == where).all()
    # It is still not met: a new start moves nothing past it.
    session.hear("start")
    session.rest()
    assert heard.topics[-1] == "stopped.unmet_before.hand"
    # Now it is.
    session.hear("close the hand")
    session.rest()
    session.hear("start")
    session.rest()
    assert heard.topics.count("stopped.unmet_before.hand") == 2
    session.close()


def test_a_step_halted_half_way_is_gone_on_with(tmp_path: Path) -> None:
    """Its before-condition held when it began: the hand that has closed since is no fault."""
    session, heard = practicing(tmp_path, learned("pick_and_place"))
    while session.moving and session.mover.look.held != "block":
        session.tick()
    session.hear("stop")
    session.rest()
    session.hear("start")
    session.rest()
    assert "done.run" in heard.topics
    assert not [topic for topic in heard.topics if topic.startswith("stopped.unmet")]
    session.close()


def test_a_body_taken_out_of_the_hand_is_missed_before_it_goes_on(tmp_path: Path) -> None:
    session, heard = practicing(tmp_path, learned("pick_and_place"))
    while session.moving and (
        session.dialogue.run is None or session.dialogue.run.primitive_at < 2
    ):
        session.tick()
    session.run_until(session.mover.run_s + 0.5)
    for words in ("stop", "open the hand", "yes"):
        session.hear(words)
        session.rest()
    assert session.mover.look.held == ""
    session.hear("start")
    assert not session.moving
    session.close()
    assert heard.topics[-1] == "stopped.unmet.held_anew"
    assert "the block is not in my hand" in heard.lines[-1][1]


def test_a_body_in_the_hand_of_a_halted_run_is_known(tmp_path: Path) -> None:
    edited = told(learned("pick_and_place"), "move up object", until="docked target")
    session, heard = practicing(tmp_path, edited)
    session.rest()
    assert heard.topics[-1] == "stopped.unmet_until.docked"
    session.hear("open the hand")
    assert "mm" in heard.lines[-1][1]
    assert session.listening.asked == "did_you_mean"
    assert session.mover.look.held == "block"
    session.close()
