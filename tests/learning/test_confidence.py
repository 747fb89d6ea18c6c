from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from assistant.learning.confidence import FEATURES, features, whole_features
from assistant.learning.reading import Understood, read
from assistant.learning.segmentation import gathered, segment
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Subtask, primitives
from tests.generators import generator_a, generator_b
from tests.generators.shown import Shown


def understood(shown: Shown) -> Understood:
    settings = SegmentationSettings()
    evidence = gathered(shown.demonstration, shown.task, settings)
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
            told = features(found, node, cues_s)
            assert told.shape == (len(FEATURES),)
            assert np.all(np.isfinite(told))
        whole = whole_features(found, np.array([0.9, 0.8]), cues_s)
        assert np.all(np.isfinite(whole))


def test_what_the_teacher_cut_is_not_doubted() -> None:
    shown = generator_a.generate(70_102)
    wrong_s = [cut + 0.7 for cut in shown.cuts_s]
    found = segment(shown.demonstration, shown.task, cuts_s=wrong_s)
    assert not [one for one in found.questions if one.reason == "unsure_cut"]


@pytest.mark.parametrize("seed", range(70_103, 70_107))
def test_rubbish_is_doubted(seed: int) -> None:
    """Cues of another demonstration and the steps backwards leave no sure lesson."""
    shown, other = generator_b.generate(seed), generator_a.generate(seed)
    backwards = Subtask("backwards", tuple(reversed(primitives(shown.task.tree))))
    task = replace(shown.task, tree=backwards)
    demonstration = replace(shown.demonstration, cues=other.demonstration.cues)
    asked = segment(demonstration, task).questions
    assert any(one.asked in ("missing_step", "confirm_segmentation") for one in asked)


@pytest.mark.parametrize("generate", [generator_a.generate, generator_b.generate])
def test_a_lesson_is_no_surer_than_its_cuts(generate: Callable[[int], Shown]) -> None:
    """No reading is likelier as a whole than each of its cuts alone."""
    for seed in range(70_110, 70_113):
        found = understood(generate(seed))
        assert 0.0 <= found.whole_chance <= min(found.cut_chances) + 1e-9
