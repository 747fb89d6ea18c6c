"""Readings vote; where they disagree the robot asks; what is chat does nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from assistant.model.listening import Listening
from assistant.model.teacher_acts import (
    Affirm,
    Deny,
    Inform,
    Start,
    Stop,
    TeacherAct,
    Translate,
    Undo,
)
from assistant.shells.voice.deciding import is_unknown
from assistant.shells.voice.hearing import SENTENCES, Hearing, expected, hot_words
from assistant.shells.voice.recognized import Recognized
from assistant.shells.voice.sound import Samples
from tests.shells.voice.reading import (
    A_SECOND,
    NAMING,
    PRACTICE,
    Reads,
    Rereads,
    Weighs,
    acted_on,
    heard,
)


def test_a_whole_sentence_needs_no_second_opinion() -> None:
    slow = Reads(("something else", 0.9))
    one = heard(Reads(("move a bit to the left", 1.0)), slow)
    assert acted_on(one) == (Translate("left", "little"),)
    assert slow.asked == 0


@pytest.mark.parametrize(
    ("read", "asked"),
    [
        ("move it to the left", 1),
        ("move a bit to the left", 0),
        ("go left three centimeters", 0),
        ("please move right", 0),
    ],
)
def test_a_second_opinion_is_asked_for_where_a_bit_may_be_lost(read: str, asked: int) -> None:
    slow = Reads(("move a bit to the left", 0.9))
    heard(Reads((read, 1.0)), slow)
    assert slow.asked == asked


def test_in_noise_a_second_opinion_is_asked_for() -> None:
    slow = Reads(("something else", 0.9))
    noise = (0.1 * np.random.default_rng(1).standard_normal(16000)).astype(np.float32)
    Hearing((Reads(("move a bit to the left", 1.0)), slow)).hear(noise, PRACTICE)
    assert slow.asked == 1


@pytest.mark.voice
def test_a_name_is_always_heard_twice() -> None:
    one = heard(Reads(("pick up the log", 1.0)), Reads(("pick up the block", 0.9)), NAMING)
    assert one.understanding.acts == (Inform("pick up the block"),)


@pytest.mark.parametrize(
    ("quick", "slow", "act"),
    [
        ("star", ("stop", 0.95), Stop()),
        ("yo", ("go", 0.6), Start()),
        ("and you", ("undo", 0.5), Undo()),
        ("left", ("left", 0.3), Translate("left")),
    ],
)
def test_a_likelier_reading_that_means_something_wins(
    quick: str, slow: tuple[str, float], act: TeacherAct
) -> None:
    assert acted_on(heard(Reads((quick, 1.0)), Reads(slow))) == (act,)


def test_readings_that_disagree_are_asked_about() -> None:
    one = heard(Reads(("yep", 1.0)), Reads(("go", 0.3), ("show", 0.1)))
    assert acted_on(one) == ()


def test_one_quick_word_alone_is_not_acted_on() -> None:
    asked = Listening(stage="practice", asked="satisfied")
    one = heard(Reads(("okay", 1.0)), Reads(("it", 0.27), ("hit it", 0.2)), asked)
    assert acted_on(one) == ()
    agreed = heard(Reads(("okay", 1.0)), Reads(("okay", 0.3)), asked)
    assert acted_on(agreed) == (Affirm(),)


@pytest.mark.voice
@pytest.mark.parametrize(
    "chat",
    [
        "the soup needs more pepper",
        "did you see the game last night",
        "he put the car in the garage",
    ],
)
def test_chat_does_nothing(chat: str) -> None:
    assert is_unknown(heard(Reads((chat, 1.0)), Reads((chat, 0.9))).understanding)


def test_while_the_arm_moves_any_reading_may_stop_it() -> None:
    moving = Listening(stage="practice", moving=True)
    readings = Reads(("start", 0.6), ("stop", 0.1))
    assert acted_on(heard(Reads(("top", 1.0)), readings, moving)) == (Stop(),)
    assert acted_on(heard(Reads(("top", 1.0)), readings)) != (Stop(),)


def test_nothing_heard_means_nothing() -> None:
    one = heard(Reads(), Reads())
    assert one.text == ""
    assert is_unknown(one.understanding)


def test_names_of_the_task_are_expected() -> None:
    where = Listening(stage="practice", task="stacking", objects=("red block",))
    assert hot_words(where, expected(where, "english"))[:2] == ("stacking", "red block")


def test_no_single_words_where_a_name_is_asked_for() -> None:
    assert "left" in expected(PRACTICE, "english")
    assert "left" not in expected(NAMING, "english")


def test_counts_where_a_number_is_asked_for() -> None:
    asked = Listening(stage="introduction", asked="subtask_count")
    assert {"none", "two"} <= set(expected(asked, "english"))
    one = heard(Reads(("dune", 1.0)), Reads(("two", 0.4), ("tune", 0.3)), asked)
    assert acted_on(one) == (Inform(2),)


@pytest.mark.parametrize(("room", "loud"), [(1e-4, False), (0.05, True)])
def test_in_a_loud_room_recognizers_take_all_care(room: float, loud: bool) -> None:
    asked: list[bool] = []

    class Notes(Reads):
        def recognize(
            self, samples: Samples, hot_words: Sequence[str] = (), *, loud: bool = False
        ) -> tuple[Recognized, ...]:
            asked.append(loud)
            return super().recognize(samples, hot_words, loud=loud)

    noise = room * np.random.default_rng(1).standard_normal(len(A_SECOND))
    heard(Notes(("up", 1.0)), Notes(("up", 0.9)), sound=(A_SECOND + noise).astype(np.float32))
    assert asked == [loud, loud]


def test_sentences_are_told_to_the_recognizer_where_commands_are_given() -> None:
    assert set(SENTENCES) <= set(hot_words(PRACTICE, ()))
    assert not set(SENTENCES) & set(hot_words(NAMING, ()))
    assert not set(SENTENCES) & set(hot_words(PRACTICE, (), "german"))


LOUD_ROOM = A_SECOND + 0.05 * np.random.default_rng(1).standard_normal(len(A_SECOND)).astype(
    np.float32
)


@pytest.mark.voice
@pytest.mark.parametrize(
    ("again", "acts"),
    [
        (("move left", "note left"), (Translate("left"),)),
        (("mow the lawn", "go left"), (Translate("left"),)),
        (("mow the lawn", "note left"), ()),
        # Where both read either of two commands, it is asked which.
        (("go left", "go right"), ()),
        (("mow the lawn", "note left", "go left"), ()),
    ],
)
def test_in_a_loud_room_what_two_recognizers_read_is_no_longer_doubted(
    again: Sequence[str], acts: Sequence[TeacherAct]
) -> None:
    likely = {"go left": -9.0, "go right": -12.0}
    slow = Weighs(likely, ("go left", 0.5), ("go right", 0.2))
    one = heard(Reads((again[0], 1.0)), slow, sound=LOUD_ROOM)
    assert one.understanding.acts == (Translate("left"),)
    assert acted_on(one) == ()
    quick = Rereads(*((text, 0.3) for text in again))
    assert acted_on(heard(quick, slow, sound=LOUD_ROOM)) == acts


@pytest.mark.voice
def test_in_a_quiet_room_what_is_doubted_stays_so() -> None:
    slow = Weighs({"go left": -9.0}, ("go left", 0.5))
    one = heard(Rereads(("go left", 0.5)), slow, sound=A_SECOND)
    loud = heard(Rereads(("go left", 0.5)), slow, sound=LOUD_ROOM)
    assert (one.sure < 1.0, loud.sure) == (True, 1.0)


@pytest.mark.voice
def test_a_lone_word_stays_doubted_whoever_reads_it_too() -> None:
    slow = Weighs({"no": -9.0}, ("no", 0.5))
    one = heard(Rereads(("no", 0.5)), slow, sound=LOUD_ROOM)
    assert one.sure < 1.0


def test_words_over_and_over_are_noise_but_a_stop_is_a_stop() -> None:
    asked = Listening(stage="practice", asked="satisfied")

    def meant(text: str, now: Listening = asked) -> tuple[TeacherAct, ...]:
        return acted_on(heard(Reads((text, 1.0)), Reads((text, 1.0)), now))

    assert meant(" ".join(["no"] * 40)) == ()
    assert meant("no no no") == (Deny(),)
    assert meant(" ".join(["stop"] * 40), replace(asked, moving=True)) == (Stop(),)
