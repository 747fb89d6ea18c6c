"""Words are heard for what was asked before a guess, unless they answer the guess."""

from __future__ import annotations

from assistant.model import teacher_acts as acts
from assistant.session.meaning import meant
from tests.dialogue.teaching import Lessons


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
