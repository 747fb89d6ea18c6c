from typing import Any

import pytest

from assistant.language.completion import suggestions
from assistant.language.counting import glued
from assistant.language.phrasebook import phrasebook
from assistant.language.stopping import has_stop_word
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import (
    ASKED,
    STAGES,
    AdjustLast,
    AdjustSpeed,
    Affirm,
    Cue,
    Gripper,
    Inform,
    Ordered,
    Rename,
    SetPose,
    Show,
    Stop,
    Translate,
    Unknown,
    Unordered,
    act_to_json,
)
from tests.benchmarks.bench_language import Row, rows, same

ROWS = [*rows("german.yaml"), *rows("german_ways.yaml")]
FRESH = [*rows("german_dev.yaml"), *rows("german_talk.yaml")][::5]


def _right(row: Row) -> bool:
    meant = understand(row.text, row.listening, "german")
    return same(row.acts, [act_to_json(act) for act in meant.acts])


def test_nearly_all_german_sentences_are_understood() -> None:
    wrong = [row.text for row in ROWS if not _right(row)]
    assert len(wrong) <= 0.05 * len(ROWS), wrong


def test_most_of_what_many_kinds_of_people_say_is_understood() -> None:
    wrong = [row.text for row in FRESH if not _right(row)]
    assert len(wrong) <= 0.08 * len(FRESH), wrong


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


PRACTICE = Listening(stage="practice")


@pytest.mark.parametrize("text", ["anderthalbmal so schnell", "1,5 mal so schnell"])
def test_so_many_times_so_fast_is_no_complaint(text: str) -> None:
    assert understand(text, PRACTICE, "german").acts == (AdjustSpeed(factor=1.5),)


@pytest.mark.parametrize("text", ["nicht so schnell", "du fährst so schnell"])
def test_so_fast_alone_complains(text: str) -> None:
    assert understand(text, PRACTICE, "german").acts == (AdjustSpeed("slower"),)


def test_a_thing_and_what_stands_for_it_are_one() -> None:
    heard = Listening(stage="practice", asked="pose")
    acts = understand("der Karton er ist auf 450, 300 und 80", heard, "german").acts
    assert acts == (SetPose("Karton", (450.0, 300.0, 80.0)),)


def test_a_yes_before_a_change_answers() -> None:
    heard = Listening(stage="introduction", asked="confirm_tree")
    acts = understand("ja, aber nenn das Zwicken lieber Halten", heard, "german").acts
    assert acts == (Affirm(), Rename("Zwicken", "Halten"))


def test_little_words_behind_a_thing_are_no_part_of_it() -> None:
    heard = Listening(stage="introduction", asked="objects")
    acts = understand("die Kanne halt, und, äh, der Topf", heard, "german").acts
    assert acts == (Inform(("Kanne", "Topf")),)


@pytest.mark.parametrize("word", ["hast", "halb", "hält", "holt", "hole", "hat", "behalte", "stab"])
def test_words_of_holding_stop_no_motion(word: str) -> None:
    assert not has_stop_word(f"was {word} du da", "german")


@pytest.mark.parametrize("text", ["halt", "hallt!", "sofort anhalten", "stoppp", "hör auf, stopp"])
def test_cries_stop_a_motion(text: str) -> None:
    moving = Listening(stage="practice", moving=True)
    assert understand(text, moving, "german").acts == (Stop(),)


def test_numbers_in_one_word_are_those_in_several() -> None:
    numbers = phrasebook("german").numbers
    for ten_word, ten in numbers.tens.items():
        for one_word, one in list(numbers.ones.items())[2:10]:
            assert numbers.number((f"{one_word}und{ten_word}",), 0) == (ten + one, 1)
            whole = f"{one_word}hundert{one_word}und{ten_word}"
            assert numbers.number((whole,), 0) == (100 * one + ten + one, 1)
    assert numbers.number(("zweieinhalb",), 0) == (2.5, 1)
    assert glued("", numbers.tens, numbers.ones) == {}


