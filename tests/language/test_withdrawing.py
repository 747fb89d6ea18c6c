from typing import Any

import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import act_to_json


def acts(text: str) -> list[dict[str, Any]]:
    return [act_to_json(act) for act in understand(text, Listening("practice")).acts]


UNDO = [{"act": "undo"}]


@pytest.mark.parametrize(
    "text",
    [
        "undo the 3 cm lower",
        "take back grip it 2 cm lower",
        "take back the 3 cm lower",
        "cancel the last two centimeters to the left please",
        "revert more left",
    ],
)
def test_a_correction_told_behind_a_verb_of_taking_back_is_taken_back(text: str) -> None:
    assert acts(text) == UNDO


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("take back 3 cm", {"act": "translate", "direction": "backward", "distance_m": 0.03}),
        ("take it back 3 cm", {"act": "translate", "direction": "backward", "distance_m": 0.03}),
    ],
)
def test_what_is_taken_back_by_a_measure_goes_back(text: str, act: dict[str, Any]) -> None:
    assert acts(text) == [act]
