from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.geometry import (
    angle_between,
    distance_between,
    relative,
    transform_points,
)
from assistant.learning.adaptation import (
    adapt,
    frames_in,
    plan_adaptation,
)
from assistant.model.feedback import Feedback
from tests.learning.lessons import (
    SCENE,
    SHOWN,
    errors,
    learned,
    lesson,
    moved,
)


def nudge(primitive: str, offset_m: tuple[float, float, float], frame: str = "") -> Feedback:
    return Feedback("translate", "a bit more", primitive, frame=frame, offset_m=offset_m)


def test_a_correction_at_the_target_moves_with_it() -> None:
    corrected = plan_adaptation(learned([nudge("place object", (0.0, 0.005, 0.0), "target")]))
    plain = plan_adaptation(learned())
    for seed in range(3):
        setup = moved(np.random.default_rng(seed))
        here, there = (adapt(plan, SCENE, setup).path for plan in (plain, corrected))
        frame = frames_in(plain, SCENE, setup)[1]
        one = plain.stations[1]
        shift = relative(frame, there[one.at]) - relative(frame, here[one.at])
        assert np.allclose(shift[:3], (0.0, 0.005, 0.0), atol=1e-12)
        # The whole stretch goes along, so its shape is kept; the grasp stays.
        held = slice(plain.ways.held[2][0], one.at)
        moved_by = relative(frame, there[held]) - relative(frame, here[held])
        assert np.allclose(moved_by[:, :3], (0.0, 0.005, 0.0), atol=1e-12)
        grasp = plain.stations[0].at
        assert distance_between(here[grasp], there[grasp]) < 1e-12


def test_turning_keeps_the_tool_where_it_is() -> None:
    turn = Feedback("rotate", "turn left", "grasp object", frame="block", turn_rad=(0, 0, 0.1))
    here, there = (
        adapt(plan_adaptation(learned(given)), SCENE, SHOWN).path for given in ((), (turn,))
    )
    at = lesson().stations[0].at
    assert angle_between(here[at], there[at]) == pytest.approx(0.1)
    tip = np.array([0.1341, 0.0, 0.0])
    assert np.allclose(transform_points(here[at], tip), transform_points(there[at], tip))


def test_a_correction_of_a_free_way_leaves_grasp_and_release_exact() -> None:
    plan = plan_adaptation(learned([nudge("move up object", (0.0, 0.0, 0.02))]))
    path = adapt(plan, SCENE, SHOWN)
    plain = adapt(plan_adaptation(learned()), SCENE, SHOWN)
    lift = path.path[:, 2] - plain.path[:, 2]
    assert np.max(lift) == pytest.approx(0.02, rel=1e-3)
    assert max(errors(plan, path, SHOWN)) < 1e-9


def test_speed_of_one_primitive_and_of_all() -> None:
    plain = adapt(plan_adaptation(learned()), SCENE, SHOWN)
    one = Feedback("speed", "slower", "move down", factor=0.5)
    slow = adapt(plan_adaptation(learned([one])), SCENE, SHOWN)
    inside = np.flatnonzero(plain.primitive_at == 3)[20:-20]
    before, after = (np.diff(path.t_s)[inside] for path in (plain, slow))
    assert np.allclose(after, 2.0 * before, rtol=0.01)
    assert np.allclose(np.diff(slow.t_s)[:100], np.diff(plain.t_s)[:100], rtol=0.01)
    whole = adapt(plan_adaptation(learned([replace(one, primitive="")])), SCENE, SHOWN)
    assert whole.t_s[-1] == pytest.approx(2.0 * plain.t_s[-1], rel=1e-3)


def test_a_spoken_command_to_the_hand_is_carried_out() -> None:
    opened = Feedback("hand", "open the hand", "approach object", "before", hand="open")
    closed = replace(opened, hand="close", primitive="place object", when="after")
    path = adapt(plan_adaptation(learned([opened, closed])), SCENE, SHOWN)
    assert path.gripper_m[0] == np.max(path.gripper_m)
    assert path.gripper_m[-1] == np.min(path.gripper_m)
