from typing import Any

import pytest

from tests.language.heard_as import heard_as


@pytest.mark.parametrize(
    ("text", "body", "by_mm"),
    [
        ("the vase has slid three centimetres forward", "vase", [30.0, 0.0, 0.0]),
        ("somebody bumped the tray two inches back", "tray", [-50.8, 0.0, 0.0]),
        ("my colleague nudged the kettle 1 cm to the right", "kettle", [0.0, -10.0, 0.0]),
        ("the kettle's five millimetres higher now", "kettle", [0.0, 0.0, 5.0]),
        ("the lid, I moved it 2 cm to the left", "lid", [0.0, 20.0, 0.0]),
        ("the tray was put 3 cm further back and 2 cm to the left", "tray", [-30.0, 20.0, 0.0]),
        ("push the kettle ten centimetres forward in your layout", "kettle", [100.0, 0.0, 0.0]),
    ],
)
def test_a_body_that_stands_elsewhere_is_set(text: str, body: str, by_mm: list[float]) -> None:
    assert heard_as(text) == [{"act": "set_pose", "object": body, "by_mm": by_mm}]


@pytest.mark.parametrize(
    ("text", "direction", "distance_m"),
    [
        ("the gripper is 2 cm too low", "up", 0.02),
        ("the block is 5 mm too far left", "right", 0.005),
        ("the hand is two centimetres further left now", "left", 0.02),
        ("the lid should be 1 cm higher", "up", 0.01),
    ],
)
def test_what_the_hand_does_or_should_is_a_correction(
    text: str, direction: str, distance_m: float
) -> None:
    assert heard_as(text) == [
        {"act": "translate", "direction": direction, "distance_m": distance_m}
    ]


@pytest.mark.parametrize(
    ("text", "position_mm"),
    [
        ("the lid is at three hundred and ninety, one hundred and fifty, twenty", [390, 150, 20]),
        ("lid: four ten, forty, two ten", [410, 40, 210]),
        ("lid now in position five five zero, minus eight zero, two one zero", [550, -80, 210]),
        ("the lid is at four hundred one hundred two hundred", [400, 100, 200]),
        ("the lid is in 450 comma 20 comma 80", [450, 20, 80]),
    ],
)
def test_numbers_of_a_place_end_where_marks_stand(text: str, position_mm: list[Any]) -> None:
    told = {"act": "set_pose", "object": "lid", "position_mm": [float(x) for x in position_mm]}
    assert heard_as(text, "pose") == [told]
