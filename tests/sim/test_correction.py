"""Correcting a release by what the sensor in the hand sees."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import (
    IDENTITY,
    Array,
    angle_between,
    compose,
    distance_between,
    inverse,
    pose_from_mm_deg,
)
from assistant.model.motion import JointPath
from assistant.model.placing import turned_back
from assistant.model.scene import Body, Obstacle, Scene
from sim import a465
from sim.correction import checked, corrected, release_offset, slipped
from sim.kinematic_arm import KinematicArm
from sim.kinematics import forward
from sim.rechecking import still_free
from sim.sensor import InHandSensor, PlaceNoise
from sim.world import Fault
from tests.sim.placing import begun, lesson, motion, ticked_to, told_until_rest

BLOCK = Body("block")
PLACE = pose_from_mm_deg((500, 100, 240), (0, 0, 30))
small = st.floats(-3.0, 3.0)


@settings(max_examples=10, deadline=None)
@given(small, small, st.floats(-1.5, 1.5))
def test_a_corrected_release_puts_the_body_where_the_plan_meant(
    x_mm: float, y_mm: float, deg: float
) -> None:
    planned = motion(3)
    release = planned.stops[1]
    supposed = inverse(BLOCK.hand_in_body)
    seen = compose(supposed, pose_from_mm_deg((x_mm, y_mm, 0), (0, 0, deg)))
    offset = release_offset(supposed, seen)
    assert offset is not None
    begin = planned.stops[0].left_at
    better = corrected(planned, offset, begin, release.docking_at, release)
    assert better is not None
    meant = compose(forward(planned.q[release.at]), supposed)
    reached = compose(forward(better.q[release.at]), seen)
    assert float(distance_between(meant, reached)) < 1e-9
    assert float(angle_between(meant, reached)) < 1e-7
    assert np.array_equal(better.q[:begin], planned.q[:begin])


def test_a_free_stretch_along_a_limit_does_not_forbid_a_correction() -> None:
    planned = motion()
    release = planned.stops[1]
    q = np.array(planned.q)
    after = slice(release.left_at + 1, len(q))
    share = np.linspace(0.0, 1.0, len(q[after]))[:, None]
    q[after, 5] += share[:, 0] * (a465.LIMITS[5] - q[after, 5])
    at_limit = replace(planned, q=q, t_s=np.arange(len(q)) / 5.0)
    for sign in (-1.0, 1.0):
        offset = pose_from_mm_deg((0, 0, 0), (sign, 0, 0))
        begin = planned.stops[0].left_at
        better = corrected(at_limit, offset, begin, release.docking_at, release)
        assert better is not None
        assert np.all(np.abs(better.q) <= a465.LIMITS)


def test_a_hand_that_cannot_leave_as_corrected_comes_back_to_the_plan_as_it_leaves() -> None:
    planned = motion()
    release = planned.stops[1]
    q = np.array(planned.q)
    leaving = slice(release.at, release.left_at + 1)
    share = np.linspace(0.0, 1.0, release.left_at - release.at + 1)
    q[leaving, 5] += share * (a465.LIMITS[5] - q[leaving, 5])
    q[release.left_at :, 5] = a465.LIMITS[5]
    at_limit = replace(planned, q=q, t_s=np.arange(len(q)) / 5.0)
    begin = planned.stops[0].left_at
    for sign in (-1.0, 1.0):
        offset = pose_from_mm_deg((0, 0, 0), (sign, 0, 0))
        done = checked(at_limit, offset, begin, release.docking_at, release, lambda _: True)
        assert done is not None
        better, part = done
        np.testing.assert_allclose(part, offset)
        assert np.all(np.abs(better.q) <= a465.LIMITS)
        meant = compose(forward(q[release.at]), offset)
        assert float(angle_between(meant, forward(better.q[release.at]))) < 1e-7


def test_of_a_correction_that_would_touch_something_a_part_is_done() -> None:
    planned = motion()
    release = planned.stops[1]
    offset = pose_from_mm_deg((0, 4, 0), (0, 0, 0))
    begin = planned.stops[0].left_at

    def free(better: JointPath) -> bool:
        gap = distance_between(forward(better.q[release.at]), forward(planned.q[release.at]))
        return float(gap) < 0.0025

    done = checked(planned, offset, begin, release.docking_at, release, free)
    assert done is not None
    assert done[1][1] == pytest.approx(0.002)
    nothing = checked(planned, offset, begin, release.docking_at, release, lambda _: False)
    assert nothing is None


def test_a_corrected_motion_is_checked_for_collision() -> None:
    planned = motion()
    _, scene, setup = lesson()
    arm = KinematicArm()
    begun(arm)
    ticked_to(arm, "held")
    begin = planned.stops[0].left_at
    assert still_free(scene, setup, arm.look(), begin)(planned)
    hand = forward(planned.q[planned.stops[1].docking_at])
    walled = replace(
        scene, obstacles=(Obstacle("wall", (100, 100, 600), (hand[0] * 1e3, hand[1] * 1e3, 240)),)
    )
    assert not still_free(walled, setup, arm.look(), begin)(planned)


@pytest.mark.parametrize(("seen_mm", "text"), [(4.0, "aligned"), (20.0, "slipped")])
def test_a_release_that_cannot_be_corrected_halts_the_run(
    monkeypatch: pytest.MonkeyPatch, seen_mm: float, text: str
) -> None:
    class Crooked(InHandSensor):
        def look(self, body_in_hand: Array) -> Array:
            return compose(body_in_hand, pose_from_mm_deg((0, seen_mm, 0), (0, 0, 0)))

    monkeypatch.setattr("sim.simulated_arm.checked", lambda *_: None)
    arm = KinematicArm(sensor=Crooked())
    begun(arm)
    last = told_until_rest(arm)[-1]
    assert (last.kind, last.text, last.object) == ("unmet", text, "block")
    assert last.amount == (pytest.approx(seen_mm) if text == "slipped" else None)


def test_a_body_that_slipped_far_is_not_corrected_for() -> None:
    far = pose_from_mm_deg((20, 0, 0), (0, 0, 0))
    assert release_offset(IDENTITY, far) is None
    assert slipped("block", IDENTITY, far) == Fault("slipped", "block", "", 20.0, "mm")
    turned = pose_from_mm_deg((0, 0, 0), (0, 0, 12))
    assert release_offset(IDENTITY, turned) is None
    fault = slipped("block", IDENTITY, turned)
    assert fault.amount == pytest.approx(12.0)
    assert fault.unit == "deg"


def test_the_sensor_has_the_noise_it_states() -> None:
    sensor = InHandSensor(noise_m=1e-4, noise_deg=0.1, looks=1, seed=1)
    seen = np.array([sensor.look(IDENTITY) for _ in range(2000)])
    assert np.std(seen[:, :3]) == pytest.approx(1e-4, rel=0.05)
    assert np.rad2deg(np.std(2 * seen[:, 3:6])) == pytest.approx(0.1, rel=0.05)


def test_misplaced_bodies_stay_within_the_noise() -> None:
    scene = Scene(bodies={"block": BLOCK})
    for seed in range(50):
        moved = PlaceNoise(0.001, 1.0, seed).misplaced({"block": PLACE}, scene)["block"]
        assert float(distance_between(moved, PLACE)) <= 0.001
        assert float(angle_between(moved, PLACE)) <= np.deg2rad(1.0) + 1e-12


def test_how_a_round_body_is_turned_in_the_hand_is_not_corrected() -> None:
    cup = Body("cup", "cup", (70.0, 70.0, 80.0))
    supposed = inverse(cup.hand_in_body)
    seen = compose(supposed, pose_from_mm_deg((0.4, 0.0, 0.0), (0.0, 0.0, 25.0)))
    assert release_offset(supposed, seen) is None
    offset = release_offset(supposed, turned_back(cup, seen, supposed))
    assert offset is not None
    assert float(angle_between(offset, IDENTITY)) < 1e-9
    assert float(np.linalg.norm(offset[:3])) == pytest.approx(0.0004, abs=1e-9)
