import json
from functools import cache
from typing import Any, cast

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.language.understanding import understand
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import ASKED, STAGES, Affirm, Stop, Unknown, act_to_json
from assistant.plain_yaml import read_file
from tests.benchmarks.bench_language import CORPUS, FILES, Row, rows, same

LANGUAGES = ("english", "german")
NAMES = ("pick up object", "approach object", "grasp object", "move up object")


def heard(text: str, **where: Any) -> list[dict[str, Any]]:
    listening = Listening(**{"stage": "practice", **where})
    return [act_to_json(act) for act in understand(text, listening).acts]


@pytest.mark.parametrize("file", [f"{name}.yaml" for name in FILES])
def test_nearly_all_sentences_of_the_corpus_are_understood(file: str) -> None:
    wrong = [row for row in rows(file) if not _right(row)]
    assert len(wrong) <= 0.05 * len(list(rows(file))), [row.text for row in wrong]


@pytest.mark.parametrize("file", [f"{name}.yaml" for name in FILES])
def test_what_is_acted_on_is_right(file: str) -> None:
    sure = [row for row in rows(file) if _meant(row.text, row.listening).confidence >= 0.85]
    wrong = [row.text for row in sure if not _right(row)]
    assert len(wrong) <= 0.005 * len(list(rows(file))), wrong


@cache
def _meant(text: str, listening: Listening) -> Understanding:
    return understand(text, listening)


def _right(row: Row) -> bool:
    meant = _meant(row.text, row.listening)
    return same(row.acts, [act_to_json(act) for act in meant.acts])


@pytest.mark.parametrize("language", LANGUAGES)
@settings(max_examples=60, deadline=None)
@given(st.text(max_size=80), st.sampled_from(STAGES), st.sampled_from([None, *ASKED]))
def test_no_text_raises_and_no_text_means_nothing(
    language: str, text: str, stage: Any, asked: Any
) -> None:
    meant = understand(text, Listening(stage=stage, asked=asked), language)
    assert meant.acts
    assert 0.0 <= meant.confidence <= 1.0


CRIES = {
    "english": ["stop", "Halt!", "FREEZE", "don't stop", "stpo"],
    "german": ["stopp", "Halt!", "ANHALTEN", "nicht stoppen", "stpo"],
}


@settings(max_examples=40, deadline=None)
@given(st.text(max_size=40), st.sampled_from(LANGUAGES), st.integers(0, 4))
def test_while_moving_a_stop_word_anywhere_stops(text: str, language: str, cry: int) -> None:
    moving = Listening(stage="practice", moving=True)
    meant = understand(f"{text} {CRIES[language][cry]}", moving, language)
    assert meant.acts == (Stop(),)


@pytest.mark.parametrize(
    "text",
    [
        "there is some time left",
        "my bus stop",
        "don't stop",
        "never stop",
        "do not stop now",
        "full stop",
        "when does the next bus stop here",
        "we should stop by the shop",
        "i can't stop laughing",
        "stop singing so loudly",
        "stop being silly",
        "halo there",
    ],
)
def test_at_rest_talk_of_stopping_is_no_stop(text: str) -> None:
    assert "stop" not in [act["act"] for act in heard(text)]


@pytest.mark.parametrize(
    "text",
    ["stop", "please stop", "STOP!!", "stpo", "stopp", "stop the arm", "no, stop", "halt now",
     "whoa", "freeze", "could you stop please", "stop, you will hit the table", "i said stop"],
)  # fmt: skip
@pytest.mark.parametrize("asked", [None, "satisfied", "subtask_name", "objects", "goal"])
def test_at_rest_stop_is_understood_whatever_was_asked(text: str, asked: Any) -> None:
    assert heard(text, asked=asked) == [{"act": "stop"}]


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("you can skip moving up", "move up object"),
        ("the second step is optional", "approach object"),
        ("grasping is optional", "grasp object"),
        ("step four is optional", "move up object"),
    ],
)
def test_references_resolve_to_known_names(text: str, name: str) -> None:
    assert heard(text, subtasks=NAMES) == [{"act": "optional", "subtask": name}]


def test_a_guess_is_never_sure() -> None:
    meant = understand("left a whatsit", Listening(stage="practice"))
    assert meant.confidence < 0.85


@pytest.mark.parametrize(
    "text", ["again, more left", "again, slower", "up two centimeters and once more"]
)
@pytest.mark.parametrize("asked", [None, "satisfied"])
def test_a_correction_to_be_tried_at_once_is_sure(text: str, asked: Any) -> None:
    meant = understand(text, Listening(stage="practice", asked=asked))
    assert meant.confidence >= 0.85
    assert [act_to_json(act)["act"] for act in meant.acts][1:] == ["again"]


def test_one_more_time_is_no_more_of_the_last_correction() -> None:
    meant = understand("repeat it one more time please", Listening(stage="practice"))
    assert meant.confidence < 0.85 or [act_to_json(act)["act"] for act in meant.acts] == ["again"]


@pytest.mark.parametrize("stage", STAGES)
def test_no_chat_is_acted_on(stage: Any) -> None:
    talk = cast("dict[str, str]", read_file(CORPUS / "chat.yaml")[0].value)["chat"].splitlines()
    meanings = [(line, understand(line, Listening(stage=stage))) for line in talk]
    acted = [line for line, meant in meanings if meant.confidence >= 0.85 and not _idle(meant)]
    assert acted == []


def _idle(meant: Understanding) -> bool:
    return meant.acts == (Unknown(),)


def test_chat_is_unknown_in_every_stage() -> None:
    for stage in STAGES:
        meant = understand("the weather is nice today", Listening(stage=stage))
        assert meant.acts == (Unknown(),)


def test_answers_read_as_the_question_wants() -> None:
    assert heard("there are a couple", asked="subtask_count") == [{"act": "inform", "value": 2}]
    assert heard("the red block and a target", asked="objects") == [
        {"act": "inform", "value": ["red block", "target"]}
    ]
    assert heard("open the hand", asked="subtask_name") == [
        {"act": "inform", "value": "open the hand"}
    ]


def test_acts_are_plain_json() -> None:
    acts = heard("when you place it, a bit more left")
    assert json.loads(json.dumps(acts)) == acts
    assert acts[0]["where"] == {"subtask": "place it", "when": "during"}


@pytest.mark.parametrize("asked", [None, "satisfied", "ready"])
def test_a_slip_in_the_direction_is_still_acted_on(asked: Any) -> None:
    meant = understand("a bit more lfet", Listening(stage="practice", asked=asked))
    assert [act_to_json(act) for act in meant.acts] == [
        {"act": "translate", "direction": "left", "degree": "little"}
    ]
    assert meant.confidence >= 0.85


def test_why_not_is_understood_by_what_was_asked() -> None:
    assert heard("why not") == [{"act": "explain", "text": "why not"}]
    assert heard("why not", stage="demonstration") == [{"act": "explain", "text": "why not"}]
    for asked in ("ready", "satisfied", "confirm_tree"):
        meant = understand("why not", Listening(stage="practice", asked=asked))
        assert meant.acts == (Affirm(),)
        assert meant.confidence < 0.85


def test_heard_is_the_line_as_given() -> None:
    for text in ("A bit mroe LEFT!", "Yes.", "stop", "..."):
        for moving in (False, True):
            assert understand(text, Listening(stage="practice", moving=moving)).heard == text


def test_praise_behind_a_yes_leaves_it_sure() -> None:
    where = Listening(stage="practice", asked="satisfied")
    meant = understand("Yes, that was perfect, thank you very much", where)
    assert meant.acts == (Affirm(),)
    assert meant.confidence >= 0.85
