from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.errors import BadInput, NothingLearned
from assistant.geometry import angle_between, compose, distance_between, quat_to_rotvec, relative
from assistant.learning.docking import grasp_ways, lateral_axis
from assistant.learning.lesson import learn
from assistant.learning.timing import rms_jerk
from assistant.model.conditions import Condition
from assistant.model.demonstration import Recording
from assistant.model.feedback import Feedback
from assistant.model.lesson import LearnedPath
from assistant.model.scene import Body, Scene
from tests.learning.lessons import CUTS_S, NAMES, demonstration, learned, lesson, task


@given(seed=st.integers(0, 1000))
@settings(max_examples=4, deadline=None)
def test_from_docking_to_grasp_the_hand_neither_turns_nor_goes_sideways(seed: int) -> None:
    made = lesson(0.0005, seed)
    assert made.path is not None
    grasp = made.stations[0]
    seen = relative(made.path.path[grasp.at], made.path.path[grasp.docking_at : grasp.at + 1])
    assert np.max(np.abs(seen[:, 1])) < 1e-9
    assert np.max(np.abs(quat_to_rotvec(seen[:, 3:]))) < 1e-9
    assert np.linalg.norm(seen[0, :3]) > 0.01


@given(seed=st.integers(0, 1000))
@settings(max_examples=4, deadline=None)
def test_from_docking_to_release_the_hand_goes_along_the_normal(seed: int) -> None:
    made = lesson(0.0005, seed)
    assert made.path is not None
    release = made.stations[1]
    path = made.path.path[release.docking_at : release.at + 1]
    assert np.max(np.abs(path[:, :2] - path[-1, :2])) < 1e-9
    assert np.max(angle_between(path, path[-1])) < 1e-9
    assert path[0, 2] - path[-1, 2] > 0.01


def test_docking_completes_the_primitives_before() -> None:
    made = lesson()
    assert made.path is not None
    for station, cut in zip(made.stations, (CUTS_S[0], CUTS_S[3]), strict=True):
        assert made.path.t_s[station.docking_at] == pytest.approx(cut, abs=0.05)
        assert made.path.primitive_at[station.at] == NAMES.index(station.primitive)


@pytest.mark.parametrize("late_s", [-0.3, -0.05, 0.0, 0.05, 0.3])
def test_what_grasps_or_releases_begins_before_the_hand_acts(late_s: float) -> None:
    """Cuts at the very instant of the hand are usual: what must hold before is looked at then."""
    acts_s = [learned_path().t_s[station.at] for station in lesson().stations]
    cuts_s = (acts_s[0] + late_s, *CUTS_S[1:3], acts_s[1] + late_s)
    made = learn([demonstration()], task(), cuts_s=cuts_s)
    assert made.path is not None
    assert made.path.gripper_m is not None
    acting = np.flatnonzero(np.diff(made.path.gripper_m))
    for station in made.stations:
        own = np.flatnonzero(made.path.primitive_at == NAMES.index(station.primitive))
        first = acting[np.argmin(np.abs(acting - station.at))]
        while first - 1 in acting:
            first -= 1
        assert made.path.t_s[own[0]] <= made.path.t_s[first] - 0.04


def learned_path() -> LearnedPath:
    path = lesson().path
    assert path is not None
    return path


def test_a_tilted_targets_own_normal_counts() -> None:
    normal = (0.0, np.sin(0.2), np.cos(0.2))
    scene = Scene(bodies={"target": Body("target", normal=normal, grasp_xyz_mm=(0, 0, 0))})
    made = learn([demonstration()], task(), cuts_s=CUTS_S, scene=scene)
    assert made.path is not None
    release = made.stations[1]
    way = made.path.path[release.docking_at, :3] - made.path.path[release.at, :3]
    seen = relative(
        release.frame_to_world, np.append(way + release.frame_to_world[:3], [0, 0, 0, 1.0])
    )
    assert np.allclose(seen[:3] / np.linalg.norm(seen[:3]), normal, atol=1e-9)


def test_the_hand_in_its_frame_is_where_it_closed() -> None:
    made = lesson()
    assert made.path is not None
    for one in made.stations:
        pose = compose(one.frame_to_world, one.hand_in_frame)
        assert distance_between(pose, made.path.path[one.at]) < 1e-12
        assert np.linalg.norm(one.hand_in_frame[:3]) < 2e-4


@pytest.mark.parametrize("hasty", [False, True])
def test_the_hand_rests_while_the_gripper_acts(hasty: bool) -> None:
    made = lesson(hasty=hasty)
    assert made.path is not None
    for one in made.stations:
        still = distance_between(made.path.path, made.path.path[one.at]) < 1e-9
        assert np.count_nonzero(still) * 0.02 >= 0.4
    speed = np.linalg.norm(np.diff(made.path.path[:, :3], axis=0), axis=1) / 0.02
    assert np.max(np.abs(np.diff(speed))) < 0.02


