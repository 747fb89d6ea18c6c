"""A stretch of a demonstration shown again takes the old one's place."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.geometry import Array, distance_between
from assistant.learning.splicing import NEAR_M, Apart, Spliced, spliced
from assistant.model.demonstration import Demonstration, Recording, Spoken

STEP_S = 0.02
FROM_S, TO_S = 2.0, 5.0
OPEN_M, SHUT_M = 0.08, 0.04


def line(t_s: Array, speed_m_s: float = 0.05) -> Array:
    """Return poses of a hand that goes ahead at one speed."""
    path = np.zeros((len(t_s), 7))
    path[:, 0], path[:, 6] = speed_m_s * t_s, 1.0
    return path


def whole(closes_s: float = 6.0) -> Demonstration:
    """Return ten seconds of a hand that goes ahead, and closes."""
    t_s = np.arange(501.0) * STEP_S
    opening = np.where(t_s < closes_s, OPEN_M, SHUT_M)
    cues = (Spoken(0.2, "first step"), Spoken(2.3, "then"), Spoken(4.0, "so"), Spoken(5.3, "next"))
    return Demonstration(Recording(t_s, line(t_s), opening), cues)


def again(seconds: float = 6.0, bump_m: float = 0.05, off_m: float = 0.0) -> Demonstration:
    """Return the stretch at another pace, around a bump, begun and ended a little beside it."""
    t_s = np.arange(float(int(seconds / STEP_S) + 1)) * STEP_S
    path = line(FROM_S + (TO_S - FROM_S) * t_s / t_s[-1])
    path[:, 2] = bump_m * np.sin(np.pi * t_s / t_s[-1]) ** 2
    path[:, 1] = off_m
    return Demonstration(Recording(t_s, path, np.full(len(t_s), OPEN_M)))


def done(old: Demonstration, new: Demonstration) -> Spliced:
    found = spliced(old, FROM_S, TO_S, new)
    assert isinstance(found, Spliced)
    return found


@settings(max_examples=25)
@given(seconds=st.floats(1.0, 9.0), off_mm=st.floats(0.0, 40.0), bump_mm=st.floats(0.0, 90.0))
def test_the_rest_is_kept_and_nothing_leaps(seconds: float, off_mm: float, bump_mm: float) -> None:
    old = whole().recording
    found = done(whole(), again(seconds, bump_mm / 1000.0, off_mm / 1000.0))
    new, moved_s = found.demonstration.recording, found.to_s - TO_S
    first, last = int(FROM_S / STEP_S), int(TO_S / STEP_S)
    assert new.path[:first].tobytes() == old.path[:first].tobytes()
    assert new.path[-(500 - last) :].tobytes() == old.path[last + 1 :].tobytes()
    assert np.diff(new.t_s).min() > 0.0
    assert new.t_s[-1] == pytest.approx(old.t_s[-1] + moved_s)
    strides = distance_between(new.path[1:], new.path[:-1])
    shown = again(seconds, bump_mm / 1000.0).recording.path
    fastest = distance_between(shown[1:], shown[:-1]).max()
    # A way that leads on is at most twice as fast in its middle as the hand was in the mean.
    assert strides.max() < max(fastest, 0.001 * 2.1) + 1e-9
    assert new.path[:, 2].max() == pytest.approx(bump_mm / 1000.0, abs=1e-3)


@pytest.mark.parametrize("power", [1, 3])
def test_the_same_shown_again_changes_nothing(power: int) -> None:
    old = whole().recording
    # However fast the hand is at a joint.
    path = line(10.0 * (old.t_s / 10.0) ** power)
    known = Demonstration(Recording(old.t_s, path, np.full(501, OPEN_M)))
    inside = slice(int(FROM_S / STEP_S), int(TO_S / STEP_S) + 1)
    part = Recording(old.t_s[inside] - 2.0, path[inside], np.full(151, OPEN_M))
    found = done(known, Demonstration(part))
    assert found.to_s == pytest.approx(TO_S)
    np.testing.assert_allclose(found.demonstration.recording.t_s, old.t_s, atol=1e-9)
    np.testing.assert_array_equal(found.demonstration.recording.path, path)


def test_of_a_whole_showing_only_the_stretch_is_taken() -> None:
    found = done(whole(), whole())
    assert found.to_s == pytest.approx(TO_S, abs=0.05)
    np.testing.assert_allclose(found.demonstration.recording.path, whole().recording.path)


def test_cues_move_along_and_the_one_that_begins_the_stretch_stays() -> None:
    found = done(whole(), again(6.0))
    said = {cue.say: cue.at_s for cue in found.demonstration.cues}
    assert said["first step"] == 0.2
    assert said["then"] == 2.3
    assert said["next"] == pytest.approx(5.3 + found.to_s - TO_S)


@pytest.mark.parametrize(("off_m", "fits"), [(0.9 * NEAR_M, True), (1.1 * NEAR_M, False)])
def test_what_begins_elsewhere_does_not_fit(off_m: float, fits: bool) -> None:
    found = spliced(whole(), FROM_S, TO_S, again(off_m=off_m))
    assert isinstance(found, Spliced) is fits
    if isinstance(found, Apart):
        assert found.end == "begins"
        assert found.away_mm == pytest.approx(1000.0 * off_m)


def test_a_hand_that_ends_closed_where_it_was_open_does_not_fit() -> None:
    shown = again().recording
    closed = Recording(shown.t_s, shown.path, np.where(shown.t_s < 1.0, OPEN_M, SHUT_M))
    found = spliced(whole(closes_s=9.0), FROM_S, TO_S, Demonstration(closed))
    assert isinstance(found, Apart)
    assert found.end == "ends"


def test_a_hand_that_acts_beside_a_cut_acts_once() -> None:
    shown = again().recording
    closing = Recording(shown.t_s, shown.path, np.where(shown.t_s < 5.8, OPEN_M, SHUT_M))
    # In the whole the hand closed just behind the cut, now just before it.
    found = done(whole(closes_s=TO_S + 0.2), Demonstration(closing))
    opening = found.demonstration.recording.gripper_m
    assert opening is not None
    assert np.count_nonzero(np.diff(opening)) == 1


def test_without_a_hand_recorded_the_place_alone_counts() -> None:
    shown = again().recording
    found = done(whole(), Demonstration(Recording(shown.t_s, shown.path)))
    assert found.demonstration.recording.gripper_m is None
