"""What the Arm port promises, held by every adapter: with contact physics and without."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from assistant.errors import WorkFailed
from assistant.geometry import compose, distance_between, inverse
from assistant.model.motion import ArmReport, JointPath
from assistant.model.setup import Place
from sim import a465
from sim.bullet_arm import BulletArm
from sim.kinematic_arm import KinematicArm
from sim.sensor import InHandSensor
from sim.simulated_arm import SimulatedArm
from sim.world import CONTROL_S
from tests.sim.placing import begun, lesson, motion, ticked_to, told_until_rest

Maker = Callable[..., SimulatedArm]


@pytest.fixture(params=[KinematicArm, BulletArm], ids=["kinematic", "pybullet"])
def make(request: pytest.FixtureRequest) -> Maker:
    maker: Maker = request.param
    return maker


def test_a_run_is_told_in_order_and_ends_aligned(make: Maker) -> None:
    arm = make(sensor=InHandSensor())
    begun(arm)
    reports = told_until_rest(arm)
    assert [r.primitive_at for r in reports if r.kind == "primitive"] == [0, 1, 2, 3, 4]
    perceived = [(r.text, r.object) for r in reports if r.kind == "perceived"]
    assert perceived == [
        ("docked", "block"),
        ("hand", "closed"),
        ("held", "block"),
        ("docked", "target"),
        ("hand", "open"),
        ("on", "block"),
        ("aligned", "block"),
        ("clear", "block"),
    ]
    (found,) = reports[-1].alignments
    assert (found.object, found.target) == ("block", "target")
    assert found.distance_mm <= 0.1
    assert found.angle_deg <= 0.1
    assert not arm.look().moving


def test_held_means_the_body_moves_with_the_hand(make: Maker) -> None:
    arm = make()
    begun(arm)
    ticked_to(arm, "held")
    before = arm.look()
    assert before.held == "block"
    for _ in range(150):
        arm.tick()
    after = arm.look()
    assert float(distance_between(before.hand, after.hand)) > 0.05
    in_hand = [compose(inverse(look.hand), look.bodies["block"]) for look in (before, after)]
    assert float(distance_between(*in_hand)) < 2e-4


def test_a_stop_brakes_within_a_tick_stays_on_the_path_and_keeps_the_grip(make: Maker) -> None:
    flag = threading.Event()
    arm = make(flag)
    begun(arm)
    ticked_to(arm, "held")
    for _ in range(120):
        arm.tick()
    running = [arm.look().q]
    arm.tick()
    running.append(arm.look().q)
    flag.set()
    reports: list[ArmReport] = []
    while arm.look().moving:
        reports.extend(arm.tick())
        running.append(arm.look().q)
    steps = np.max(np.abs(np.diff(running, axis=0)), axis=1)
    assert steps[1] < steps[0]
    assert CONTROL_S * (len(running) - 2) <= 0.25
    assert [(r.kind, r.text) for r in reports if r.kind == "halted"] == [("halted", "stop")]
    gaps = np.max(np.abs(motion().q - arm.look().q), axis=1)
    assert float(np.min(gaps)) < 0.02
    assert arm.look().held == "block"


def test_pads_leave_what_stands_slowly_and_before_the_hand_opens(make: Maker) -> None:
    arm = make()
    begun(arm)
    openings_m = [_parting(arm)]
    while openings_m[-1] < openings_m[0] + 0.01:
        arm.tick()
        openings_m.append(arm.look().gripper_m)
    # At the speed of an opening hand it would take less.
    assert len(openings_m) * CONTROL_S > 1.5 * 0.01 / a465.GRIPPER.speed_m_s


def test_a_stop_while_the_pads_leave_keeps_the_grip(make: Maker) -> None:
    arm = make()
    begun(arm)
    _parting(arm)
    arm.stop("pause")
    assert told_until_rest(arm)[-1].text == "pause"
    for _ in range(20):
        arm.tick()
    assert arm.look().held == "block"


def test_the_grip_is_kept_until_the_step_that_lets_go_has_begun(make: Maker) -> None:
    arm, plan = make(), motion()
    release = plan.stops[-1].at
    begins = np.array(plan.primitive_at)
    # The hand stands at the place long before.
    begins[begins == begins[release]] -= 1
    begins[release - 3 :] = plan.primitive_at[release]
    assert np.max(np.abs(plan.q[release - 10 : release] - plan.q[release])) < 1e-5
    _, scene, setup = lesson()
    arm.arrange(scene, setup)
    arm.start(replace(plan, primitive_at=begins))
    while arm.look().moving:
        told = arm.tick()
        if any((one.kind, one.primitive_at) == ("primitive", begins[release]) for one in told):
            break
    assert arm.look().held == "block"
    assert told_until_rest(arm)[-1].kind == "finished"


def _parting(arm: SimulatedArm) -> float:
    """Tick until the pads have begun to leave the block and return their opening."""
    ticked_to(arm, "held")
    width_m = arm.look().gripper_m
    while arm.look().gripper_m < width_m + 1e-4:
        arm.tick()
    assert arm.look().moving
    return arm.look().gripper_m


def test_a_stop_latches_until_a_new_start_from_the_measured_pose(make: Maker) -> None:
    arm = make()
    begun(arm)
    for _ in range(60):
        arm.tick()
    arm.stop("pause")
    assert told_until_rest(arm)[-1].text == "pause"
    rest = arm.look().q
    for _ in range(10):
        assert arm.tick() == ()
    assert np.max(np.abs(arm.look().q - rest)) < 1e-4
    with pytest.raises(WorkFailed, match="plan anew"):
        arm.start(motion())


def test_full_speed_comes_to_rest_within_a_quarter_second(make: Maker) -> None:
    arm = make()
    _, scene, setup = lesson()
    arm.arrange(scene, setup)
    count = 60
    ramp = np.clip(np.arange(count) / 14.0, 0.0, 1.0)
    q = np.tile(a465.READY, (count, 1))
    q[:, 0] = np.cumsum(ramp) * a465.SPEEDS[0] * CONTROL_S * 0.95
    none = np.full(count, -1)
    full = np.full(count, a465.GRIPPER.open_m)
    arm.start(
        JointPath(CONTROL_S * np.arange(count, dtype=float), q, full, none, (), 0.0, 1.0, 0.0)
    )
    for _ in range(40):
        arm.tick()
    begun_s = arm.look().now_s
    arm.stop("stop")
    told_until_rest(arm)
    assert arm.look().now_s - begun_s <= 0.25 + 1e-9


def test_a_body_that_is_not_there_halts_the_run(make: Maker) -> None:
    arm = make()
    _, scene, setup = lesson()
    away = Place("body", (-500.0, 500.0, 240.0))
    moved = replace(setup, places={**setup.places, "block": away})
    arm.arrange(scene, moved)
    arm.start(motion())
    last = told_until_rest(arm)[-1]
    assert (last.kind, last.text, last.object) == ("unmet", "held", "block")


def test_a_run_can_be_begun_again_after_arranging(make: Maker) -> None:
    arm = make()
    for _ in range(2):
        begun(arm, 1)
        ticked_to(arm, "docked")
        arm.stop("stop")
        told_until_rest(arm)