def test_conditions_are_inferred() -> None:
    made = lesson()
    assert made.before["approach object"] == (Condition("hand", "open"),)
    assert made.until["approach object"] == (Condition("docked", "block"),)
    assert made.until["grasp object"] == (Condition("held", "block"),)
    assert made.before["move up object"] == (Condition("held", "block"),)
    assert Condition("on", "block", "target") in made.until["place object"]
    assert Condition("aligned", "block", "target") in made.until["place object"]


def test_a_part_without_a_change_may_be_skipped_which_is_asked() -> None:
    asked = [one.about for one in lesson().segmentation.questions if one.asked == "optional"]
    assert asked == ["move up object"]


def test_without_a_gripper_only_cuts_and_a_question_remain() -> None:
    made = learn([demonstration(gripper=False)], task())
    assert made.path is None
    assert made.stations == ()
    assert len(made.segmentation.cuts_s) == 4
    assert "no_gripper" in [one.reason for one in made.segmentation.questions]


def test_a_hand_that_never_closes_teaches_nothing() -> None:
    shown = demonstration()
    opened = Recording(shown.recording.t_s, shown.recording.path, np.full(801, 0.08))
    with pytest.raises(NothingLearned, match="never closes"):
        learn([replace(shown, recording=opened)], task())


def test_holding_at_the_end_keeps_what_was_shown_and_asks() -> None:
    shown = demonstration().recording
    half = slice(0, 500)
    assert shown.gripper_m is not None
    recording = Recording(shown.t_s[half], shown.path[half], shown.gripper_m[half])
    made = learn([replace(demonstration(), recording=recording)], task())
    assert [one.kind for one in made.stations] == ["grasp"]
    assert "ends_holding" in [one.reason for one in made.segmentation.questions]


def test_places_not_told_are_where_the_hand_acted() -> None:
    bare = replace(demonstration(), setup=replace(demonstration().setup, places={}))
    made = learn([bare], task(), cuts_s=CUTS_S)
    for one in made.stations:
        assert np.allclose(one.hand_in_frame[:3], 0.0, atol=1e-12)


def test_a_place_on_a_block_is_taken_from_the_blocks_height() -> None:
    bodies = {
        "block": Body("block", grasp_xyz_mm=(-134.1, 0.0, 60.0)),
        "target": Body("target", size_mm=(80, 60, 80), grasp_xyz_mm=(-134.1, 0.0, 55.0)),
    }
    bare = replace(demonstration(), setup=replace(demonstration().setup, places={}))
    made = learn([bare], task(), cuts_s=CUTS_S, scene=Scene(bodies=bodies))
    assert made.stations[1].hand_in_frame[2] == pytest.approx(0.080 + 0.060 - 0.055)


def test_no_demonstration_is_refused() -> None:
    with pytest.raises(BadInput, match="at least one"):
        learn([], task())


def test_corrections_given_before_are_kept() -> None:
    given = Feedback("translate", "more left", "place object", frame="target")
    again = learn([demonstration()], learned([given]), cuts_s=CUTS_S)
    assert again.feedback == (given,)


def test_several_demonstrations_average_where_the_hand_acts() -> None:
    shown = [demonstration(0.0008, seed) for seed in range(4)]
    alone = [learn([one], task()) for one in shown]
    made = learn(shown, task())
    for k, station in enumerate(made.stations):
        hands = np.array([one.stations[k].hand_in_frame[:3] for one in alone])
        assert np.allclose(station.hand_in_frame[:3], hands.mean(axis=0), atol=1e-12)
        assert made.path is not None
        seen = relative(station.frame_to_world, made.path.path[station.at])
        assert np.allclose(seen, station.hand_in_frame, atol=1e-9)
    assert made.sources == ("made",) * 4


def test_the_lateral_axis_is_neither_the_approach() -> None:
    for axis in ("x", "y", "z", "-x", "-z"):
        ways = grasp_ways(axis)
        assert np.allclose(ways @ ways.T, np.eye(2))
        assert np.allclose(ways @ lateral_axis(axis), 0.0)


def test_jerk_is_that_of_the_demonstration_before_it_was_changed() -> None:
    made, hasty = lesson(), lesson(hasty=True)
    assert made.path is not None
    assert hasty.path is not None
    assert made.jerk_m_s3 == pytest.approx(rms_jerk(made.path.path[:, :3], 0.02), rel=0.1)
    # A hand that closed in motion is braked for it: the learned path has more jerk.
    assert hasty.jerk_m_s3 == pytest.approx(made.jerk_m_s3, rel=0.01)
    assert rms_jerk(hasty.path.path[:, :3], 0.02) > 1.05 * (hasty.jerk_m_s3 or 0.0)


def test_sources_are_file_names() -> None:
    shown = replace(demonstration(), source="some/folder/shown.yaml")
    assert learn([shown], task(), cuts_s=CUTS_S).sources == ("shown.yaml",)
