from typing import Any

import pytest

from tests.language.heard_as import heard_as

UP = {"act": "translate", "direction": "up", "distance_m": 0.02}
SLOWER = {"act": "adjust_speed", "change": "slower"}


@pytest.mark.parametrize(
    ("text", "act", "subtask", "when"),
    [
        ("after hook up 2 cm straight up", UP, "hook up", "after"),
        ("2 cm up once you've twisted it", UP, "twisted it", "after"),
        ("after you have done the dunk it step, 2 cm up", UP, "dunk it", "after"),
        ("the moment you let go, rise two centimetres", UP, "let go", "after"),
        ("for the dunk part, two centimetres up", UP, "dunk", "during"),
        ("in the swirl go slower", SLOWER, "swirl", "during"),
        ("slower as it swirls", SLOWER, "swirls", "during"),
        ("when you, er, during the, the dunk, um, slower", SLOWER, "dunk", "during"),
        ("after wiping has been done, slower", SLOWER, "wiping", "after"),
        ("once swing over is done, slower", SLOWER, "swing over", "after"),
        ("before dunk, not after, slower", SLOWER, "dunk", "before"),
    ],
)
def test_a_correction_may_say_where_it_belongs(
    text: str, act: dict[str, Any], subtask: str, when: str
) -> None:
    assert heard_as(text) == [{**act, "where": {"subtask": subtask, "when": when}}]


@pytest.mark.parametrize(
    "text", ["that was rather too fast for my liking", "too fast for my taste", "slower in general"]
)
def test_not_all_that_follows_such_a_word_is_a_step(text: str) -> None:
    assert heard_as(text) == [SLOWER]
