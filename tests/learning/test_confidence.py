from __future__ import annotations

import numpy as np
import pytest

from assistant.learning.confidence import FEATURES, features, whole_features
from assistant.learning.reading import Understood, read
from assistant.learning.segmentation import _evidence, segment
from assistant.model.settings import SegmentationSettings
from tests.generators import generator_a, generator_b
from tests.generators.shown import Shown


def understood(shown: Shown) -> Understood:
    settings = SegmentationSettings()
    evidence = _evidence(shown.demonstration, shown.task, settings)
    return read(shown.demonstration, shown.task, evidence, settings)


@pytest.mark.parametrize("seed", range(4))
def test_each_cut_has_its_chance_whatever_the_lag(seed: int) -> None:
    found = understood(generator_b.generate(70_100 + seed))
    assert len(found.cut_chances) == len(found.reading.nodes) - 2
    assert all(0.0 <= chance <= 1.0 for chance in found.cut_chances)


def test_features_are_finite_with_and_without_cues() -> None:
    found = understood(generator_a.generate(70_101))
    for cues_s in (np.zeros(0), np.array([2.0, 5.0])):
        for node in found.reading.nodes[1:-1]:
            told = features(found, node, cues_s, seen=True)
            assert told.shape == (len(FEATURES),)
            assert np.all(np.isfinite(told))
        whole = whole_features(found, np.array([0.9, 0.8]), cues_s, seen=False)
        assert np.all(np.isfinite(whole))


def test_what_the_teacher_cut_is_not_doubted() -> None:
    shown = generator_a.generate(70_102)
    wrong_s = [cut + 0.7 for cut in shown.cuts_s]
    found = segment(shown.demonstration, shown.task, cuts_s=wrong_s)
    assert not [one for one in found.questions if one.reason == "unsure_cut"]


def test_rubbish_is_doubted() -> None:
    """Cues of another demonstration and a tree of another task leave no sure cuts."""
    shown, other = generator_b.generate(70_103), generator_a.generate(70_104)
    asked = segment(shown.demonstration, other.task).questions
    assert any(one.asked in ("missing_step", "confirm_segmentation") for one in asked)
