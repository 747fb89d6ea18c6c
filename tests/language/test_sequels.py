from typing import Any

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import act_to_json


def acts(text: str) -> list[dict[str, Any]]:
    return [act_to_json(act) for act in understand(text, Listening("practice")).acts]


CLOSE = {"act": "gripper", "command": "close"}
LEFT = {"act": "translate", "direction": "left"}


def test_after_this_points_back_at_the_clause_before_it() -> None:
    assert acts("close the hand, after this move left") == [CLOSE, LEFT]
    assert acts("close the hand and after that move left") == [CLOSE, LEFT]


def test_after_a_step_says_where_a_correction_belongs() -> None:
    where = {"subtask": "the dunk", "when": "after"}
    told = acts("after the dunk, move left")
    assert told in ([{**LEFT, "where": where}], [{**LEFT, "where": {**where, "subtask": "dunk"}}])
