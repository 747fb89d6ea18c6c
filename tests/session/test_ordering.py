"""What may come in any order is done in another one where the one shown is refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.cli.adapters import make_equipment
from assistant.dialogue.effects import Check, Move
from assistant.files.scenes import find_scene
from assistant.files.setups import read_setups
from assistant.language.speech import phrase
from assistant.model.motion import ArmReport, HandPath, JointPath, Refusal
from assistant.model.robot_acts import RobotAct
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Order, Task
from assistant.ports import ArmLook
from assistant.session.motion import Mover
from assistant.session.ordering import planned
from assistant.session.practice import practice_setup
from sim.bullet_arm import BulletArm
from sim.planner import A465Planner
from sim.sensor import InHandSensor
from tests.session.test_practice_of_tasks import TASKS, learned

SWAPPED = ("sort red block", "sort blue block")


def place(name: str) -> tuple[Scene, Setup]:
    path = TASKS / "setups" / "sorting.yaml"
    setup = next(one for one in read_setups(path) if one.name == name)
    return find_scene(setup.scene, path), setup


def sorting(order: Order = "any") -> Task:
    task = learned("sorting")
    return replace(task, tree=replace(task.tree, order=order))


class Fussy:
    """A planner that plans nothing which begins with the things it is told."""

    def __init__(self, *refused: str) -> None:
        self.refused = refused
        self.asked: list[str] = []

    def plan(
        self, path: HandPath, scene: Scene, setup: Setup, look: ArmLook | None = None
    ) -> JointPath | Refusal:
        first = path.stops[0].object
        self.asked.append(first)
        if first in self.refused:
            return Refusal("collision", f"grasp of {first}")
        q = np.zeros((len(path.t_s), 6))
        return JointPath(path.t_s, q, path.gripper_m, path.primitive_at, path.stops, 1.0, 0.1, 0.1)


def test_what_can_be_done_as_shown_is_done_so() -> None:
    fussy = Fussy()
    found = planned(sorting(), *place("sorting_1"), fussy, speed=1.0)
    assert fussy.asked == ["blue block"]
    assert found.order == ()
    assert isinstance(found.motion, JointPath)
    assert found.motion.note == ""


def test_another_order_is_told_with_the_motion_in_both_languages() -> None:
    fussy = Fussy("blue block")
    found = planned(sorting(), *place("sorting_1"), fussy, speed=1.0)
    assert fussy.asked == ["blue block", "red block"]
    assert found.order == SWAPPED
    assert isinstance(found.motion, JointPath)
    line = RobotAct("report", "detour", slots={"note": found.motion.note})
    assert phrase(line) == "I take another way: first sort red block, then sort blue block."
    german = phrase(line, "german")
    assert german.endswith("zuerst sort red block, dann sort blue block.")


def test_what_no_order_can_do_is_refused_as_shown() -> None:
    fussy = Fussy("blue block", "red block")
    found = planned(sorting(), *place("sorting_1"), fussy, speed=1.0)
    assert fussy.asked == ["blue block", "red block"]
    assert found.motion == Refusal("collision", "grasp of blue block")


def test_a_fixed_order_is_kept() -> None:
    fussy = Fussy("blue block")
    found = planned(sorting("sequential"), *place("sorting_1"), fussy, speed=1.0)
    assert fussy.asked == ["blue block"]
    assert isinstance(found.motion, Refusal)


@pytest.mark.parametrize(("order", "status"), [("any", "done"), ("sequential", "refused")])
def test_a_block_on_the_other_s_square_is_put_away_first(order: Order, status: str) -> None:
    scene, setup = place("sorting_taken")
    arm = BulletArm(sensor=InHandSensor())
    result = practice_setup(sorting(order), scene, setup, arm=arm, planner=A465Planner())
    assert result.status == status, result.reason
    if status == "done":
        assert result.note.startswith("first sort red block, then sort blue block")
        assert result.distance_mm is not None
        assert result.distance_mm < 0.2
        begun = [one.primitive_at for one in result.reports if one.kind == "primitive"]
        assert begun == list(range(10))
    else:
        assert "blue square" in result.reason


def test_a_run_that_was_halted_goes_on_in_the_order_it_began_in() -> None:
    scene, setup = place("sorting_taken")
    mover = Mover(make_equipment("kinematic"))
    check = Check(sorting(), setup, scene, 1.0)
    assert mover.check(check).refusal is None
    mover.move(Move(check.task, setup, 1.0, pause_before_primitives=False))
    while mover.look.held != "red block":
        mover.tick()
    mover.halt("pause")
    while mover.moving:
        mover.tick()
    anew = replace(check, anew=True)
    found = mover.check(anew)
    assert found.refusal is None
    mover.move(Move(check.task, setup, 1.0, pause_before_primitives=False, anew=True))
    told: list[ArmReport] = []
    while mover.moving:
        told += mover.tick()
    assert told[-1].kind == "finished"
    assert {(one.object, one.target) for one in told[-1].alignments} == {
        ("red block", "red square"),
        ("blue block", "blue square"),
    }
    assert max(one.distance_mm for one in told[-1].alignments) < 0.2
