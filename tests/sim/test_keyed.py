"""Keys drive the arm live; every stretch is checked."""

from __future__ import annotations

import numpy as np
import pytest

from sim.hands import KeyedHand
from sim.kinematic_arm import KinematicArm
from sim.planner import A465Planner
from tests.sim.placing import lesson


@pytest.fixture
def hand() -> KeyedHand:
    _, scene, setup = lesson()
    arm = KinematicArm()
    arm.arrange(scene, setup)
    return KeyedHand(arm, A465Planner(), scene, setup)


def held(hand: KeyedHand, key: str, ticks: int) -> list[np.ndarray]:
    poses = []
    for _ in range(ticks):
        hand.press(key)
        poses.append(hand.tick().pose)
    return poses


def test_a_held_key_moves_the_hand_its_way_and_letting_go_stops_it(hand: KeyedHand) -> None:
    poses = held(hand, "w", 45)
    assert poses[-1][0] > poses[0][0] + 0.02
    assert np.max(np.abs(poses[-1][1:3] - poses[0][1:3])) < 1e-4
    hand.release("w")
    for _ in range(13):
        hand.tick()
    rest = hand.tick().pose
    assert np.array_equal(hand.tick().pose, rest)


def test_samples_are_evenly_spaced(hand: KeyedHand) -> None:
    hand.press("w")
    times = [hand.tick().t_s for _ in range(20)]
    assert np.allclose(np.diff(times), 0.02)


def test_the_clutch_takes_the_keys_off_the_arm(hand: KeyedHand) -> None:
    hand.press(" ")
    assert hand.state.clutched
    poses = held(hand, "f", 5)
    assert np.array_equal(poses[0], poses[-1])


def test_the_gripper_closes_and_opens_and_is_recorded(hand: KeyedHand) -> None:
    hand.press("c")
    openings = [hand.tick().gripper_m for _ in range(80)]
    assert openings[-1] == 0.0
    hand.press("o")
    assert [hand.tick().gripper_m for _ in range(80)][-1] == pytest.approx(0.08)


def test_a_blocked_way_is_not_gone_and_is_named(hand: KeyedHand) -> None:
    for _ in range(8):
        hand.press("+")
    for _ in range(400):
        hand.press("f")
        pose = hand.tick().pose
        if hand.state.blocked:
            break
    assert "joint 3" in hand.state.blocked
    assert np.array_equal(hand.tick().pose, pose)


def test_words_go_with_the_next_sample_and_finish_ends_it(hand: KeyedHand) -> None:
    hand.say("then")
    assert hand.tick().said == "then"
    samples = hand.samples()
    next(samples)
    hand.finish()
    assert next(samples, None) is None
    assert not hand.press("?")


def test_a_tap_is_a_whole_step(hand: KeyedHand) -> None:
    before = hand.tick().pose
    for count in (1, 2, 3):
        hand.press("w")
        for _ in range(30):
            pose = hand.tick().pose
        assert pose[0] - before[0] == pytest.approx(count * 0.005, abs=5e-4)


def test_a_tap_is_broken_off_by_release(hand: KeyedHand) -> None:
    before = hand.tick().pose
    hand.press("w")
    for _ in range(3):
        hand.tick()
    hand.release()
    for _ in range(30):
        pose = hand.tick().pose
    assert pose[0] - before[0] < 0.004
