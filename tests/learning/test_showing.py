from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.learning.segmentation import segment
from assistant.learning.showing import shown_part
from assistant.model.demonstration import Demonstration, Recording, Spoken
from assistant.model.settings import SegmentationSettings
from tests.generators import generator_a, generator_b
from tests.generators.shown import Shown

GIVEN = SegmentationSettings()
SHOWN = generator_a.generate(70_000)


def waited(shown: Demonstration, before_s: float, after_s: float, tremor_m: float) -> Demonstration:
    """Return a demonstration whose hand waits before it begins and after it has ended."""
    t_s, path, gripper_m = shown.recording.t_s, shown.recording.path, shown.recording.gripper_m
    assert gripper_m is not None
    step_s = float(np.median(np.diff(t_s)))
    ahead, behind = (round(wait_s / step_s) for wait_s in (before_s, after_s))
    at = np.clip(np.arange(-ahead, len(t_s) + behind), 0, len(t_s) - 1)
    times = np.concatenate(
        [
            t_s[0] + step_s * np.arange(ahead),
            t_s + step_s * ahead,
            t_s[-1] + step_s * (ahead + 1 + np.arange(behind)),
        ]
    )
    rests = (np.arange(len(at)) < ahead) | (np.arange(len(at)) >= ahead + len(t_s))
    path = path[at].copy()
    noise = tremor_m * np.random.default_rng(1).normal(size=(len(at), 3))
    path[:, :3] += np.where(rests[:, None], noise, 0.0)
    cues = tuple(replace(cue, at_s=cue.at_s + step_s * ahead) for cue in shown.cues)
    return replace(shown, recording=Recording(times, path, gripper_m[at]), cues=cues)


@pytest.mark.parametrize("shown", [SHOWN, generator_b.generate(70_001, "keys")])
def test_who_waits_before_and_after_is_cut_at_the_same_places(shown: Shown) -> None:
    plain = segment(shown.demonstration, shown.task)
    late = waited(shown.demonstration, 40.0, 30.0, 1e-4)
    found = segment(late, shown.task)
    assert np.array(found.cuts_s) - 40.0 == pytest.approx(np.array(plain.cuts_s), abs=0.05)
    assert [one.primitive for one in found.episodes] == [one.primitive for one in plain.episodes]
    assert found.episodes[0].from_s == late.recording.t_s[0]
    assert found.episodes[-1].to_s == late.recording.t_s[-1]


def test_words_before_the_hand_moves_and_long_after_it_has_come_to_rest_tell_no_cut() -> None:
    waits = waited(SHOWN.demonstration, 20.0, 10.0, 0.0)
    end_s = float(waits.recording.t_s[-1])
    before = (Spoken(-3.0, "so"), Spoken(5.0, "look"), Spoken(19.0, "first step"))
    after = (Spoken(end_s, "that was it"), Spoken(end_s + 60.0, "well"))
    said = segment(replace(waits, cues=(*before, *waits.cues, *after)), SHOWN.task)
    silent = segment(waits, SHOWN.task)
    assert said.cuts_s == silent.cuts_s
    assert said.cue_lag_s == silent.cue_lag_s


def test_a_word_heard_twice_at_once_was_said_once() -> None:
    twice = tuple(cue for cue in SHOWN.demonstration.cues for _ in range(2))
    shown = shown_part(replace(SHOWN.demonstration, cues=twice), GIVEN)
    assert shown.cues == SHOWN.demonstration.cues
    backward = replace(SHOWN.demonstration, cues=SHOWN.demonstration.cues[::-1])
    assert segment(backward, SHOWN.task).cuts_s == segment(SHOWN.demonstration, SHOWN.task).cuts_s


def test_a_hand_that_acts_while_it_waits_is_not_left_out() -> None:
    waits = waited(SHOWN.demonstration, 20.0, 0.0, 0.0)
    gripper_m = np.array(waits.recording.gripper_m)
    gripper_m[(waits.recording.t_s > 5.0) & (waits.recording.t_s < 8.0)] = np.min(gripper_m)
    acts = replace(waits, recording=replace(waits.recording, gripper_m=gripper_m))
    assert 3.0 < shown_part(acts, GIVEN).recording.t_s[0] < 5.0


def test_a_demonstration_without_waits_and_one_without_motion_stay_the_very_same() -> None:
    shown = shown_part(SHOWN.demonstration, GIVEN)
    assert shown_part(shown, GIVEN) is shown
    still = replace(shown.recording, path=np.repeat(shown.recording.path[:1], 10, axis=0))
    still = replace(still, t_s=shown.recording.t_s[:10], gripper_m=None)
    bare = replace(shown, recording=still, cues=())
    assert shown_part(bare, GIVEN) is bare
    once = replace(still, t_s=np.zeros(10))
    assert shown_part(replace(bare, recording=once), GIVEN).recording is once
