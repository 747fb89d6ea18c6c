"""Every line the robot may say has its words, and they are safe to say aloud."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import assistant.dialogue
from assistant.errors import BadInput
from assistant.language.hints import has_page, page
from assistant.language.kinds import KINDS
from assistant.language.speech import check_spoken, phrase
from assistant.language.stopping import has_stop_word
from assistant.model.robot_acts import About, RobotAct
from assistant.model.teacher_acts import ACTS, ASKED, STAGES

LANGUAGES = ("english", "german")
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
SPOKEN_PARTS = ("given", "conditions", "actions", "hints", "signals", "changes")


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


@pytest.mark.parametrize("language", LANGUAGES)
def test_nothing_said_while_moving_holds_a_stop_word(language: str) -> None:
    book = page("says", language)
    told = [
        text
        for act, topics in WHILE_MOVING.items()
        for topic, template in book["says"][act].items()
        if topics is None or topic in topics
        for text in _texts(template)
    ]
    # The words that fill those sentences are the same while moving and at rest.
    parts = [text for part in SPOKEN_PARTS for text in _leaves(book[part])]
    assert [text for text in (*told, *parts) if has_stop_word(text, language)] == []


def _leaves(value: Any) -> list[str]:
    if isinstance(value, dict):
        return [text for one in value.values() for text in _leaves(one)]
    return [text for one in value for text in _leaves(one)] if isinstance(value, list) else [value]


def _keys(value: Any, *above: str) -> Iterator[tuple[str, ...]]:
    if isinstance(value, dict):
        for key, one in value.items():
            yield (*above, key)
            yield from _keys(one, *above, key)


OWN = {
    *("given", "numbers", "ordinals", "units", "things", "plurals", "colors", "scripted"),
    *("letters", "labels", "problems", "key_names", "shares_of_a_second", "third_person"),
}
"""What is keyed by the words of a language, or by English ones that it has others for."""


@pytest.mark.parametrize("name", ["says", "hints", "terminal"])
def test_every_key_stands_in_both_phrasebooks(name: str) -> None:
    """The words of a language are its own; what they are words for is the same."""
    english, german = (page(name, language) for language in LANGUAGES)
    told = [{key for key in _keys(one) if not OWN & set(key[:-1])} for one in (english, german)]
    assert sorted(told[0] ^ told[1]) == []
    assert has_page(name, "german")


def _slots(text: str) -> set[str]:
    return {name for name, _ in re.findall(r"\{(\w+)(?::([^}]*))?\}", text)}


def test_both_phrasebooks_tell_the_same_slots() -> None:
    english, german = (page("says", language)["says"] for language in LANGUAGES)
    odd = [
        f"{act}.{topic}"
        for act, topics in english.items()
        for topic, template in topics.items()
        for ours, theirs in zip(_texts(template), _texts(german[act][topic]), strict=True)
        if _slots(ours) != _slots(theirs)
    ]
    assert odd == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_kind_of_word_is_known(language: str) -> None:
    book = page("says", language)
    kinds = {kind for text in _leaves(book) for _, kind in re.findall(r"\{(\w+):([^}]*)\}", text)}
    plain = {kind for kind in kinds if re.fullmatch(r"(?:\.\d)?[fg]", kind)}
    assert kinds - plain - set(KINDS) - set(book["words"]) == set()


def test_slots_become_words() -> None:
    announce = RobotAct(
        "announce",
        "primitive",
        about=About("grasp object", (1, 2)),
        slots={
            "name": "grasp object",
            "before": [{"docked": "block"}],
            "until": [{"held": "block"}],
            "going_on": [{"held": "block"}],
            "action": {"hand": "close", "object": "block"},
            "expect": [],
        },
    )
    assert phrase(announce) == (
        '"grasp object": I close the hand on the block. Before that, I am in front of the block.'
        " I go on until the block is in the hand."
    )
    assert phrase(announce, brief=True) == '"grasp object".'


@pytest.mark.parametrize(
    ("lag_s", "told"), [(0.3, "about 0.3 s after"), (-0.4, "about 0.4 s before")]
)
def test_cues_are_told_to_come_after_or_before(lag_s: float, told: str) -> None:
    slots = {"count": 1, "episodes": [], "cue_lag_s": lag_s}
    assert told in phrase(RobotAct("read_back", "episodes", slots=slots))


def test_a_place_is_told_as_seen_from_the_robot() -> None:
    place = {"of": "body", "xyz_mm": [452.0, -148.0, 240.0], "rpy_deg": [0.0, 0.0, 0.0]}
    slots = {"thing": "jar", "place": place}
    said = phrase(RobotAct("read_back", "place", slots=slots))
    assert said == "The jar is at 452, -148, 240 mm: 45 cm in front of me and 15 cm to my right."


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
        "  2 c: do as you show: shake it",
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


def test_a_language_without_words_of_the_robot_is_refused(tmp_path: Path) -> None:
    for language in (*LANGUAGES, "en", "de"):
        check_spoken(language)
    with pytest.raises(BadInput, match="does not speak klingon"):
        check_spoken("klingon")


def test_german_tells_numbers_names_and_texts_of_the_program_its_own_way() -> None:
    slots = {"where": "way to target", "what": "joint 5", "amount": 12.0, "unit": "deg"}
    told = phrase(RobotAct("refuse", "joint_limit", slots=slots), "german")
    assert told == (
        "Ich fahre nicht: auf dem Weg zu „Ziel“ müsste Gelenk 5 über die Grenze, um 12 Grad."
    )
    note = "going around table on the way to block; staying within the arm's reach at the end"
    around = phrase(RobotAct("report", "detour", slots={"note": note}), "german")
    assert around == (
        "Ich nehme einen anderen Weg: um „Tisch“ herum auf dem Weg zu „Block“;"
        " innerhalb meiner Reichweite am Ende."
    )
    slots = {"size": 2.5, "direction": "left", "primitive": "grasp", "frame": "target"}
    told = phrase(RobotAct("done", "translate", slots=slots), "german")
    assert told == "2,5 mm nach links bei „grasp“, wo immer „Ziel“ steht."
