"""Commands that sound like what was heard: those of the phrasebook, the nearest first."""

from __future__ import annotations

import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Undo
from assistant.shells.voice.deciding import is_unknown
from assistant.shells.voice.phrasebank import MOST_WORDS, mended, named, near, related, sounding

pytestmark = pytest.mark.voice


@pytest.mark.parametrize("said", ["undo", "scratch that", "try again", "open it"])
def test_a_command_is_nearest_to_itself(said: str) -> None:
    assert said in near(said, 2)


@pytest.mark.parametrize(
    ("heard", "said"),
    [("scratch knight", "scratch that"), ("and you", "undo"), ("starbur", "start up")],
)
def test_what_was_misheard_is_found(heard: str, said: str) -> None:
    assert said in near(heard, 8)


def test_phrases_are_short_and_mean_something() -> None:
    found = near("scratch that", 20)
    assert len(found) == 20
    assert all(1 <= len(phrase.split()) <= MOST_WORDS for phrase in found)
    practice = Listening(stage="practice")
    assert understand("scratch that", practice).acts == (Undo(),)
    assert sum(not is_unknown(understand(one, practice)) for one in found) > 10


def test_a_name_is_mended_by_one_word_that_sounds_alike() -> None:
    words = ("place", "target", "open")
    assert mended("please object on target", words) == ("place object on target",)
    assert mended("place object on target", words) == ()


@pytest.mark.parametrize(
    ("heard", "meant"),
    [("move hyper object", "move up object"), ("relief cop", "release cup")],
)
def test_a_step_is_found_by_sound(heard: str, meant: str) -> None:
    assert meant in named(heard, ("cup", "object"), 8)


def test_little_words_between_two_things_may_be_others() -> None:
    things = ("block", "lid")
    assert related("place block and lid", things, ("on",)) == ("place block on lid",)
    assert related("the block into the lid", things, ("and",)) == ("the block and the lid",)
    assert related("grasp and lift", things, ("on",)) == ()
    assert related("", things, ("on",)) == ()


@pytest.mark.voice
def test_what_sounds_like_anything_heard_stays() -> None:
    told = ("go lower", "pause", "go slower", "go")
    assert sounding(told, ("go slower", "paws"), 0.3) == told
    assert sounding(told, ("go slower",), 0.3) == ("go lower", "go slower", "go")
    assert sounding(told, told, 1.0) == told
