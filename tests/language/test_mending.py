from typing import Any

import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import act_to_json
from tests.language.heard_as import heard_as


@pytest.mark.parametrize(
    ("text", "stage", "acts"),
    [
        (
            "add spreading after cutting, no, I mean before cutting",
            "introduction",
            [{"act": "add_subtask", "name": "spreading", "before": "cutting"}],
        ),
        (
            "spreading ends at 6, correction, at 6.5 seconds",
            "learning",
            [{"act": "move_cut", "subtask": "spreading", "at_s": 6.5}],
        ),
        (
            "before cutting, sorry, after cutting, move up a little",
            "practice",
            [
                {
                    "act": "translate",
                    "direction": "up",
                    "degree": "little",
                    "where": {"subtask": "cutting", "when": "after"},
                }
            ],
        ),
        ("save it as breakfast, no, as brunch", "practice", [{"act": "save", "name": "brunch"}]),
        (
            "faster, sorry, slower I meant",
            "practice",
            [{"act": "adjust_speed", "change": "slower"}],
        ),
        ("more, er, less I mean", "practice", [{"act": "adjust_last", "change": "less"}]),
        (
            "left, no wait, right",
            "practice",
            [{"act": "translate", "direction": "right"}],
        ),
    ],
)
def test_what_was_taken_back_is_replaced(text: str, stage: Any, acts: list[dict[str, Any]]) -> None:
    meant = understand(text, Listening(stage=stage))
    assert [act_to_json(act) for act in meant.acts] == acts


def test_no_more_takes_nothing_back() -> None:
    meant = understand("five steps, no more, no less", Listening(asked="subtask_count"))
    assert [act_to_json(act) for act in meant.acts] == [{"act": "inform", "value": 5}]


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("1st stp", {"act": "cue", "which": "first"}),
        ("third stp", {"act": "cue", "which": 3}),
        ("stp 2", {"act": "cue", "which": 2}),
        ("stp", {"act": "stop"}),
        ("stp now", {"act": "stop"}),
    ],
)
def test_a_stop_in_a_hurry_is_a_step_where_it_is_counted(text: str, act: dict[str, Any]) -> None:
    meant = understand(text, Listening(stage="demonstration"))
    assert [act_to_json(one) for one in meant.acts] == [act]


@pytest.mark.parametrize("text", ["1st stp", "stp 2"])
def test_in_motion_it_stops_even_so(text: str) -> None:
    meant = understand(text, Listening(stage="practice", moving=True))
    assert [act_to_json(one) for one in meant.acts] == [{"act": "stop"}]


@pytest.mark.parametrize(
    ("text", "distance_m"), [("up two cm, wait, make it four", 0.04), ("up 5 mm, no, 3", 0.003)]
)
def test_a_number_that_replaces_another_keeps_its_unit(text: str, distance_m: float) -> None:
    assert heard_as(text) == [{"act": "translate", "direction": "up", "distance_m": distance_m}]
