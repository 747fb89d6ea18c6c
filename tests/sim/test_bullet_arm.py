"""Contact: what holds, what is noticed, what the sensor in the hand is good for."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assistant.geometry import angle_between, compose, distance_between, inverse
from assistant.model.motion import JointPath
from assistant.model.scene import Obstacle
from sim.bullet_arm import BulletArm
from sim.bullet_settings import BulletSettings
from sim.planner import A465Planner
from sim.sensor import InHandSensor, PlaceNoise
from tests.sim import hand_paths
from tests.sim.placing import begun, lesson, motion, told_until_rest


def test_the_sensor_takes_errors_of_told_places_out_of_the_result() -> None:
    distances = []
    for sensor in (None, InHandSensor(seed=2)):
        arm = BulletArm(sensor=sensor, noise=PlaceNoise(0.001, 1.0, seed=4))
        begun(arm, 3)
        (found,) = told_until_rest(arm)[-1].alignments
        distances.append(found.distance_mm)
    assert distances[0] > 0.2
    assert distances[1] < 0.1


def test_unexpected_contact_halts_the_run_and_names_the_body() -> None:
    arm = BulletArm()
    _, scene, setup = lesson()
    hand = _pads_before_docking()
    post = Obstacle("post", (40.0, 40.0, 300.0), (hand[0], hand[1], 240.0))
    arm.arrange(replace(scene, obstacles=(post,)), setup)
    arm.start(motion())
    last = told_until_rest(arm)[-1]
    assert (last.kind, last.text) == ("unmet", "contact")
    assert last.object in ("post", "block")


def test_an_arm_that_does_not_follow_its_path_halts_the_run() -> None:
    arm = BulletArm(settings=BulletSettings(joint_force=20.0))
    begun(arm)
    last = told_until_rest(arm)[-1]
    assert (last.kind, last.text) == ("unmet", "tracking")
    assert not arm.look().moving


def _pads_before_docking() -> tuple[float, float]:
    """Where the pads are, in mm, a second before the hand docks."""
    from assistant.geometry import transform_points
    from sim import a465
    from sim.kinematics import forward

    planned = motion()
    hand = forward(planned.q[planned.stops[0].docking_at - 10])
    x, y, _ = transform_points(hand, [a465.TCP_M, 0.0, 0.0]) * 1000.0
    return float(x), float(y)


def test_runs_repeat_exactly() -> None:
    found = []
    for _ in range(2):
        arm = BulletArm(sensor=InHandSensor())
        begun(arm, 2)
        found.append(told_until_rest(arm)[-1].alignments)
    assert found[0] == found[1]


def test_a_body_keeps_its_place_in_a_hand_that_turns_far() -> None:
    scene = hand_paths.scene()
    setup = hand_paths.setup((300.0, -400.0, 300.0), -60.0, (-200.0, 520.0, 300.0), 110.0)
    motion = A465Planner().plan(hand_paths.pick_and_place(scene, setup), scene, setup)
    assert isinstance(motion, JointPath)
    arm = BulletArm(sensor=InHandSensor(), noise=PlaceNoise(seed=3))
    arm.arrange(scene, setup)
    arm.start(motion)
    seen = []
    while arm.look().moving:
        arm.tick()
        look = arm.look()
        if look.held:
            seen.append(compose(inverse(look.hand), look.bodies["block"]))
    in_hand = np.array(seen)
    assert np.max(distance_between(in_hand[1:], in_hand[:-1])) < 5e-5
    assert np.max(angle_between(in_hand[1:], in_hand[:-1])) < np.deg2rad(0.05)