@pytest.mark.parametrize(
    ("text", "typed"),
    [
        ("zwei Zentimeter höher", "zwei zentimeter hoeher"),
        ("zwei Zentimeter zurück", "zwei zentimeter zuruck"),
        ("öffne die Hand", "offne die hand"),
        ("schließe die Hand", "schliesse die hand"),
        ("fünf Millimeter nach vorne", "fuenf millimeter nach vorne"),
    ],
)
def test_umlauts_may_be_typed_in_any_way(text: str, typed: str) -> None:
    told, meant = (understand(one, PRACTICE, "german").acts for one in (text, typed))
    assert told == meant != (Unknown(),)


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("das Ziel steht 5 cm weiter rechts", (SetPose("Ziel", by_mm=(0.0, -50.0, 0.0)),)),
        ("die Hand ist 5 cm zu weit rechts", (Translate("left", distance_m=0.05),)),
        (
            "zwei Zentimeter nach links und einen nach oben",
            (Translate("left", distance_m=0.02), Translate("up", distance_m=0.01)),
        ),
        (
            "mach die Hand zu und dann hoch damit",
            (Gripper("close"), Translate("up")),
        ),
        ("die Hand ist zu hoch", (Translate("down"),)),
        (
            "ein Stückchen höher und dann mach die Hand auf",
            (Translate("up", "little"), Gripper("open")),
        ),
        ("zwei Zehntelmillimeter nach rechts", (Translate("right", distance_m=0.0002),)),
    ],
)
def test_places_are_told_apart_from_corrections(text: str, acts: Any) -> None:
    assert understand(text, PRACTICE, "german").acts == acts


@pytest.mark.parametrize("name", ["der rote Becher", "den roten Becher", "dem roten Becher"])
def test_names_have_no_article(name: str) -> None:
    (act,) = understand(f"{name} steht 5 cm weiter links", PRACTICE, "german").acts
    assert isinstance(act, SetPose)
    assert act.object == "roter Becher"


@pytest.mark.parametrize("text", ["zum zweiten Schritt", "zweiter Schritt", "jetzt das zweite"])
def test_places_in_a_row_may_be_bent(text: str) -> None:
    assert understand(text, Listening(stage="demonstration"), "german").acts == (Cue(2),)


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("d'Zange uffmache", "die Zange aufmachen"),
        ("a bissle nach henta", "ein bisschen nach hinten"),
        ("zwoi Zentimeter nuff", "zwei Zentimeter hinauf"),
        ("net so schnell", "nicht so schnell"),
        ("mach ma de Hand uff", "mach mal die Hand auf"),
        ("zwee Zentimeter höha", "zwei Zentimeter höher"),
        ("wat haste jesacht?", "was hast du gesagt?"),
        ("nomml von vorn", "nochmal von vorn"),
    ],
)
def test_dialect_means_what_plain_german_does(text: str, plain: str) -> None:
    told, meant = (understand(one, PRACTICE, "german").acts for one in (text, plain))
    assert told == meant != (Unknown(),)


@pytest.mark.parametrize("text", ["Halten Sie augenblicklich inne!", "halt mal an", "halt an"])
def test_a_stop_is_understood_in_every_order_of_its_words(text: str) -> None:
    assert understand(text, PRACTICE, "german").acts == (Stop(),)


@pytest.mark.parametrize("text", ["Reihenfolge egal", "beliebige Abfolge", "das ist doch wurscht"])
def test_an_order_that_does_not_matter_names_no_steps(text: str) -> None:
    listening = Listening(stage="introduction", asked="order")
    assert understand(text, listening, "german").acts == (Unordered(()),)


