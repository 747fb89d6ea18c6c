"""Keys drive the arm live; every stretch is checked."""

from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import compose, quat_to_rotvec, rotate_vector
from assistant.model.motion import Refusal
from sim import a465
from sim.hands import KeyedHand
from sim.kinematic_arm import KinematicArm
from sim.kinematics import forward, limit_margin
from sim.planner import A465Planner
from tests.sim.keying import settled
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
    poses = held(hand, "w", 30)
    assert poses[-1][0] > poses[0][0] + 0.04
    assert np.max(np.abs(poses[-1][1:3] - poses[0][1:3])) < 1e-4
    hand.release()
    for _ in range(15):
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


def test_a_blocked_way_is_gone_as_far_as_it_is_free_and_named(hand: KeyedHand) -> None:
    for _ in range(400):
        hand.press("f")
        hand.tick()
        if hand.state.blocked:
            break
    assert isinstance(hand.state.blocked, Refusal)
    assert (hand.state.blocked.reason, hand.state.blocked.what) == ("collision", "table")
    assert hand.state.touching == "arm"
    for _ in range(30):
        pose = hand.tick().pose
    assert pose[2] < 0.32
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


@pytest.mark.parametrize("key", "wsadrf")
def test_every_way_out_of_the_start_is_gone_at_once_at_full_speed(
    hand: KeyedHand, key: str
) -> None:
    poses = held(hand, key, 30)
    far = [float(np.linalg.norm(pose[:3] - poses[0][:3])) for pose in poses]
    assert far[10] > 0.010
    assert 0.10 * 0.02 < np.max(np.diff(far)) <= 0.2 * 0.02 + 1e-6


@pytest.mark.parametrize("key", "qetgzx")
def test_the_hand_turns_about_its_fingers(hand: KeyedHand, key: str) -> None:
    held(hand, key, 12)
    poses = np.array([hand.tick().pose for _ in range(30)])
    tips = compose(poses, np.array([a465.TCP_M, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]))
    assert np.max(np.abs(tips[:, :3] - [0.5405, 0.0, 0.635])) < 1e-4
    turned = float(np.linalg.norm(quat_to_rotvec(poses[-1][3:])))
    assert turned == pytest.approx(np.deg2rad(24.0), abs=0.03)


def driven(hand: KeyedHand, arm: KinematicArm, keys: str, ticks: int) -> np.ndarray:
    """Return the joints, shape (n, 6), while keys are held in turn and then let go."""
    joints = []
    for key in (*keys, *"    "):
        for _ in range(ticks):
            if key != " ":
                hand.press(key)
            hand.tick()
            joints.append(arm.look().q)
    return np.array(joints)


@pytest.mark.parametrize(
    "keys",
    [
        "wa",
        "adfr",
        "rdsaw",
        "fqwe",
        "tdga",
        "".join(np.random.default_rng(5).permutation(list("wasdrfqetgzx"))),
    ],
)
def test_limits_hold_and_the_hand_keeps_its_turn_through_the_singularity(keys: str) -> None:
    _, scene, setup = lesson()
    arm = KinematicArm()
    arm.arrange(scene, setup)
    q = driven(KeyedHand(arm, A465Planner(), scene, setup), arm, keys, 17)
    speeds = np.diff(q, axis=0) / 0.02
    gains = np.diff(speeds, axis=0) / 0.02
    assert np.all(limit_margin(q) >= 0.0)
    assert np.all(np.abs(speeds) <= a465.SPEEDS)
    assert np.all(np.abs(gains) <= a465.ACCELERATIONS)
    hands = forward(q)
    assert np.max(np.linalg.norm(np.diff(hands[:, :3], axis=0), axis=1)) <= 0.25 * 0.02
    if not set(keys) & set("qetgzx"):
        turned = np.linalg.norm(quat_to_rotvec(hands[:, 3:]), axis=1)
        assert np.max(turned) < np.deg2rad(1.0)
        assert turned[-1] < np.deg2rad(0.01)


def test_a_hand_that_is_led_goes_there_and_letting_go_halts_it(hand: KeyedHand) -> None:
    begin = hand.tick().pose
    for _ in range(6):
        hand.lead((0.004, 0.003, -0.002))
        hand.tick()
    for _ in range(60):
        pose = hand.tick().pose
    assert pose[:3] - begin[:3] == pytest.approx(6 * np.array([0.004, 0.003, -0.002]), abs=1e-5)
    hand.press(" ")
    hand.lead((0.05, 0.0, 0.0))
    assert np.array_equal([hand.tick().pose for _ in range(9)][-1], pose)


@pytest.mark.parametrize(("count", "gap_ticks"), [(9, 0), (30, 0), (30, 1), (9, 3), (3, 8)])
def test_as_many_taps_are_as_many_steps_however_fast(
    hand: KeyedHand, count: int, gap_ticks: int
) -> None:
    begin = hand.tick().pose
    for _ in range(count):
        hand.press("a")
        for _ in range(gap_ticks):
            hand.tick()
    for _ in range(150):
        pose = hand.tick().pose
    assert pose[1] - begin[1] == pytest.approx(count * 0.005, abs=1e-5)


