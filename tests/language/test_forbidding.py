from typing import Any

import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Assign, Deny, Inform, Resume, Start, Stop


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("english", "don't continue"),
        ("english", "do not go on"),
        ("english", "don't keep going"),
        ("german", "nicht weitermachen"),
        ("german", "fahr nicht weiter"),
        ("german", "bitte nicht weiterfahren"),
        ("german", "beweg dich nicht"),
        ("german", "keinen Millimeter weiter"),
    ],
)
@pytest.mark.parametrize("asked", [None, "satisfied"])
def test_what_is_not_to_go_on_stops(language: str, text: str, asked: Any) -> None:
    heard = Listening(stage="practice", asked=asked)
    assert understand(text, heard, language).acts == (Stop(),)


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("english", "don't stop, go on"),
        ("english", "why don't you continue"),
        ("german", "nicht aufhören, mach weiter"),
        ("german", "nicht anhalten"),
        ("german", "nein, weitermachen"),
    ],
)
def test_what_is_not_to_stop_goes_on(language: str, text: str) -> None:
    assert understand(text, Listening(stage="practice"), language).acts == (Resume(),)


@pytest.mark.parametrize(
    ("language", "text"),
    [("english", "don't start"), ("german", "fang nicht an"), ("german", "noch nicht anfangen")],
)
def test_what_is_not_to_begin_is_no_start(language: str, text: str) -> None:
    heard = Listening(stage="demonstration", asked="ready")
    assert understand(text, heard, language).acts == (Deny(),)


@pytest.mark.parametrize("text", ["do not wait, start", "don't be shy, go"])
def test_a_not_of_another_clause_forbids_no_start(text: str) -> None:
    heard = Listening(stage="demonstration", asked="ready")
    assert understand(text, heard).acts == (Start(),)


@pytest.mark.parametrize("text", ["nicht weiter", "beweg dich nicht", "keinen Millimeter weiter"])
def test_what_forbids_to_go_on_stops_the_moving_arm(text: str) -> None:
    heard = Listening(stage="practice", moving=True)
    assert understand(text, heard, "german").acts == (Stop(),)


def test_a_goal_keeps_its_not() -> None:
    heard = Listening(stage="introduction", asked="goal")
    goal = "die Mutter sitzt auf dem Bolzen und wackelt nicht"
    (act,) = understand(goal, heard, "german").acts
    assert isinstance(act, Inform)
    assert act.value == goal


def test_a_step_a_not_rules_out_is_not_meant() -> None:
    text = "zähle den zweiten Abschnitt bitte zum Fassen, nicht zum Hinfahren"
    heard = Listening(stage="learning", asked="confirm_segmentation")
    assert understand(text, heard, "german").acts == (Assign(2, "Fassen"),)
