"""Words are heard for what was asked before a guess, unless they answer the guess."""

from __future__ import annotations

from pathlib import Path

import pytest

from assistant.dialogue.machine import begin
from assistant.model import teacher_acts as acts
from assistant.session.meaning import SAFETY, meant
from tests.dialogue.teaching import Lessons
from tests.session.lessons import opened


def guessing() -> Lessons:
    """Return a lesson where a shape is asked for and a guess was read back."""
    teacher = Lessons().open()
    return teacher.hear(acts.Inform("stacking"), text="stacking", sure=0.6)


def test_who_answers_past_a_guess_answers_what_was_asked_before_it() -> None:
    found = meant(guessing().dialogue, "it is called sorting", 1.0, "english")
    assert found.acts == (acts.Inform("sorting"),)


def test_a_yes_to_a_guess_is_a_yes() -> None:
    assert meant(guessing().dialogue, "yes", 1.0, "english").acts == (acts.Affirm(),)


def test_words_not_surely_recognized_are_not_surely_meant() -> None:
    assert meant(Lessons().ready().dialogue, "go", 0.5, "english").confidence <= 0.5


def test_while_the_arm_moves_a_stop_word_is_a_stop() -> None:
    moving = Lessons().ready().moving().dialogue
    assert meant(moving, "don't stop", 1.0, "english").acts == (acts.Stop(),)


def test_of_much_talk_the_sentence_that_means_something_is_guessed_at() -> None:
    opened = Lessons().open().dialogue
    talk = "I don't hold with computers. But all right. I want you to put the bowl on the tray."
    found = meant(opened, talk, 1.0, "english")
    assert found.acts == (acts.Inform("put the bowl on the tray"),)
    assert found.confidence < SAFETY.act_confidence
    ready = Lessons().ready().dialogue
    fast = "My word, that was quick. A bit slower, if you please, my eyes are old."
    assert meant(ready, fast, 1.0, "english").acts == (acts.AdjustSpeed("slower", "little"),)


def test_much_talk_about_nothing_is_no_name() -> None:
    opened = Lessons().open().dialogue
    talk = "Good evening. My late husband built cabinets, you know. So what is it you want from me?"
    assert meant(opened, talk, 1.0, "english").acts == (acts.Unknown(),)


@pytest.mark.parametrize(
    ("letter", "language"), [("y", "english"), ("Y.", "english"), ("j", "german")]
)
def test_a_letter_is_a_yes_or_a_no(letter: str, language: str) -> None:
    guess = Lessons(begin(language)).open().hear(acts.Inform("tidy up now"), text="x", sure=0.6)
    assert guess.asked == "did_you_mean"
    yes = meant(guess.dialogue, letter, 1.0, language)
    no = meant(guess.dialogue, "n", 1.0, language)
    assert (yes.acts, no.acts) == ((acts.Affirm(),), (acts.Deny(),))
    assert min(yes.confidence, no.confidence) >= SAFETY.act_confidence


def test_control_signs_come_into_no_name(tmp_path: Path) -> None:
    session = opened(tmp_path)
    for words in ("sort\x07 it", "all is\x1b tidy", "the \x08 lid and the \x7ftarget"):
        session.hear(words)
    known = session.dialogue.known
    told = (known.name, known.goal or "", *(one.name for one in known.objects or ()))
    session.close()
    assert len(told) > 3
    assert all(name.isprintable() for name in told)


@pytest.mark.parametrize(
    ("text", "language", "kind"),
    [
        ("merge step 2 and 3", "english", acts.Merge),
        ("fass Schritt 2 und 3 zusammen", "german", acts.Merge),
        ("Schritt 2 und 3 zusammenfassen", "german", acts.Merge),
        ("nenn den ersten Schritt Anfahren", "german", acts.Rename),
        ("three steps", "english", acts.Inform),
        ("I count three", "english", acts.Inform),
        ("so drei vielleicht", "german", acts.Inform),
    ],
)
def test_a_step_called_by_its_number_is_no_count(text: str, language: str, kind: type) -> None:
    teacher = Lessons(begin(language)).open().tell("stack").tell("done").tell(("block", "target"))
    assert teacher.asked == "subtask_count"
    assert isinstance(meant(teacher.dialogue, text, 1.0, language).acts[0], kind)