def test_a_held_key_that_is_let_go_stops_within_a_third_of_a_second(hand: KeyedHand) -> None:
    # Terminals repeat keys about 30 times a second.
    for _ in range(25):
        hand.press("a")
        hand.tick()
        pose = [hand.tick().pose for _ in range(1)][-1]
    later = [hand.tick().pose for _ in range(17)]
    assert later[-1][1] - pose[1] < 0.035
    assert np.array_equal(later[-1], hand.tick().pose)


def test_steps_are_chosen_and_told_and_near_the_table_they_are_fine(hand: KeyedHand) -> None:
    assert (hand.state.step_mm, hand.state.step_deg) == pytest.approx((5.0, 2.0))
    for key, size in (("-", 2.0), ("-", 1.0), ("-", 1.0), ("+", 2.0), ("+", 5.0), ("+", 10.0)):
        hand.press(key)
        assert hand.state.step_mm == pytest.approx(size)
    before = hand.tick().pose
    hand.press("r")
    pose = [hand.tick().pose for _ in range(50)][-1]
    assert pose[2] - before[2] == pytest.approx(0.010, abs=1e-6)


def test_the_last_moves_are_taken_back_with_their_time(hand: KeyedHand) -> None:
    shown = [hand.tick(), settled(hand, "a", 6), settled(hand, "w", 4), settled(hand, "c")]
    assert shown[-1].gripper_m == 0.0
    for begin in reversed(shown[:-1]):
        hand.press("u")
        back = [hand.tick() for _ in range(150)]
        assert back[-1].pose == pytest.approx(begin.pose, abs=1e-6)
        assert min(one.t_s for one in back) <= begin.t_s + 0.021
        assert back[-1].gripper_m == pytest.approx(0.08)
        assert not hand.state.returning
    rest = settled(hand, "u").pose
    assert rest == pytest.approx(shown[0].pose, abs=1e-6)


def test_the_hand_is_pointed_down_above_where_it_is(hand: KeyedHand) -> None:
    begin = compose(hand.tick().pose, hand.tip)
    tip = compose(settled(hand, "h", ticks=300).pose, hand.tip)
    assert hand.state.blocked is None
    assert rotate_vector(tip[3:], np.array([1.0, 0.0, 0.0])) == pytest.approx([0, 0, -1], abs=1e-6)
    assert np.linalg.norm(tip[:3] - begin[:3]) < 0.3


def test_led_beyond_what_is_free_the_hand_goes_as_far_as_it_can_and_says_so(
    hand: KeyedHand,
) -> None:
    begin = hand.tick().pose
    hand.lead((0.0, 0.0, -1.0))
    for _ in range(400):
        pose = hand.tick().pose
        if hand.state.blocked:
            break
    assert isinstance(hand.state.blocked, Refusal)
    assert begin[2] - pose[2] > 0.1
    assert np.max(np.abs((pose - begin)[:2])) < 1e-4
    assert np.array_equal([hand.tick().pose for _ in range(20)][-1], pose)


@pytest.mark.parametrize("order", ["xyz", "yxz", "yzx"])
def test_whatever_way_the_block_is_gone_to_the_wrist_has_room_to_carry_it_on(order: str) -> None:
    _, scene, setup = lesson()
    arm = KinematicArm()
    arm.arrange(scene, setup)
    hand = KeyedHand(arm, A465Planner(), scene, setup)
    block, target = (scene.hand_pose(name, setup.places[name]) for name in ("block", "target"))
    above = np.array([0.0, 0.0, 0.15])
    stops = [(block[:3], order), (block[:3] + above, "z"), (target[:3] + above, "yx")]
    for goal, axes in stops:
        for axis in axes:
            k = "xyz".index(axis)
            gap = [0.0, 0.0, 0.0]
            gap[k] = float(goal[k] - arm.look().hand[k])
            hand.lead((gap[0], gap[1], gap[2]))
            for _ in range(30 + round(50.0 * abs(gap[k]) / 0.06)):
                hand.tick()
            assert hand.state.blocked is None
        assert np.max(np.abs(arm.look().hand[:3] - goal) * [a in axes for a in "xyz"]) < 2e-3


@pytest.mark.parametrize(("axis", "key"), [(0, "w"), (1, "a")])
def test_a_tap_ends_abreast_of_the_thing_it_would_pass(axis: int, key: str) -> None:
    _, scene, setup = lesson()
    arm = KinematicArm()
    arm.arrange(scene, setup)
    hand = KeyedHand(arm, A465Planner(), scene, setup)
    goal = scene.hand_pose("block", setup.places["block"])[axis]
    gap = [0.0, 0.0, 0.0]
    gap[axis] = float(goal - arm.look().hand[axis]) * (1.0 - 0.012)
    hand.lead((gap[0], gap[1], gap[2]))
    for _ in range(240):
        hand.tick()
    assert abs(arm.look().hand[axis] - goal) < 0.005
    for wanted in (0.0, 0.005):
        hand.press(key)
        for _ in range(30):
            hand.tick()
        # The next one goes on as ever.
        assert abs(arm.look().hand[axis] - goal) == pytest.approx(wanted, abs=2e-5)
