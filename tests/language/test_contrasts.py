from typing import Any

import pytest

from tests.language.heard_as import heard_as

LEFT = {"act": "translate", "direction": "left"}


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("left, not right", [LEFT]),
        ("not to the right but to the left, and indeed by 6 mm", [{**LEFT, "distance_m": 0.006}]),
        ("no, ten mil, not ten centimetres, left", [{**LEFT, "distance_m": 0.01}]),
        ("left a bit, not a lot", [{**LEFT, "degree": "little"}]),
        ("left instead of right", [LEFT]),
    ],
)
def test_what_is_ruled_out_is_left_out(text: str, told: list[dict[str, Any]]) -> None:
    assert heard_as(text) == told


@pytest.mark.parametrize(
    "text",
    ["no, I said left", "no. left, not right", "ah no, what I had in mind was left", "nope, left",
     "not this, I mean left", "rubbish, left"],
)  # fmt: skip
def test_a_no_keeps_what_is_wanted_instead(text: str) -> None:
    assert heard_as(text, "did_you_mean") == [{"act": "deny"}, LEFT]


@pytest.mark.parametrize("text", ["no, stop", "no stop"])
def test_a_stop_behind_a_no_is_a_stop_alone(text: str) -> None:
    assert heard_as(text, "satisfied") == [{"act": "stop"}]
