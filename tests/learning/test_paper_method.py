from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.learning.candidates import Evidence, gather
from assistant.learning.paper_method import joint_probabilities, read_as_printed
from assistant.learning.smoothing import smooth
from assistant.learning.validity import validity
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.settings import paper
from assistant.model.task import Action, Primitive, Subtask, Task


def up_then_left() -> tuple[Demonstration, Evidence]:
    """Two reaches of 100 mm in two seconds each, with a rest of one second between."""
    t_s = np.arange(0.0, 5.0, 0.02)
    first, second = (np.clip((t_s - start) / 2.0, 0.0, 1.0) for start in (0.0, 3.0))
    path = np.zeros((len(t_s), 7))
    path[:, 2] = 0.1 * first**3 * (10.0 - 15.0 * first + 6.0 * first**2)
    path[:, 1] = 0.1 * second**3 * (10.0 - 15.0 * second + 6.0 * second**2)
    path[:, 6] = 1.0
    shown = Demonstration(Recording(t_s, path))
    return shown, gather(shown, smooth(shown.recording), paper())


def task_of(*ways: str) -> Task:
    leaves = tuple(Primitive(f"go {way}", Action("move", way)) for way in ways)
    return Task("t", Subtask("t", leaves))


def test_the_rest_between_two_reaches_is_the_cut() -> None:
    shown, evidence = up_then_left()
    found = read_as_printed(shown, task_of("up", "left"), evidence, paper())
    inner = [float(found.at_s[node]) for node in found.reading.nodes[1:-1]]
    assert inner == [pytest.approx(2.5, abs=0.15)]
    assert found.reading.taken == (0, 1)


def test_the_joint_probability_is_fit_times_validity() -> None:
    """Eq. (3): P(E, S) = P(S|E) P(E); the fits of one episode sum to one."""
    shown, evidence = up_then_left()
    nodes = np.array([0.0, 2.5, 4.98])
    joint = joint_probabilities(nodes, task_of("up", "left"), shown, evidence, paper())
    assert joint.shape == (2, 2)
    assert np.sum(joint[0]) == pytest.approx(validity(evidence, 0.0, 2.5, paper()))
    assert joint[0, 0] > joint[0, 1]
    assert joint[1, 1] > joint[1, 0]


def test_short_episodes_are_hardly_valid() -> None:
    _, evidence = up_then_left()
    assert validity(evidence, 0.0, 2.5, paper()) > 0.6
    assert validity(evidence, 2.1, 2.2, paper()) < 0.05
    assert validity(evidence, 1.0, 1.0, paper()) == 0.0


def test_equal_neighbors_are_one_primitive() -> None:
    shown, evidence = up_then_left()
    found = read_as_printed(shown, task_of("up"), evidence, paper())
    assert found.reading.nodes == (0, len(found.at_s) - 1)


def test_validity_thresholds_are_settings() -> None:
    _, evidence = up_then_left()
    given = paper()
    strict = replace(given, validity=replace(given.validity, least_s=5.0))
    assert validity(evidence, 0.0, 2.5, strict) < validity(evidence, 0.0, 2.5, given)
