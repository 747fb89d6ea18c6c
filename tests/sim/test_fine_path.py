"""A refined path passes through all its own samples, and rests where they rest."""

from __future__ import annotations

import numpy as np

from assistant.geometry import angle_between, distance_between
from assistant.model.motion import HandPath, HandStop
from sim.fine_path import FREE_SAMPLES, STEP_S, joined, refine, relaxed
from tests.sim.hand_paths import TABLE1, back, pick_and_place, scene


def coarse(every: int = 10) -> HandPath:
    """Return pick and place with every tenth sample only."""
    path = pick_and_place(scene(), TABLE1[1])
    kept = slice(None, None, every)
    stops = tuple(
        HandStop(
            s.at // every, s.kind, s.object, s.frame, s.docking_at // every, s.left_at // every
        )
        for s in path.stops
    )
    return HandPath(
        path.t_s[kept], path.path[kept], path.gripper_m[kept], path.primitive_at[kept], stops
    )


def test_all_its_own_samples_are_kept_and_none_is_far_from_the_next() -> None:
    path = coarse()
    fine = refine(path)
    assert np.diff(fine.u_s).max() <= STEP_S + 1e-9
    index = np.searchsorted(fine.u_s, path.t_s - 1e-9)
    np.testing.assert_allclose(fine.u_s[index], path.t_s, atol=1e-9)
    assert distance_between(fine.poses[index], path.path).max() < 1e-12
    assert angle_between(fine.poses[index], path.path).max() < 1e-7
    for told, stop in zip(path.stops, fine.stops, strict=True):
        np.testing.assert_allclose(fine.poses[stop.at], path.path[told.at], atol=1e-12)


def test_a_hand_that_rests_goes_on_resting() -> None:
    path = coarse()
    fine = refine(path)
    still = np.flatnonzero(distance_between(path.path[1:], path.path[:-1]) < 1e-12)
    for k in still:
        inside = (fine.u_s >= path.t_s[k]) & (fine.u_s <= path.t_s[k + 1])
        assert distance_between(fine.poses[inside], path.path[k]).max() < 1e-12


def test_a_fine_path_gets_more_samples_only_where_it_is_free_and_short() -> None:
    path = pick_and_place(scene(), TABLE1[0])
    fine = refine(path)
    last = path.stops[-1].left_at
    np.testing.assert_allclose(fine.poses[: last + 1], path.path[: last + 1], atol=1e-15)
    assert fine.free_stretches()[-1][1] - fine.free_stretches()[-1][0] >= FREE_SAMPLES


def test_free_stretches_and_exact_ones_cover_the_path() -> None:
    fine = refine(coarse())
    covered = fine.constrained
    for first, last in fine.free_stretches():
        assert not fine.constrained[first + 1 : last].any()
        covered[first : last + 1] = True
    assert covered.all()
    assert len(fine.free_stretches()) == 3


def test_a_path_is_led_up_to_from_where_the_hand_is() -> None:
    fine = refine(coarse())
    hand = back(fine.poses[0], 0.05)
    led = joined(fine, hand)
    np.testing.assert_allclose(led.poses[0], hand, atol=1e-12)
    lead = len(led.u_s) - len(fine.u_s)
    np.testing.assert_array_equal(led.poses[lead:], fine.poses)
    assert [s.at - lead for s in led.stops] == [s.at for s in fine.stops]
    assert np.all(np.diff(led.u_s) > 0)
    assert joined(fine, fine.poses[0]) is fine


def test_relaxing_frees_the_departures_of_some_stops_only() -> None:
    fine = refine(coarse())
    grasp, release = relaxed(fine, ["release"]).stops
    assert grasp == fine.stops[0]
    assert (release.docking_at, release.at) == (fine.stops[1].docking_at, fine.stops[1].at)
    assert release.at <= release.left_at < fine.stops[1].left_at


def test_what_is_left_of_a_task_may_begin_within_a_stretch() -> None:
    path = coarse()
    stop = HandStop(5, "release", "block", "target", -20, 12)
    fine = refine(HandPath(path.t_s, path.path, path.gripper_m, path.primitive_at, (stop,)))
    assert fine.stops[0].docking_at == 0
    assert fine.constrained[0]
