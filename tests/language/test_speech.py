"""Every line the robot may say has its words, and they are safe to say aloud."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import assistant.dialogue
from assistant.errors import BadInput
from assistant.language.hints import page
from assistant.language.speech import check_spoken, phrase
from assistant.language.stopping import has_stop_word
from assistant.model.robot_acts import About, RobotAct
from assistant.model.teacher_acts import ACTS, ASKED, STAGES

LANGUAGES = ("english",)
SAYS: dict[str, dict[str, Any]] = page("says")["says"]
WHILE_MOVING = {
    "announce": None,
    "perceived": None,
    "read_back": None,
    "report": {"starting_slow", "detour", "replaying"},
    "told": {"next_time", "moving_already", "glad", "brief", "thorough", "corrections"},
    "error": {"while_moving", "not_understood", "not_understood_again", "nothing_to_undo"},
    "explain": {"next_step", "next_none", "why_asked.none", "cut", "assignment", "sure"},
    "help": {"moving", "checking"},
    "done": None,
}


def written() -> Iterator[tuple[str, str]]:
    """Yield the act and topic of every line written out in the dialogue."""
    for path in sorted(Path(assistant.dialogue.__path__[0]).glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
                continue
            if node.func.id != "line" or len(node.args) < 2:
                continue
            values = [arg.value for arg in node.args[:2] if isinstance(arg, ast.Constant)]
            if len(values) == 2:
                yield str(values[0]), str(values[1])


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_line_of_the_dialogue_has_words(language: str) -> None:
    says = page("says", language)["says"]
    missing = [f"{act}.{topic}" for act, topic in written() if topic not in says[act]]
    assert missing == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_question_can_be_asked_helped_with_and_explained(language: str) -> None:
    says = page("says", language)["says"]
    helped = says["help"]
    assert [asked for asked in ASKED if asked not in helped] == []
    assert [stage for stage in STAGES if stage not in helped] == []
    assert [act for act in ACTS if act not in page("says", language)["acts"]] == []


def _texts(template: Any) -> list[str]:
    return [template] if isinstance(template, str) else [template["full"], template["brief"]]


def test_nothing_said_while_moving_holds_a_stop_word() -> None:
    for act, topics in WHILE_MOVING.items():
        for topic, template in SAYS[act].items():
            if topics is None or topic in topics:
                assert not any(has_stop_word(text) for text in _texts(template)), f"{act}.{topic}"


def test_slots_become_words() -> None:
    announce = RobotAct(
        "announce",
        "primitive",
        about=About("grasp object", (1, 2)),
        slots={
            "name": "grasp object",
            "before": [{"docked": "block"}],
            "until": [{"held": "block"}],
            "action": {"hand": "close", "object": "block"},
            "expect": [],
        },
    )
    assert phrase(announce) == (
        '"grasp object": I close the hand on the block. Before that, I am in front of the block.'
        " I go on until the block is in the hand."
    )
    assert phrase(announce, brief=True) == '"grasp object".'


def test_empty_parts_are_left_out() -> None:
    refusal = {"where": "target", "what": "joint 5", "amount": 12.3, "unit": "deg"}
    told = phrase(RobotAct("refuse", "joint_limit", slots={**refusal, "hint": "turn"}))
    assert "joint 5 would pass its limit by 12 degrees" in told
    assert told.endswith("It would help to turn it.")
    bare = phrase(RobotAct("refuse", "joint_limit.only", slots={"where": "target"}))
    assert bare == "I do not go: at the target one of my joints would pass its limit."


def test_a_tree_is_numbered() -> None:
    tree = {
        "name": "task",
        "order": "any",
        "parts": [
            {"name": "a", "parts": [{"name": "b", "action": {"move": "up"}, "optional": True}]},
            {"name": "c", "action": {"free": "shake it"}},
        ],
    }
    told = phrase(RobotAct("told", "tree", slots={"tree": tree})).splitlines()
    assert told == [
        '"task" (in any order)',
        "  1 a",
        "    1.1 b: go up (may be left out)",
        "  2 c: do as you showed: shake it",
    ]


def test_a_topic_nobody_wrote_words_for_is_still_said() -> None:
    assert phrase(RobotAct("error", "odd_thing")) == "odd thing"
    special = RobotAct("confirm", "optional.no_change", slots={"name": "lift"})
    assert phrase(special) == phrase(RobotAct("confirm", "optional", slots={"name": "lift"}))


def test_lists_read_as_people_say_them() -> None:
    lines = [RobotAct("told", "lessons", slots={"names": list("abc"[:n])}) for n in (1, 2, 3)]
    assert [phrase(one) for one in lines] == [
        "I know a.",
        "I know a and b.",
        "I know a, b and c.",
    ]


def test_guesses_are_read_back_in_words() -> None:
    acts = [
        {"act": "translate", "direction": "left", "degree": "little"},
        {"act": "adjust_speed", "change": "slower"},
    ]
    told = phrase(RobotAct("confirm", "did_you_mean", "did_you_mean", slots={"acts": acts}))
    assert told == "Did you mean: a little more left and slower?"


def test_a_language_without_words_of_the_robot_is_refused() -> None:
    check_spoken("english")
    with pytest.raises(BadInput, match="does not speak german yet"):
        check_spoken("german")
