"""Sentences of the safety section that no other test holds (design, safety)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from assistant.files.scenes import find_scene
from assistant.files.setups import read_setups
from assistant.model.feedback import Feedback
from assistant.model.motion import HandPath, JointPath, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import ArmLook
from assistant.session.loop import Session
from assistant.session.practice import practice_setup
from sim.planner import A465Planner
from tests.session.lessons import Heard, opened, until_it_moves
from tests.session.test_practice import TABLE1, learned

ROOT = Path(__file__).parents[2]


class Watched:
    """A planner that remembers what it was asked, and can be told to refuse."""

    def __init__(self) -> None:
        self.planner = A465Planner()
        self.looks: list[ArmLook | None] = []
        self.refusal: Refusal | None = None

    def plan(
        self, path: HandPath, scene: Scene, setup: Setup, look: ArmLook | None = None
    ) -> JointPath | Refusal:
        self.looks.append(look)
        return self.refusal or self.planner.plan(path, scene, setup, look)


@pytest.fixture
def moving(tmp_path: Path) -> Iterator[tuple[Session, Heard, Watched]]:
    """A session whose arm is on its way to the block."""
    heard, planner = Heard(), Watched()
    session = opened(tmp_path, heard)
    session.mover._equipment = replace(session.equipment, planner=planner)
    until_it_moves(session)
    session.run_until(3.0)
    yield session, heard, planner
    session.close()


def test_a_new_start_is_planned_from_the_measured_pose_and_checked(
    moving: tuple[Session, Heard, Watched],
) -> None:
    session, heard, planner = moving
    session.hear("stop")
    session.rest()
    here = session.mover.look
    planner.looks.clear()
    # Something is in the way by now.
    planner.refusal = Refusal("collision", "block", "post", 12.0, "mm", "clear")
    session.hear("start")
    assert not session.moving
    assert heard.topics[-1] == "refuse.collision"
    (look,) = planner.looks
    assert look is not None
    assert np.array_equal(look.q, here.q)
    assert np.array_equal(session.mover.look.q, here.q)
    planner.refusal = None
    session.hear("start")
    assert session.moving


def test_a_correction_while_it_moves_changes_nothing_before_the_next_run(
    moving: tuple[Session, Heard, Watched],
) -> None:
    session, heard, planner = moving
    planner.looks.clear()
    session.hear("lower")
    assert heard.topics[-1] == "told.next_time"
    session.rest()
    assert heard.topics[-1] == "ask.satisfied"
    assert planner.looks == []


def test_a_correction_while_it_pauses_counts_from_there_on(
    moving: tuple[Session, Heard, Watched],
) -> None:
    session, _, planner = moving
    session.hear("pause")
    session.rest()
    planner.looks.clear()
    for words in ("lower", "go on"):
        session.hear(words)
    assert session.moving
    assert [look is not None for look in planner.looks] == [True]


@pytest.mark.parametrize("allowed_m_s", [0.25, 0.4])
def test_faster_never_passes_the_hand_speed_of_the_scene(allowed_m_s: float) -> None:
    task = learned("pick_and_place")
    assert task.learned is not None
    faster = tuple(Feedback("speed", "much faster", factor=1.5) for _ in range(4))
    hurried = replace(task, learned=replace(task.learned, feedback=faster))
    for setup in read_setups(TABLE1):
        scene = replace(find_scene(setup.scene, TABLE1), hand_speed_m_s=allowed_m_s)
        result = practice_setup(hurried, scene, setup, arm=None, planner=A465Planner(), speed=3.0)
        assert result.peak_hand_speed_m_s is not None, result.reason
        assert result.peak_hand_speed_m_s <= allowed_m_s + 1e-9


def test_the_readme_says_what_voice_and_keyboard_are_not() -> None:
    said = (ROOT / "README.md").read_text("utf-8")
    for words in ("It is a simulation", "hardware emergency stop", "not a safety function"):
        assert words in said
