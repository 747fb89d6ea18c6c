from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.geometry import Array
from assistant.learning.candidates import Evidence
from assistant.learning.parting import only_leaves, with_leaving
from assistant.learning.segmentation import gathered, segment
from assistant.model.demonstration import Demonstration
from assistant.model.lesson import Episode, SegmentationPoint
from assistant.model.settings import SegmentationSettings
from tests.learning import lessons

OPENED_S, END_S = 14.0, 16.0
SILENT = np.zeros(0)


def leaving(way_m: tuple[float, float, float]) -> Demonstration:
    """Return the made demonstration with another way off after the release."""
    shown = lessons.demonstration()
    t_s, path = shown.recording.t_s, shown.recording.path.copy()
    gone = t_s > 14.5
    share = np.sin(0.5 * np.pi * np.clip((t_s[gone] - 14.5) / 1.5, 0.0, 1.0)) ** 2
    path[gone, :3] = path[~gone][-1, :3] + share[:, None] * np.array(way_m)
    return replace(shown, recording=replace(shown.recording, path=path))


def evidence(shown: Demonstration) -> Evidence:
    return gathered(shown, lessons.task(), SegmentationSettings())


@pytest.mark.parametrize("way_m", [(0.0, 0.0, 0.1), (-0.08, 0.0, 0.0), (0.0, 0.1, 0.1)])
def test_a_short_way_off_is_no_step_whatever_its_direction(
    way_m: tuple[float, float, float],
) -> None:
    """A hand from above goes up when all is done; that was asked about as a step of its own."""
    found = segment(leaving(way_m), lessons.task())
    assert "never_introduced" not in {one.reason for one in found.questions}
    assert found.episodes[-1].primitive is not None
    assert found.episodes[-1].to_s == END_S


@pytest.mark.parametrize(
    ("way_m", "from_s", "to_s", "cues_s"),
    [
        ((0.0, 0.0, 0.1), OPENED_S, END_S, np.array([14.0])),
        ((0.0, 0.0, 0.1), 12.0, END_S, SILENT),
        ((0.0, 0.0, 0.1), OPENED_S, 15.0, SILENT),
        ((0.0, -0.3, 0.0), OPENED_S, END_S, SILENT),
    ],
    ids=["told by a cue", "with the release", "not the last", "far"],
)
def test_what_may_be_a_step_is_not_taken_for_leaving(
    way_m: tuple[float, float, float], from_s: float, to_s: float, cues_s: Array
) -> None:
    known = evidence(leaving(way_m))
    assert not only_leaves(known, from_s, to_s, cues_s)
    assert only_leaves(evidence(leaving((0.0, 0.0, 0.1))), OPENED_S, END_S, np.array([9.0]))


def test_a_hand_that_holds_something_or_was_not_recorded_does_not_leave() -> None:
    shown = leaving((0.0, 0.0, 0.1))
    bare = replace(shown, recording=replace(shown.recording, gripper_m=None))
    assert not only_leaves(evidence(bare), OPENED_S, END_S, SILENT)
    closed = np.interp(shown.recording.t_s, [5.85, 6.15], [0.08, 0.04])
    held = replace(shown, recording=replace(shown.recording, gripper_m=closed))
    assert not only_leaves(evidence(held), OPENED_S, END_S, SILENT)


def test_points_and_episodes_stay_in_step() -> None:
    points = tuple(SegmentationPoint(at, 0.9, {}) for at in (6.0, OPENED_S))
    parts = (
        Episode(0.0, 6.0, "take", 1.0, ""),
        Episode(6.0, OPENED_S, "put", 1.0, ""),
        Episode(OPENED_S, END_S, None, 1.0, ""),
    )
    known = evidence(leaving((0.0, 0.0, 0.1)))
    marked, left = with_leaving(known, points, parts, SILENT)
    assert [point.internal for point in marked] == [False, True]
    assert [(one.primitive, one.to_s) for one in left] == [("take", 6.0), ("put", END_S)]
    assert with_leaving(known, points, parts, np.array([14.0])) == (points, parts)
