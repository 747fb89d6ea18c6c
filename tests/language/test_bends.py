"""Words nobody listed are known by how they come of others, where a language tells how."""

import pytest

from assistant.language.bends import Bends, bends_of, put_together, unbent_word
from assistant.language.phrasebook import phrasebook
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import (
    Affirm,
    Approve,
    Gripper,
    Inform,
    Ordered,
    RepeatLine,
    Rotate,
    SetPose,
    TeacherAct,
    Translate,
    Where,
)

PRACTICE = Listening(stage="practice")


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("gsogt", "gesagt"),
        ("ausfiahrlicher", "ausführlicher"),
        ("feschthalte", "festhalten"),
        ("anzuheben", "anheben"),
        ("weiterzumachen", "weitermachen"),
        ("planungsbaum", "baum"),
        ("arbeitsschritt", "schritt"),
    ],
)
def test_german_words_come_of_others(text: str, word: str) -> None:
    book = phrasebook("german")
    assert unbent_word(text, book.vocabulary, book.bends) == word


@pytest.mark.parametrize("text", ["rolle", "tonne", "dose", "korb", "untertasse", "wagen", "zug"])
def test_things_are_no_bent_words(text: str) -> None:
    book = phrasebook("german")
    known = book.vocabulary | book.real
    assert text in known or not unbent_word(text, book.vocabulary, book.bends)


def test_known_words_stay_when_nothing_bends() -> None:
    assert bends_of({}) == Bends() == phrasebook("english").bends
    for text in ("gsogt", "anything", "x"):
        assert unbent_word(text, frozenset(("gesagt", "thing")), Bends()) == ""


def test_two_ways_as_short_tell_nothing() -> None:
    both = Bends(sounds=(("o", "a"), ("o", "u")))
    assert unbent_word("hond", frozenset(("hand",)), both) == "hand"
    assert unbent_word("hond", frozenset(("hand", "hund")), both) == ""


def test_a_word_of_two_known_ones_is_no_slip() -> None:
    assert put_together("untertasse", frozenset(("unter", "tasse", "unterlassen")))
    assert not put_together("untertas", frozenset(("unter", "tasse")))


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        (
            "Wären Sie so gut, zwei Zentimeter weiter nach vorne zu fahren?",
            (Translate("forward", distance_m=0.02),),
        ),
        ("Senken Se das bitte etwas ab", (Translate("down", "little"),)),
        ("bisschen mehr zu linke Seite", (Translate("left", "little"),)),
        ("das war zu weit links", (Translate("right"),)),
        ("greifer oefnen", (Gripper("open"),)),
        ("ein Viertelzoll nach links", (Translate("left", distance_m=0.00635),)),
        (
            "Drei Millimeter nach links, dann zwei Grad gegen den Uhrzeigersinn",
            (Translate("left", distance_m=0.003), Rotate("counterclockwise", angle_deg=2.0)),
        ),
        (
            "drei Millimeter nach links, danach fünf Millimeter hoch",
            (Translate("left", distance_m=0.003), Translate("up", distance_m=0.005)),
        ),
        (
            "beim Abstellen etwas höher",
            (Translate("up", "little", where=Where("Abstellen", "during")),),
        ),
        ("wos host gsogt?", (RepeatLine(),)),
    ],
)
def test_bent_german_is_understood(text: str, acts: tuple[TeacherAct, ...]) -> None:
    assert understand(text, PRACTICE, "german").acts == acts


def test_numbers_read_out_are_a_place() -> None:
    where = Listening(stage="practice", asked="pose")
    found = understand("Karton steht bei vierhundert, hundert, zweihundert", where, "german")
    assert found.acts == (SetPose("Karton", (400.0, 100.0, 200.0)),)


@pytest.mark.parametrize(
    ("text", "language"),
    [("ja, das haben Sie sehr schön gemacht", "german"), ("yes, that looks good", "english")],
)
def test_praise_behind_a_yes_is_the_yes(text: str, language: str) -> None:
    asked = Listening(stage="practice", asked="satisfied")
    assert understand(text, asked, language).acts == (Affirm(),)
    assert understand(text, PRACTICE, language).acts in ((Approve(),), (Affirm(),))


@pytest.mark.parametrize("text", ["Mama, darf ich ein Eis?", "einen Kaffee bitte"])
def test_one_of_other_things_is_no_count(text: str) -> None:
    asked = Listening(stage="introduction", asked="subtask_count")
    assert Inform(1) not in understand(text, asked, "german").acts
    assert understand("ein Schritt", asked, "german").acts == (Inform(1),)


def test_no_step_comes_before_itself() -> None:
    asked = Listening(stage="introduction", asked="order")
    text = "Fügen setzt Zentrieren voraus, also Zentrieren zuerst"
    for act in understand(text, asked, "german").acts:
        assert not isinstance(act, Ordered) or act.first != act.second
