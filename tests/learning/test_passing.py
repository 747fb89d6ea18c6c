from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import Array
from assistant.learning.candidates import Candidate, Evidence, gather
from assistant.learning.passing import bends, passed, slowness, veers
from assistant.learning.smoothing import smooth
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.settings import SegmentationSettings


def corner(turn_rad: float) -> Evidence:
    """Go on for 2 s, rest for 1 s at (0.2, 0, 0), go on for 2 s turned by an angle."""
    t_s = np.arange(0.0, 5.0, 0.02)
    out, on = np.clip(t_s / 2.0, 0.0, 1.0), np.clip((t_s - 3.0) / 2.0, 0.0, 1.0)
    out, on = (share**2 * (3.0 - 2.0 * share) for share in (out, on))
    path = np.zeros((len(t_s), 7))
    path[:, 0] = 0.2 * out + 0.2 * np.cos(turn_rad) * on
    path[:, 1] = 0.2 * np.sin(turn_rad) * on
    path[:, 6] = 1.0
    shown = Demonstration(Recording(t_s, path))
    return gather(shown, smooth(shown.recording), SegmentationSettings())


MIDDLE: Array = np.array([2.5])


@pytest.mark.parametrize(("turn_rad", "told"), [(0.0, 0.0), (np.pi / 2, 0.5), (np.pi, 1.0)])
def test_a_corner_is_told_over_a_way_and_over_a_while(turn_rad: float, told: float) -> None:
    smoothed = corner(turn_rad).smoothed
    assert bends(MIDDLE, smoothed)[0] == pytest.approx(told, abs=0.08)
    assert veers(MIDDLE, np.array([0.5]), 1.0, smoothed)[0] == pytest.approx(told, abs=0.08)


def test_a_rest_is_slower_than_a_motion() -> None:
    slow = slowness(np.array([1.0, 2.5]), corner(0.0))
    assert slow[0] < 0.0 < 1.0 < slow[1]


def test_instants_that_were_only_heard_are_told_as_well() -> None:
    evidence = corner(np.pi / 2)
    (heard,) = passed((Candidate(2.5, heard=True),), evidence, 2.5)
    assert heard.heard
    assert heard.slow > 1.0
    assert heard.veer > 0.2
    assert passed((), evidence, 2.5) == ()
