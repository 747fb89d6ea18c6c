from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.geometry import IDENTITY, Array, pose_from_mm_deg
from assistant.learning.docking import level, straightened
from assistant.learning.lesson import learn
from assistant.model.demonstration import Demonstration
from assistant.model.scene import Body, Scene
from assistant.model.settings import GeneralizationSettings
from tests.learning.lessons import CUTS_S, demonstration, sliding_in, task

NEAR_M = GeneralizationSettings().docking_near_m


def above(shown: Demonstration, stands: bool) -> Array:
    """Return the way from docking to release, seen from its end, of what was taught."""
    bodies = {name: Body(name, size_mm=(60.0, 40.0, 20.0)) for name in ("block", "target")}
    if not stands:
        shown = replace(shown, setup=replace(shown.setup, places={}))
    made = learn([shown], task(), cuts_s=CUTS_S, scene=Scene(bodies=bodies))
    assert made.path is not None
    release = made.stations[1]
    way = made.path.path[release.docking_at : release.at + 1, :3]
    return np.asarray(way - way[-1])


@pytest.mark.parametrize("stands", [True, False])
def test_what_a_hand_from_above_puts_down_is_docked_from_above(stands: bool) -> None:
    """Also where the target had no place: it is not leant over with the hand."""
    shown = demonstration()
    path = shown.recording.path.copy()
    path[:, 3:] = pose_from_mm_deg((0.0, 0.0, 0.0), (0.0, 90.0, 0.0))[3:]
    if stands:
        told = {
            name: replace(one, rpy_deg=(0.0, 0.0, 0.0)) for name, one in shown.setup.places.items()
        }
        shown = replace(shown, setup=replace(shown.setup, places=told))
    way = above(replace(shown, recording=replace(shown.recording, path=path)), stands)
    assert np.max(np.abs(way[:, :2])) < 1e-9
    assert way[0, 2] > NEAR_M


def test_what_slid_in_from_the_side_is_put_down_from_above() -> None:
    way = above(sliding_in(), True)
    assert np.max(np.abs(way[:, :2])) < 1e-9
    assert way[0, 2] == pytest.approx(NEAR_M)
    assert np.all(np.diff(way[:, 2]) <= 1e-9)


def test_the_way_led_up_goes_on_smoothly() -> None:
    path = np.tile(IDENTITY, (201, 1))
    path[:, 0] = np.linspace(-0.4, 0.0, 201)
    upward = np.array([[0.0, 0.0, 1.0]])
    led = straightened(path, 200, 120, upward, 0, 0.1, NEAR_M)
    assert np.array_equal(led[:60], path[:60])
    assert np.array_equal(led[200], path[200])
    assert led[120, 2] == pytest.approx(NEAR_M)
    assert np.max(np.abs(np.diff(led[:, 2], n=2))) < 4e-5


@pytest.mark.parametrize("high_m", [0.02, -0.02])
def test_what_comes_from_above_or_below_is_not_led_elsewhere(high_m: float) -> None:
    path = np.tile(IDENTITY, (201, 1))
    path[:, 2] = high_m * np.linspace(2.0, 0.0, 201)
    upward = np.array([[0.0, 0.0, 1.0]])
    assert np.allclose(straightened(path, 200, 100, upward, 0, 0.1, NEAR_M), path, atol=1e-12)


@pytest.mark.parametrize("yaw_deg", [0.0, 40.0, -170.0])
@pytest.mark.parametrize("pitch_deg", [0.0, 45.0, 90.0])
def test_what_a_leaning_hand_meets_stands_upright(yaw_deg: float, pitch_deg: float) -> None:
    hand = pose_from_mm_deg((0.0, 0.0, 0.0), (0.0, pitch_deg, yaw_deg))
    turned = pose_from_mm_deg((0.0, 0.0, 0.0), (0.0, 0.0, yaw_deg))[3:]
    assert abs(float(level(hand) @ turned)) == pytest.approx(1.0)
