from typing import Any

import pytest

from assistant.language.cutting import cuts
from assistant.language.learned import learned
from assistant.language.parsing import Hearing
from assistant.language.phrasebook import LANGUAGES, phrasebook
from assistant.language.words import words_of
from assistant.model.listening import Listening
from assistant.model.teacher_acts import act_to_json


def hearing(**where: Any) -> Hearing:
    return Hearing(phrasebook(), Listening(**{"stage": "practice", **where}))


def read(text: str, **where: Any) -> list[dict[str, Any]]:
    near = hearing(**where)
    words = words_of(text, near.book.contractions)
    return [act_to_json(one.act) for one in learned(words, near)]


def test_names_are_those_the_task_knows() -> None:
    found = read("swinging across may be skipped", stage="learning", subtasks=("swing across",))
    assert found[0] == {"act": "optional", "subtask": "swing across"}


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("a tiny bit to the left while you place it",
         {"act": "translate", "direction": "left", "degree": "little",
          "where": {"subtask": "place it", "when": "during"}}),
        ("twelve millimetres up", {"act": "translate", "direction": "up", "distance_m": 0.012}),
        ("fragment two goes to lift", {"act": "assign", "episode": 2, "subtask": "lift"}),
    ],
)  # fmt: skip
def test_slots_are_read_from_the_words_that_hold_them(text: str, act: dict[str, Any]) -> None:
    assert read(text)[0] == act


def test_a_pronoun_behind_a_lone_verb_is_of_its_name() -> None:
    """Which words may follow it stands in the lists of the language."""
    found = read("split lift it into two", stage="learning")
    assert found[0] == {"act": "split", "subtask": "lift it"}


def test_a_list_is_told_apart_item_by_item() -> None:
    found = read("a red cup, a jug and some napkins", stage="introduction", asked="objects")
    assert found[0]["value"][:2] == ["red cup", "jug"]


def test_readings_are_told_with_logarithms_of_chances() -> None:
    near = hearing()
    for one in learned(words_of("slower please", near.book.contractions), near):
        assert one.act_log <= 0.0
        assert one.slots_log <= 1e-4


def test_a_line_of_two_clauses_is_cut_between_them() -> None:
    near = hearing()
    words = words_of("five millimetres up and a little slower", near.book.contractions)
    best = cuts(words, near)[0]
    assert [act_to_json(one.act)["act"] for one in best.clauses] == ["translate", "adjust_speed"]


def test_a_language_without_weights_reads_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(LANGUAGES, "unlearned", "unlearned")
    near = Hearing(phrasebook("german"), Listening(stage="practice"), "unlearned")
    assert learned(words_of("etwas weiter links", near.book.contractions), near) == []
