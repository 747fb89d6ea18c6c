"""What is told of the hand when the arm is halted."""

from __future__ import annotations

import numpy as np
import pytest

from assistant.model.motion import ArmReport
from assistant.model.scene import Body, Obstacle, Scene
from assistant.ports import ArmLook
from assistant.session.holding import with_held

SCENE = Scene(
    bodies={"block": Body("block"), "stand": Body("stand", size_mm=(80.0, 80.0, 50.0))},
    tables=(Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0)),),
)


def at(x_m: float, z_m: float) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    return np.array([x_m, 0.0, z_m, 0.0, 0.0, 0.0, 1.0])


def look(held: str, x_m: float = 0.5, stand_m: float = 0.9) -> ArmLook:
    bodies = {"block": at(x_m, 0.34), "stand": at(stand_m, 0.24)}
    return ArmLook(np.zeros(6), at(0.4, 0.4), 0.05, held, bodies, False, 1.0)


HALTED = ArmReport("halted", 1.0, 2, "stop")


UNMET = ArmReport("unmet", 1.0, 2, "docked", "target", when="until")


def told(report: ArmReport, look: ArmLook, scene: Scene = SCENE) -> ArmReport:
    return with_held((report,), look, scene)[-1]


def test_the_height_is_above_the_table_or_the_body_below() -> None:
    assert told(HALTED, look("block")).height_mm == pytest.approx(100.0)
    above = told(HALTED, look("block", stand_m=0.52))
    assert above.object == "block"
    assert above.height_mm == pytest.approx(50.0)


def test_after_an_unmet_condition_what_is_held_follows() -> None:
    first, second = with_held((UNMET,), look("block"), SCENE)
    assert first is UNMET
    assert (second.kind, second.object) == ("halted", "block")
    assert second.height_mm == pytest.approx(100.0)


def test_an_empty_hand_is_no_height() -> None:
    assert told(HALTED, look("")) is HALTED
    assert told(UNMET, look("")).object == ""


def test_nothing_known_below_is_no_height() -> None:
    bare = Scene(bodies=SCENE.bodies)
    assert told(HALTED, look("block"), bare).height_mm is None