@pytest.mark.parametrize(
    ("text", "factor"), [("Korrektur halbieren", 0.5), ("letzte Korrektur verdoppeln", 2.0)]
)
def test_verbs_of_doubling_tell_a_factor(text: str, factor: float) -> None:
    assert understand(text, PRACTICE, "german").acts == (AdjustLast(factor=factor),)


@pytest.mark.parametrize("text", ["die Hand schlurft nach links", "bring glimpfig was nach oben"])
def test_unexplained_words_lower_confidence(text: str) -> None:
    assert understand(text, PRACTICE, "german").confidence < 0.85


def test_a_unit_said_once_counts_for_all() -> None:
    (first, second) = understand("two centimeters left and one up", PRACTICE).acts
    assert first == Translate("left", distance_m=0.02)
    assert second == Translate("up", distance_m=0.01)


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("nicht nach links, nach rechts", {"act": "translate", "direction": "right"}),
        ("Öffnen Sie bitte die Hand", {"act": "gripper", "command": "open"}),
        ("mach d'Hand auf", {"act": "gripper", "command": "open"}),
        ("I zeig dir's noch amal", {"act": "go_back", "stage": "demonstration"}),
        ("des war z'wenig", {"act": "adjust_last", "change": "more"}),
        ("anheben endet bei 7,5 Sekunden, nicht später", {"act": "move_cut", "at_s": 7.5}),
        ("die Schale steht fünf Zentimeter weiter vorn", {"act": "set_pose"}),
        ("schneler bitte", {"act": "adjust_speed", "change": "faster"}),
    ],
)
def test_word_order_dialect_and_slips_are_read(text: str, act: dict[str, Any]) -> None:
    stage: Any = "learning" if act["act"] == "move_cut" else "practice"
    (told,) = understand(text, Listening(stage=stage), "german").acts
    assert act.items() <= act_to_json(told).items()


@pytest.mark.parametrize("name", ["Äpfel in den Korb legen", "den Block auf das Ziel stellen"])
def test_a_name_keeps_what_is_done_with_what_and_where(name: str) -> None:
    asked = Listening(stage="introduction", asked="task_name")
    assert understand(name, asked, "german").acts == (Inform(name),)


@pytest.mark.parametrize(
    ("text", "first", "second"),
    [
        ("Zudrehen darf nie vor Einfüllen kommen", "Einfüllen", "Zudrehen"),
        ("Einfüllen darf nicht nach Zudrehen kommen", "Einfüllen", "Zudrehen"),
        ("das Einfüllen darf keinesfalls nach dem Zudrehen kommen", "Einfüllen", "Zudrehen"),
        ("das Backen kommt nie nach dem Schneiden", "Backen", "Schneiden"),
        ("niemals Zudrehen vor Einfüllen", "Einfüllen", "Zudrehen"),
        ("Einfüllen muss vor Zudrehen kommen", "Einfüllen", "Zudrehen"),
    ],
)
def test_what_is_forbidden_is_not_wanted(text: str, first: str, second: str) -> None:
    asked = Listening(stage="introduction", asked="order")
    assert understand(text, asked, "german").acts == (Ordered(first, second),)


@pytest.mark.parametrize("text", ["zeig nochmal den Baum", "zeig mir bitte noch einmal den Plan"])
def test_what_is_shown_once_more_is_no_practice(text: str) -> None:
    (act,) = understand(text, PRACTICE, "german").acts
    assert isinstance(act, Show)


@pytest.mark.parametrize(
    "text",
    ["das ist halt so", "halt fest", "halt die Klappe", "halt dich kurz", "mach halt weiter"],
)
def test_a_halt_that_is_none_stops_nothing_at_rest(text: str) -> None:
    assert Stop() not in understand(text, PRACTICE, "german").acts


@pytest.mark.parametrize("text", ["hey stopp, pass auf", "halt halt halt, das wird nix"])
def test_a_stop_among_calls_stops(text: str) -> None:
    assert understand(text, PRACTICE, "german").acts == (Stop(),)
