"""The scripted hand: exact where it must be, human-like where it may, the same for a seed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from assistant.files.demonstrations import read_demonstration
from assistant.files.setups import read_setups
from assistant.geometry import angle_between, distance_between
from assistant.learning.segmentation import segment
from assistant.model.demonstration import Spoken
from sim.hands import Habits, RecordedHand, ScriptedHand
from sim.hands.shipping import ship
from tests.sim.placing import TASKS, lesson


@pytest.mark.parametrize("seed", range(4))
def test_the_hand_closes_and_opens_exactly_where_things_are(seed: int) -> None:
    task, scene, setup = lesson(2)
    shown = ScriptedHand(task, scene, setup, seed).recording
    assert shown.gripper_m is not None
    instants = np.flatnonzero(np.diff((shown.gripper_m < 0.06).astype(int))) + 1
    for instant, name in zip(instants, ("block", "target"), strict=True):
        wanted = scene.hand_pose(name, setup.places[name])
        assert float(distance_between(shown.path[instant], wanted)) < 1e-9
        assert float(angle_between(shown.path[instant], wanted)) < 1e-7


@pytest.mark.parametrize("seed", range(4))
def test_the_hand_keeps_the_speed_limit_and_makes_no_jumps(seed: int) -> None:
    task, scene, setup = lesson(3)
    shown = ScriptedHand(task, scene, setup, seed).recording
    speed = distance_between(shown.path[1:], shown.path[:-1]) / np.diff(shown.t_s)
    assert float(np.max(speed)) <= scene.hand_speed_m_s
    assert float(np.max(angle_between(shown.path[1:], shown.path[:-1]))) < 0.05


@pytest.mark.parametrize("seed", [0, 3, 7, 11, 16])
def test_what_the_hand_shows_is_cut_where_it_goes_on_to_the_next_step(seed: int) -> None:
    """A cue left out is no matter: of seed 3, only the way to the target tells the third cut."""
    task, scene, _ = lesson()
    setup = read_setups(TASKS / "setups" / "demonstration.yaml")[0]
    hand = ScriptedHand(task, scene, setup, seed)
    found = segment(hand.demonstration(), task).cuts_s
    assert found == pytest.approx(hand.cuts_s, abs=0.25)


def test_a_seed_says_it_all_and_teachers_differ() -> None:
    task, scene, setup = lesson()
    first, same, other = (ScriptedHand(task, scene, setup, seed) for seed in (1, 1, 2))
    assert np.array_equal(first.recording.path, same.recording.path)
    assert first.cues == same.cues
    assert len(first.recording.t_s) != len(other.recording.t_s)


def test_cues_follow_their_cuts_by_the_lag_of_the_teacher() -> None:
    task, scene, setup = lesson()
    habits = Habits(cue_lag_s=0.5, cue_jitter_s=0.0, cue_missing=0.0)
    hand = ScriptedHand(task, scene, setup, 5, habits=habits)
    said = [cue.at_s for cue in hand.cues if cue.say != "first step"]
    assert np.allclose(np.array(said) - hand.cuts_s, 0.5, atol=0.006)


def test_given_cues_are_said_as_given_with_the_samples() -> None:
    task, scene, setup = lesson()
    cues = (Spoken(1.0, "first step"), Spoken(3.01, "then"), Spoken(1e6, "finally"))
    said = [(s.t_s, s.said) for s in ScriptedHand(task, scene, setup, 0, cues).samples() if s.said]
    assert [words for _, words in said] == ["first step", "then", "finally"]
    assert said[1][0] == pytest.approx(3.02)


def test_half_second_sampling_keeps_the_motion() -> None:
    task, scene, setup = lesson()
    fine, coarse = (ScriptedHand(task, scene, setup, 1, rate_hz=hz).recording for hz in (50.0, 2.0))
    assert np.array_equal(fine.path[::25], coarse.path)


def test_what_ships_is_what_the_generator_makes(tmp_path: Path) -> None:
    for folder in ("setups", "scenes", "demonstrations"):
        (tmp_path / folder).mkdir()
        for file in (TASKS / folder).glob("*.yaml"):
            (tmp_path / folder / file.name).write_bytes(file.read_bytes())
    for file in TASKS.glob("*.yaml"):
        (tmp_path / file.name).write_bytes(file.read_bytes())
    ship(tmp_path)
    for file in (TASKS / "demonstrations").iterdir():
        made = tmp_path / "demonstrations" / file.name
        assert made.read_text(encoding="utf-8") == file.read_text(encoding="utf-8")


def test_a_recorded_hand_shows_its_demonstration_again() -> None:
    shown = read_demonstration(TASKS / "demonstrations" / "pick_and_place.yaml")
    samples = list(RecordedHand(shown).samples())
    assert np.array_equal([s.pose for s in samples], shown.recording.path)
    said = [s.said for s in samples if s.said]
    assert len(said) == len(shown.cues) + len(shown.key_states)
