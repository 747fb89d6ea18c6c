"""What the physics does with the pads while the hand turns."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from assistant.geometry import IDENTITY, Array, compose, quat_from_rotvec
from sim.bullet_world import LATER_TICKS, BulletWorld
from sim.kinematics import forward
from sim.world import Allowed
from tests.sim.placing import lesson


@pytest.mark.parametrize(
    ("each_deg", "turning", "still", "renewed"),
    [(0.0, 0, 20, 0), (0.25, 10, 0, 0), (0.25, 10, 10, 1), (0.25, 30, 10, 3), (0.03, 10, 10, 0)],
)
def test_contacts_are_found_anew_on_a_hand_that_turned_far_or_has_come_to_rest(
    monkeypatch: pytest.MonkeyPatch, each_deg: float, turning: int, still: int, renewed: int
) -> None:
    pads: list[int] = []

    def forget(self: BulletWorld, which: Sequence[int]) -> None:
        pads.extend(which)

    world = BulletWorld()
    _, scene, _ = lesson()
    q = np.array([0.0, 0.0, np.pi / 2, 0.0, 0.0, 0.0])
    world.arrange(scene, {}, q)
    monkeypatch.setattr(BulletWorld, "_forget", forget)
    for k in range(turning + still):
        world.step(q, _turned(forward(q), min(k + 1, turning) * each_deg), 0.08, Allowed())
    for _ in range(LATER_TICKS if still else 0):
        world.step(q, _turned(forward(q), turning * each_deg), 0.08, Allowed())
    world.close()
    assert len(pads) == 2 * renewed


def test_steps_are_done_in_parts_only_while_the_hand_has_to_do_with_a_body() -> None:
    world = BulletWorld()
    _, scene, _ = lesson()
    q = np.array([0.0, 0.0, np.pi / 2, 0.0, 0.0, 0.0])
    world.arrange(scene, {}, q)
    parts = []
    for grasped in ("", "block", ""):
        world.step(q, forward(q), 0.08, Allowed(grasped))
        parts.append(world._client.getPhysicsEngineParameters()["numSubSteps"])
    world.close()
    assert parts == [1, world.settings.parts, 1]


def _turned(hand: Array, degrees: float) -> Array:
    turn = np.array(IDENTITY)
    turn[3:] = quat_from_rotvec(np.array([0.0, 0.0, np.deg2rad(degrees)]))
    return compose(hand, turn)
