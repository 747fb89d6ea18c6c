from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.language.choosing import candidates, chosen, ranking, scaled, weights
from assistant.language.looks import Candidate, key_of
from assistant.language.parsing import ACTING, Hearing, Parse
from assistant.language.phrasebook import LANGUAGES, phrasebook
from assistant.language.repair import respelled
from assistant.language.seeking import chances_of
from assistant.language.understanding import understand
from assistant.language.words import words_of
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Merge, Rename, Stop, Undo, Unknown, act_to_json


def heard(text: str, **where: Any) -> tuple[list[dict[str, Any]], float]:
    meant = understand(text, Listening(**{"stage": "learning", **where}))
    return [act_to_json(act) for act in meant.acts], meant.confidence


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("from here on the twist knob bit ought to go by the name open valve",
         {"act": "rename", "old": "twist knob", "new": "open valve"}),
        ("i would like pinch and hoist to be fused into a single one",
         {"act": "merge", "subtasks": ["pinch", "hoist"]}),
        ("between us, the wipe is something one may leave out",
         {"act": "optional", "subtask": "wipe"}),
    ],
)  # fmt: skip
def test_sentences_no_rule_was_made_for_are_read(text: str, act: dict[str, Any]) -> None:
    assert heard(text)[0] == [act]


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0), st.floats(0.5, 0.99))
def test_confidence_keeps_the_order_of_probabilities(a: float, b: float, least: float) -> None:
    low, high = sorted((a, b))
    assert scaled(low, least) <= scaled(high, least)
    assert scaled(least, least) == pytest.approx(ACTING)
    assert 0.0 <= scaled(a, least) <= 1.0


@given(st.lists(st.floats(-5, 5), min_size=1, max_size=6))
def test_shares_of_readings_sum_to_one_best_first(worth: list[float]) -> None:
    pool = [Candidate((Undo(),), {"look": one}) for one in worth]
    shares = [share for share, _ in ranking(pool, {"look": 1.0})]
    assert sum(shares) == pytest.approx(1.0)
    assert shares == sorted(shares, reverse=True)


def test_articles_and_capitals_make_no_other_reading() -> None:
    assert key_of([Rename("the grip", "Hold")]) == key_of([Rename("grip", "hold")])
    assert key_of([Merge(("a", "b"))]) != key_of([Merge(("b", "a"))])


def test_what_both_ways_read_is_one_reading() -> None:
    hearing = Hearing(phrasebook(), Listening(stage="learning"))
    words = words_of("rename grip to hold", hearing.book.contractions)
    chances = chances_of(words, respelled(words, hearing.book, ()), hearing)
    parse = Parse((Rename("grip", "hold"),), 0.9, "named")
    pool = candidates(parse, parse, words, chances, hearing)
    same = [one for one in pool if key_of(one.acts) == key_of(parse.acts)]
    assert len(same) == 1
    assert {"weighed", "first", "whole"} <= same[0].looks.keys()


def test_learned_readings_never_stop_the_arm() -> None:
    hearing = Hearing(phrasebook(), Listening(stage="practice"))
    words = words_of("do halt it right there", hearing.book.contractions)
    chances = chances_of(words, words, hearing)
    parse = Parse((Unknown(),), 0.6)
    assert all(Stop() not in one.acts for one in candidates(parse, parse, words, chances, hearing))


def test_a_language_without_weights_is_left_to_its_grammar(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(LANGUAGES, "unlearned", "unlearned")
    hearing = Hearing(phrasebook("german"), Listening(stage="practice"), "unlearned")
    parse = Parse((Undo(),), 0.9, "frame")
    words = words_of("mach das weg", hearing.book.contractions)
    assert weights("unlearned") is None
    assert chosen(parse, parse, words, {}, hearing) is None


def test_a_motion_with_a_word_nobody_knows_is_asked_about() -> None:
    # "pochino" tells how far: moving as though it were not said would be too far.
    acts, confidence = heard("more to the left, a pochino", stage="practice")
    assert acts[0]["direction"] == "left"
    assert confidence < ACTING


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("you speak like the radio, make it short", {"act": "be_brief"}),
        ("could you load the lesson bathroom tiles", {"act": "load", "name": "bathroom tiles"}),
    ],
)
def test_a_word_of_other_matters_is_no_talk_of_them_where_all_else_tells_an_act(
    text: str, act: dict[str, Any]
) -> None:
    assert heard(text, stage="practice")[0] == [act]


@pytest.mark.parametrize(
    ("text", "asked"),
    [("beside you, looking your way", "facing"), ("15 centimetres across, 12 high", "body")],
)
def test_where_one_stands_and_how_big_a_thing_is_are_told_whole(text: str, asked: Any) -> None:
    (act,), _ = heard(text, stage="practice", asked=asked)
    assert act["value"].replace(",", "") == text.replace(",", "")


def test_the_name_of_a_known_step_is_no_thing_that_was_moved() -> None:
    (act,), _ = heard(
        "two millimetres left at place object on target",
        stage="practice",
        subtasks=("grasp object", "place object on target"),
        objects=("object", "target"),
    )
    assert act["act"] == "translate"
