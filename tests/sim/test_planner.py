"""The planner does what can be done and refuses the rest with the reason."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np
import pytest

from assistant.files.scenes import read_scene
from assistant.geometry import (
    Array,
    angle_between,
    compose,
    distance_between,
    inverse,
    pose_to_mm_deg,
)
from assistant.learning.adaptation import adapt, plan_adaptation
from assistant.learning.lesson import learn
from assistant.model.motion import HandPath, JointPath, Refusal
from assistant.model.scene import Obstacle, Scene
from assistant.model.setup import Place, Setup
from assistant.ports import ArmLook
from sim import a465
from sim.kinematics import forward, limit_margin
from sim.planner import A465Planner
from sim.setups import random_setups
from sim.timing import Timed, timed
from tests.learning.lessons import CUTS_S, sliding_in, task
from tests.sim.hand_paths import TABLE1, pick_and_place, scene, setup, taught
from tests.sim.test_timing import peaks

PLANNER = A465Planner()
TASKS = Path(__file__).parents[2] / "tasks"


def planned(where: Scene, told: Setup, look: ArmLook | None = None) -> JointPath:
    motion = PLANNER.plan(pick_and_place(where, told), where, told, look)
    assert isinstance(motion, JointPath), str(motion)
    return motion


def refused(where: Scene, told: Setup) -> Refusal:
    refusal = PLANNER.plan(pick_and_place(where, told), where, told)
    assert isinstance(refusal, Refusal)
    return refusal


def look_at(q: Array, told: Setup, where: Scene, held: str = "") -> ArmLook:
    bodies = {name: where.body_pose(name, place) for name, place in told.places.items()}
    return ArmLook(q, forward(q), 0.04 if held else 0.08, held, bodies, False, 1.0)


@pytest.mark.parametrize("told", TABLE1)
def test_table_1_is_done_exactly_within_every_limit(told: Setup) -> None:
    where = scene()
    path, motion = pick_and_place(where, told), planned(where, told)
    speed, bend, hand = peaks(motion.q)
    assert max(speed, bend) <= 1.0
    assert hand <= where.hand_speed_m_s
    assert limit_margin(motion.q).min() >= 0.0
    assert motion.joint_margin_deg == pytest.approx(np.rad2deg(limit_margin(motion.q).min()))
    for wanted, stop in zip(path.stops, motion.stops, strict=True):
        reached = forward(motion.q[stop.at])
        assert distance_between(reached, path.path[wanted.at]) < 1e-9
        assert angle_between(reached, path.path[wanted.at]) < 1e-7
    np.testing.assert_allclose(forward(motion.q[0])[:3], told.robot_start.pose[:3], atol=1e-9)


def test_the_exact_stretches_are_followed() -> None:
    where, told = scene(), TABLE1[1]
    path, motion = pick_and_place(where, told), planned(where, told)
    for wanted, stop in zip(path.stops, motion.stops, strict=True):
        shown = path.path[wanted.docking_at : wanted.left_at + 1, :3]
        for pose in forward(motion.q[stop.docking_at : stop.left_at + 1]):
            assert np.linalg.norm(shown - pose[:3], axis=1).min() < 2e-3


def test_ready_is_left_from_its_own_joints() -> None:
    np.testing.assert_allclose(planned(scene(), TABLE1[0]).q[0], a465.READY, atol=1e-9)


@pytest.mark.parametrize("bend_deg", [0.0, 0.01, 0.3, 0.9, 3.0])
def test_a_start_near_the_wrists_singularity_keeps_its_pose(bend_deg: float) -> None:
    q = np.array(a465.READY) + np.deg2rad([10.0, 5.0, -8.0, 50.0, bend_deg, -20.0])
    xyz, rpy = pose_to_mm_deg(forward(q))
    start = Place("hand", (xyz[0], xyz[1], xyz[2]), (rpy[0], rpy[1], rpy[2]))
    told = replace(TABLE1[0], robot_start=start)
    begun = forward(planned(scene(), told).q[0])
    assert distance_between(begun, start.pose) < 1e-9
    assert angle_between(begun, start.pose) < 1e-5


def test_the_same_task_is_always_planned_the_same() -> None:
    first, second = (planned(scene(), TABLE1[0]) for _ in range(2))
    np.testing.assert_array_equal(first.q, second.q)


def test_out_of_reach_is_refused_by_how_much() -> None:
    refusal = refused(scene(), setup((800.0, 0.0, 300.0), 0.0, (500.0, -240.0, 300.0), 0.0))
    assert (refusal.reason, refusal.where, refusal.hint) == ("reach", "grasp of block", "closer")
    # The wrist would be 76.2 mm nearer, 30.2 mm below the shoulder; the arm is 635 mm long.
    assert refusal.amount == pytest.approx(np.hypot(723.8, 30.2) - 635.0, abs=0.1)


def test_a_joint_beyond_its_limit_is_named() -> None:
    refusal = refused(scene(), setup((500.0, 240.0, 300.0), -80.0, (500.0, -240.0, 300.0), 0.0))
    assert refusal.reason == "joint_limit"
    assert refusal.what.startswith("joint ")
    assert refusal.amount > 0.0
    assert refusal.unit == "deg"


def test_a_post_in_the_way_is_gone_around() -> None:
    post = Obstacle("post", (60.0, 60.0, 260.0), (560.0, -20.0, 240.0))
    assert planned(scene(post), TABLE1[1]).note.endswith("post on the way to target")
    assert planned(scene(), TABLE1[1]).note == ""


def test_a_post_at_the_target_is_refused_by_name() -> None:
    post = Obstacle("post", (30.0, 30.0, 300.0), (480.0, -285.0, 240.0))
    refusal = refused(scene(post), TABLE1[1])
    assert refusal.reason == "collision"
    assert refusal.what.startswith("post")


@pytest.mark.parametrize(
    ("told", "what"),
    [
        (setup((533.0, 270.0, 300.0), 0.0, (540.0, 265.0, 300.0), 0.0), "target"),
        (setup((533.0, 270.0, 270.0), 0.0, (520.0, -240.0, 300.0), 0.0), "table"),
    ],
)
def test_things_inside_one_another_are_refused_as_a_setup(told: Setup, what: str) -> None:
    refusal = refused(scene(), told)
    assert (refusal.reason, refusal.what) == ("setup", what)


def test_what_is_touched_between_the_samples_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    where, told = scene(), TABLE1[1]

    def sagging(u_s: Array, q: Array, hand: Array, most_m_s: float) -> Timed:
        result = timed(u_s, q, hand, most_m_s)
        lower = np.array(result.q)
        tick = int(np.searchsorted(result.u_s, 2.0))
        lower[tick, 1] += 0.7
        return replace(result, q=lower)

    monkeypatch.setattr("sim.planner.timed", sagging)
    refusal = refused(where, told)
    assert (refusal.reason, refusal.what) == ("collision", "table")


def test_fingers_told_to_close_on_the_way_are_open_until_they_act() -> None:
    where, told = scene(), TABLE1[1]
    motion = planned(where, told)
    tick = motion.stops[0].left_at
    look = look_at(motion.q[tick], told, where)
    block = compose(look.hand, inverse(where.bodies["block"].hand_in_body))
    closing = step(look.hand, np.array([0.0, 0.0, 0.02]))
    closing = replace(closing, gripper_m=0.05 + 0.03 * np.cos(np.linspace(0.0, 2.0 * np.pi, 30)))
    away = PLANNER.plan(closing, where, told, replace(look, bodies={"block": block}))
    assert isinstance(away, JointPath), str(away)
    assert away.t_s[-1] < 2.0


def test_a_body_inside_an_obstacle_is_refused_as_a_setup() -> None:
    crate = Obstacle("crate", (200.0, 200.0, 80.0), (680.0, 190.0, 240.0))
    refusal = refused(scene(crate), TABLE1[1])
    assert (refusal.reason, refusal.where, refusal.what) == ("setup", "block", "crate")


def test_with_a_look_the_motion_begins_at_the_measured_joints() -> None:
    where, told = scene(), TABLE1[1]
    q = a465.READY + np.array([0.2, 0.05, -0.1, 0.3, 0.2, -0.1])
    motion = planned(where, told, look_at(q, told, where))
    np.testing.assert_allclose(motion.q[0], q, atol=1e-9)
    assert peaks(motion.q)[1] <= 1.0


def test_the_rest_of_a_task_goes_on_with_the_block_in_the_hand() -> None:
    where, told = scene(), TABLE1[1]
    path, whole = pick_and_place(where, told), planned(where, told)
    tick = whole.stops[0].left_at + 60
    sample = path.stops[0].left_at + 60
    q = whole.q[tick]
    block = compose(forward(q), inverse(where.bodies["block"].hand_in_body))
    look = replace(look_at(q, told, where, "block"), bodies={"block": block})
    stop = path.stops[1]
    rest = HandPath(
        path.t_s[sample:] - path.t_s[sample],
        path.path[sample:],
        path.gripper_m[sample:],
        path.primitive_at[sample:],
        (
            replace(
                stop,
                at=stop.at - sample,
                docking_at=stop.docking_at - sample,
                left_at=stop.left_at - sample,
            ),
        ),
    )
    motion = PLANNER.plan(rest, where, told, look)
    assert isinstance(motion, JointPath), str(motion)
    np.testing.assert_allclose(motion.q[0], q, atol=1e-9)
    reached = forward(motion.q[motion.stops[0].at])
    assert distance_between(reached, path.path[stop.at]) < 1e-9


def step(hand: Array, offset: Array) -> HandPath:
    s = np.linspace(0.0, 1.0, 30)[:, None]
    path = hand + (3.0 * s**2 - 2.0 * s**3) * np.concatenate([offset, np.zeros(4)])
    return HandPath(
        np.linspace(0.0, 0.58, 30), path, np.full(30, 0.08), np.full(30, -1, dtype=np.int64)
    )


def test_a_small_step_ends_where_it_should() -> None:
    where, told = scene(), TABLE1[3]
    motion = planned(where, told)
    look = look_at(motion.q[0], told, where)
    jog = PLANNER.plan(step(look.hand, np.array([0.0, 0.005, 0.0])), where, told, look)
    assert isinstance(jog, JointPath), str(jog)
    moved = forward(jog.q[-1])[:3] - look.hand[:3]
    np.testing.assert_allclose(moved, [0.0, 0.005, 0.0], atol=1e-9)


def test_a_step_into_the_table_is_refused() -> None:
    where, told = scene(), TABLE1[3]
    look = look_at(planned(where, told).q[0], told, where)
    jog = PLANNER.plan(step(look.hand, np.array([0.0, 0.0, -0.05])), where, told, look)
    assert isinstance(jog, Refusal)
    assert (jog.reason, jog.what) == ("collision", "table")


def test_a_rest_in_the_singularity_keeps_the_measured_joints() -> None:
    q = a465.READY + np.array([0.0, 0.0, 0.0, 0.5, 0.0, -0.5])
    look = look_at(q, TABLE1[0], scene())
    rest = PLANNER.plan(step(look.hand, np.zeros(3)), scene(), TABLE1[0], look)
    assert isinstance(rest, JointPath), str(rest)
    np.testing.assert_allclose(rest.q, np.repeat(q[None], len(rest.q), axis=0), atol=1e-9)


def test_a_carried_block_is_not_pressed_into_the_table() -> None:
    where, told = scene(), TABLE1[1]
    motion = planned(where, told)
    look = look_at(motion.q[motion.stops[0].at], told, where, "block")
    down, up = (step(look.hand, np.array([0.0, 0.0, by])) for by in (-0.005, 0.005))
    refusal = PLANNER.plan(down, where, told, look)
    assert isinstance(refusal, Refusal)
    assert (refusal.reason, refusal.what) == ("collision", "table")
    assert isinstance(PLANNER.plan(up, where, told, look), JointPath)


@pytest.mark.slow
def test_what_the_plain_check_calls_reachable_is_done() -> None:
    where = scene()
    for told in islice(random_setups(taught(), where, 11), 15):
        planned(where, told)


def test_a_start_that_cannot_be_held_is_refused() -> None:
    told = replace(TABLE1[0], robot_start=Place("hand", (406.4, 0.0, 1200.0)))
    assert refused(scene(), told).where == "start"


def test_a_task_shown_by_sliding_in_from_the_side_is_carried_out() -> None:
    shown, where = sliding_in(), read_scene(TASKS / "scenes" / "demonstration_table.yaml")
    lesson = learn([shown], task(), cuts_s=CUTS_S, scene=where)
    path = adapt(plan_adaptation(replace(task(), learned=lesson)), where, shown.setup)
    motion = PLANNER.plan(path, where, shown.setup)
    assert isinstance(motion, JointPath), str(motion)
