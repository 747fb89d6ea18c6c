"""Names keep the dress the teacher gave them, whatever form words are compared in."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.language.surface import dressed, plain_name, plainly
from assistant.language.understanding import understand
from assistant.language.words import plain
from assistant.model.listening import Listening
from assistant.model.teacher_acts import (
    Compare,
    Inform,
    Load,
    Optional,
    Rename,
    Save,
    TeacherAct,
    Translate,
    Where,
)

WORDS = st.sampled_from(["press", "fit", "Vial", "DIP", "socket", "tray", "grip", "Lid"])
JOINTS = st.sampled_from([" ", "-", "_", " - "])
PRACTICE = Listening("practice")


@st.composite
def names(draw: st.DrawFn) -> str:
    """Return a name of one to three words, joined in any way."""
    told = draw(WORDS)
    for word in draw(st.lists(WORDS, max_size=2)):
        told += draw(JOINTS) + word
    return told


def acts(
    text: str, listening: Listening = PRACTICE, language: str = "en"
) -> tuple[TeacherAct, ...]:
    return understand(text, listening, language).acts


@given(names())
def test_a_name_goes_out_as_it_stands_in_the_line(name: str) -> None:
    out = dressed(
        (Save(plain_name(name.replace(" - ", " "))),), f"save it as {name}", PRACTICE, "en"
    )
    assert out == (Save(name),)


@given(names())
def test_a_known_name_goes_out_as_the_task_knows_it(name: str) -> None:
    known = Listening("practice", subtasks=(name,))
    (plain,) = plainly(known).subtasks
    out = dressed((Optional(plain),), f"skip the {plain.upper()}", known, "en")
    assert out == (Optional(name),)


@given(st.text(max_size=60), names())
def test_any_line_is_taken(text: str, name: str) -> None:
    out = dressed((Save(plain_name(name)),), text, PRACTICE, "de")
    assert isinstance(out[0], Save)
    assert plain_name(str(out[0].name)) == plain_name(name)


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("please store this lesson as vial-protocol", Save("vial-protocol")),
        ("save it as Robin's_task v2", Save("Robin's_task v2")),
        ("rename Lift-off to lift", Rename("Lift-off", "lift")),
        ("LOAD DIP-SOCKET", Load("dip-socket")),
    ],
)
def test_a_sentence_keeps_the_hyphens_and_capitals_of_its_names(text: str, act: TeacherAct) -> None:
    assert acts(text) == (act,)


def test_a_step_with_a_hyphen_is_referred_to_with_and_without() -> None:
    known = Listening("practice", subtasks=("Pre-align", "press-fit"))
    for text in ("you can skip pre-align", "you can skip pre align", "you can skip the Pre-Align"):
        assert acts(text, known) == (Optional("Pre-align"),)
    (found,) = acts("down 3 mm before press fit", known)
    assert isinstance(found, Translate)
    assert found.where == Where("press-fit", "before")


def test_a_capital_that_only_begins_the_sentence_is_no_part_of_an_english_name() -> None:
    asked = Listening("introduction", "task_name")
    assert acts("Stacking", asked) == (Inform("stacking"),)
    assert acts("Press-Fit and Glue", asked) == (Inform("Press-Fit and Glue"),)


def test_german_nouns_keep_their_capitals() -> None:
    asked = Listening("introduction", "task_name")
    assert acts("Becher stapeln", asked, "de") == (Inform("Becher stapeln"),)
    out = dressed((Inform("roter becher"),), "nimm den roten Becher", asked, "de")
    assert out == (Inform("roter Becher"),)


@pytest.mark.parametrize("name", ["V-seat", "vortex-10s", "B-12", "run-07b", "heat-sink HS2"])
def test_a_name_with_a_letter_or_a_code_stays_whole(name: str) -> None:
    assert acts(f"rename grip to {name}") == (Rename("grip", name),)
    assert acts(f"compare with {name}") == (Compare(name),)
    known = Listening("learning", subtasks=("grip", name))
    assert acts(f"{name} is optional", known) == (Optional(name),)


def test_a_code_may_be_said_without_its_hyphen() -> None:
    known = Listening("learning", subtasks=("grip", "V-seat"))
    assert acts("v seat is optional", known) == (Optional("V-seat"),)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("w-wait", "w-wait"),
        ("x-50 y-120", "x-50 y-120"),
        ("5-mm", "5-mm"),
        ("pick-up", "pick-up"),
        ("step-2", "step-2"),
        ("V-block's", "v_block's"),
        ("T-10", "t_10"),
    ],
)
def test_only_names_are_kept_whole(text: str, told: str) -> None:
    assert plain(text) == told


def test_a_part_of_a_compound_goes_out_whole() -> None:
    assert dressed((Save("heat"),), "save the heat-sink", PRACTICE, "en") == (Save("heat-sink"),)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("loadin' the vise", "loadin' the vise"),
        ("liftin'", "liftin'"),
        ("'loading'", "loading"),
        ("it's called 'press fit'", "press fit"),
    ],
)
def test_a_letter_left_out_is_marked_and_quotes_are_not_part_of_a_name(
    text: str, name: str
) -> None:
    assert acts(text, Listening(asked="task_name")) == (Inform(name),)
