from typing import Any

import pytest

from assistant.language.completion import suggestions
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import ASKED, STAGES, Stop, Unknown, act_to_json
from tests.benchmarks.bench_language import Row, rows, same

ROWS = list(rows("german.yaml"))


def _right(row: Row) -> bool:
    meant = understand(row.text, row.listening, "german")
    return same(row.acts, [act_to_json(act) for act in meant.acts])


def test_nearly_all_german_sentences_are_understood() -> None:
    wrong = [row.text for row in ROWS if not _right(row)]
    assert len(wrong) <= 0.05 * len(ROWS), wrong


def test_what_is_acted_on_is_right() -> None:
    sure = [row for row in ROWS if understand(row.text, row.listening, "de").confidence >= 0.85]
    assert [row.text for row in sure if not _right(row)] == []


@pytest.mark.parametrize("text", ["stopp", "Halt!", "halt an", "sofort stopp", "stpo", "anhalten"])
@pytest.mark.parametrize("asked", [None, "goal", "objects", "satisfied"])
def test_stop_is_understood_whatever_was_asked(text: str, asked: Any) -> None:
    meant = understand(text, Listening(stage="practice", asked=asked), "german")
    assert meant.acts == (Stop(),)


@pytest.mark.parametrize("text", ["ich stehe an der Bushaltestelle", "der Bus hält nicht"])
def test_talk_of_stopping_is_no_stop(text: str) -> None:
    assert understand(text, Listening(stage="practice"), "german").acts == (Unknown(),)


@pytest.mark.parametrize("stage", STAGES)
def test_any_question_and_stage_has_an_answer(stage: Any) -> None:
    for asked in (None, *ASKED):
        for text in ("", "ja", "xyz", "zwei", "der Block und das Ziel"):
            assert understand(text, Listening(stage=stage, asked=asked), "german").acts


def test_completion_offers_german() -> None:
    assert "hilfe" in suggestions(Listening(stage="practice"), "german")
