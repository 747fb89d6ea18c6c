from typing import Any

import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import act_to_json


@pytest.mark.parametrize(
    ("text", "stage", "asked", "act"),
    [
        ("rdy", "demonstration", "ready", {"act": "affirm"}),
        ("go home", "introduction", None, {"act": "unknown"}),
        ("Yes, you may leave it out", "introduction", "optional", {"act": "affirm"}),
        ("let go of it", "introduction", "subtask_name",
         {"act": "inform", "value": "let go of it"}),
        ("stop before placing", "practice", None, {"act": "unknown"}),
        ("stop before step three", "practice", None, {"act": "unknown"}),
        ("stop before you hit it", "practice", None, {"act": "stop"}),
        ("faster, too slow", "practice", None, {"act": "adjust_speed", "change": "faster"}),
        ("too much velocity", "practice", None, {"act": "adjust_speed", "change": "slower"}),
        ("grouting is not obligatory", "learning", None,
         {"act": "optional", "subtask": "grouting"}),
        ("task name: cable routing", "introduction", "task_name",
         {"act": "inform", "value": "cable routing"}),
        ("the objects in question are a stamp and an ink pad", "introduction", "objects",
         {"act": "inform", "value": ["stamp", "ink pad"]}),
        ("stacking's done afore sweeping", "introduction", "order",
         {"act": "ordered", "first": "stacking", "second": "sweeping"}),
        ("refactor: rename clipping to fastening", "learning", None,
         {"act": "rename", "old": "clipping", "new": "fastening"}),
        ("twisting can be left out if the pencil is already sharp", "learning", None,
         {"act": "optional", "subtask": "twisting"}),
        ("a bit lo her", "practice", None,
         {"act": "translate", "direction": "down", "degree": "little"}),
        ("haud on a minute", "practice", None, {"act": "pause"}),
        ("what now", "practice", None, {"act": "help"}),
        ("bring it back", "practice", None, {"act": "redo"}),
        ("watch me", "demonstration", "ready", {"act": "start"}),
        ("slow down to sixty per cent", "practice", None,
         {"act": "adjust_speed", "factor": 0.6}),
        ("grating is over at nine decimal five seconds", "learning", None,
         {"act": "move_cut", "at_s": 9.5, "subtask": "grating"}),
        ("3? nah 4", "introduction", "subtask_count", {"act": "inform", "value": 4}),
        ("I will show you", "introduction", "objects", {"act": "unknown"}),
        ("let me have a look at it first", "introduction", "confirm_tree",
         {"act": "show", "what": "tree"}),
        ("show them to me", "learning", "confirm_segmentation",
         {"act": "show", "what": "segmentation"}),
        ("peg: 500, -50, 120, rpy 0 0 90", "practice", "pose",
         {"act": "set_pose", "object": "peg", "position_mm": [500.0, -50.0, 120.0],
          "rpy_deg": [0.0, 0.0, 90.0]}),
        ("twist and glue", "introduction", "task_name",
         {"act": "inform", "value": "twist and glue"}),
        ("the board was shifted by two centimetres to the right and three forward",
         "practice", None, {"act": "set_pose", "object": "board", "by_mm": [30.0, -20.0, 0.0]}),
        ("separate clip it in two parts", "learning", None,
         {"act": "split", "subtask": "clip it"}),
        ("reject", "learning", "confirm_segmentation", {"act": "deny"}),
        ("rename the task to lid sorting", "introduction", None,
         {"act": "rename", "old": "task", "new": "lid sorting"}),
    ],
)  # fmt: skip
def test_kinds_of_sentences_once_misunderstood(
    text: str, stage: Any, asked: Any, act: dict[str, Any]
) -> None:
    meant = understand(text, Listening(stage=stage, asked=asked))
    assert [act_to_json(one) for one in meant.acts] == [act]


@pytest.mark.parametrize(
    "text",
    [
        "do it over, a lot slower",
        "a lot slower, do it over",
        "one time more, but with less speed",
        "again, slower",
    ],
)
def test_a_run_asked_for_once_more_is_not_lost_beside_how(text: str) -> None:
    meant = understand(text, Listening(stage="practice"))
    assert [act_to_json(one)["act"] for one in meant.acts] == ["adjust_speed", "again"]
