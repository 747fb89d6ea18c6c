"""What explains the sound best is what was said; what has a likely rival is asked about."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import (
    Cue,
    Deny,
    Explain,
    Gripper,
    Inform,
    Stop,
    Translate,
)
from assistant.shells.voice import choosing
from assistant.shells.voice.choosing import REPAIRS_TRIED, Chooser
from assistant.shells.voice.deciding import SURE, decided, is_unknown
from assistant.shells.voice.repairing import repaired
from assistant.shells.voice.sound import Samples
from assistant.shells.voice.weighing import Candidate
from tests.shells.voice.reading import (
    A_SECOND,
    NAMING,
    PRACTICE,
    Reads,
    Weighs,
    acted_on,
    heard,
)


@pytest.mark.voice
def test_what_explains_the_sound_best_wins_though_nobody_read_it() -> None:
    slow = Weighs({"stop": -1.0, "star": -4.0, "stock": -6.0}, ("stock", 0.5))
    assert acted_on(heard(Reads(("star", 1.0)), slow)) == (Stop(),)


@pytest.mark.voice
def test_what_explains_the_sound_badly_is_nothing() -> None:
    slow = Weighs({"yes": -16.0, "good": -19.0}, ("stock", 0.5))
    assert is_unknown(heard(Reads(("star", 1.0)), slow).understanding)


@pytest.mark.voice
def test_two_likely_meanings_are_asked_about() -> None:
    slow = Weighs({"left": -2.0, "right": -2.3}, ("light", 0.5))
    one = heard(Reads(("light", 1.0)), slow)
    assert acted_on(one) == ()
    assert one.understanding.acts == (Translate("left"),)


@pytest.mark.voice
def test_a_name_is_mended_if_that_explains_the_sound() -> None:
    slow = Weighs({"please object": -3.0, "place object": -3.5}, ("please object", 0.3))
    one = heard(Reads(("pleas object", 1.0)), slow, NAMING)
    assert one.understanding.acts == (Inform("place object"),)


@pytest.mark.voice
def test_nobody_says_please_within_a_name() -> None:
    told = {"please object": -0.6, "place object": -6.5}
    one = heard(Reads(("prease object", 1.0)), Weighs(told, (next(iter(told)), 0.9)), NAMING)
    assert one.text == "place object"


@pytest.mark.voice
def test_a_name_that_sounds_like_another_is_asked_about() -> None:
    told = {"open lid": -1.0, "open lit": -2.8}
    one = heard(Reads(("open lit", 1.0)), Weighs(told, ("open lid", 0.3)), NAMING)
    assert one.understanding.acts == (Inform("open lid"),)
    assert one.sure < SURE


WATCHING = Listening(stage="demonstration")


@pytest.mark.voice
def test_a_cue_is_no_answer() -> None:
    told = {"now": -4.0, "no": -2.5}
    one = heard(Reads(("no", 1.0)), Weighs(told, ("no", 0.9)), WATCHING)
    assert one.understanding.acts == (Cue("next"),)
    asked = heard(Reads(("no", 1.0)), Weighs(told, ("no", 0.9)), replace(WATCHING, asked="ready"))
    assert asked.understanding.acts == (Deny(),)


@pytest.mark.voice
def test_an_unusual_number_is_asked_about() -> None:
    asked = Listening(stage="introduction", asked="subtask_count")
    one = heard(Reads(("ten", 1.0)), Weighs({"ten": -1.0}, ("ten", 0.9)), asked)
    assert one.understanding.acts == (Inform(10),)
    assert one.understanding.confidence < SURE


@pytest.mark.voice
def test_numbers_that_sound_alike_are_asked_about() -> None:
    asked = Listening(stage="introduction", asked="subtask_count")
    slow = Weighs({"two": -2.0, "three": -2.2}, ("tea", 0.5))
    one = heard(Reads(("tea", 1.0)), slow, asked)
    assert one.understanding.confidence < SURE


@pytest.mark.voice
def test_a_likely_reading_that_means_nothing_outweighs_a_command() -> None:
    slow = Weighs({"quit": -6.0, "quite cold": -0.5}, ("quite cold", 0.9))
    assert is_unknown(heard(Reads(("quite cold", 1.0)), slow).understanding)


def test_what_is_expected_is_asked_about_though_its_meaning_is_doubtful() -> None:
    doubtful = Understanding((Translate("right"),), 0.2, "right")
    told = (Candidate("right", -1.0, 0.9, expected=True), Candidate("write", -5.0, 0.1))
    one = decided(told, lambda text: doubtful)
    assert one.understanding.acts == (Translate("right"),)
    assert one.understanding.confidence < SURE
    unexpected = decided((Candidate("right", -1.0, 1.0),), lambda text: doubtful)
    assert is_unknown(unexpected.understanding)


@pytest.mark.parametrize(("clear_db", "acted"), [(60.0, True), (17.0, True), (10.0, False)])
def test_in_a_loud_room_what_explains_the_sound_badly_is_asked_about(
    clear_db: float, acted: bool
) -> None:
    meant = Understanding((Translate("right"),), 1.0, "to the right")
    told = (Candidate("to the right", -6.5, 0.9, expected=True),)
    one = decided(told, lambda text: meant, clear_db)
    assert one.understanding.acts == meant.acts
    assert (one.understanding.confidence >= SURE) == acted


@pytest.mark.voice
@pytest.mark.parametrize(
    ("likely", "said"),
    [(-4.0, "place object on target"), (-9.0, "place object and target")],
)
def test_two_things_are_related_in_a_name(likely: float, said: str) -> None:
    read = "place object and target"
    slow = Weighs({read: -3.0, "place object on target": likely}, (read, 0.9))
    assert heard(Reads((read, 1.0)), slow, NAMING, A_SECOND).text == said


@pytest.mark.voice
def test_a_sentence_nearly_read_is_found() -> None:
    told = {"close the ripper": -5.0, "close the gripper": -4.0}
    one = heard(
        Reads(("close the ripper", 1.0)), Weighs(told, ("close the ripper", 0.6)), sound=A_SECOND
    )
    assert acted_on(one) == (Gripper("close"),)
    # It must explain the sound: chat that is nearly a command is chat.
    told["close the gripper"] = -12.0
    one = heard(
        Reads(("close the ripper", 1.0)), Weighs(told, ("close the ripper", 0.6)), sound=A_SECOND
    )
    assert acted_on(one) == ()


@pytest.mark.voice
def test_few_of_the_sentences_nearly_read_are_understood(monkeypatch: pytest.MonkeyPatch) -> None:
    # To understand all of them took longer than to recognize what was said.
    understood: list[str] = []

    def noted(text: str, listening: Listening, language: str = "english") -> Understanding:
        understood.append(text)
        return understand(text, listening, language)

    monkeypatch.setattr(choosing, "understand", noted)
    read = "to mend the left most part of it now"
    assert len(repaired(read)) > 3 * REPAIRS_TRIED
    list(Chooser(Weighs({}))._made(read, PRACTICE))
    assert 1 < len(understood) <= REPAIRS_TRIED + 1


@pytest.mark.voice
def test_what_sounds_like_nothing_that_was_read_is_not_weighed() -> None:
    class Notes(Weighs):
        weighed: tuple[str, ...] = ()

        def likelihoods(
            self, samples: Samples, phrases: Sequence[str], *, loud: bool = False
        ) -> tuple[float, ...]:
            self.weighed += tuple(phrases)
            return super().likelihoods(samples, phrases, loud=loud)

    slow = Notes({}, ("slow her", 0.5))
    heard(Reads(("slower hair", 1.0)), slow, sound=A_SECOND)
    assert {"slower", "slow her", "slower hair"} <= set(slow.weighed)
    assert not {"help", "yes", "undo"} & set(slow.weighed)


@pytest.mark.voice
def test_a_whole_sentence_that_was_read_is_weighed_against_readings_only() -> None:
    class Counts(Weighs):
        asked_about = 0

        def likelihoods(
            self, samples: Samples, phrases: Sequence[str], *, loud: bool = False
        ) -> tuple[float, ...]:
            self.asked_about += len(phrases)
            return super().likelihoods(samples, phrases, loud=loud)

    text = "move a bit more to the left"
    slow = Counts({text: -2.0, "mother bit more": -9.0}, (text, 0.9), ("mother bit more", 0.2))
    one = heard(Reads(("mother", 1.0)), slow, sound=A_SECOND)
    assert acted_on(one) == (Translate("left", "little"),)
    assert slow.asked_about == 3


@pytest.mark.voice
def test_a_number_is_heard_where_a_little_word_was_read() -> None:
    told = {"up to centimeters": -2.0}
    text = "up to centimeters"
    one = heard(Reads((text, 1.0)), Weighs(told, (text, 0.9)), sound=A_SECOND)
    assert acted_on(one) == (Translate("up", distance_m=0.02),)
    assert one.text == "up two centimeters"


@pytest.mark.voice
def test_how_a_question_is_spelled_does_not_divide_it() -> None:
    ways = ("how do you know the block is held", "how do you know the block is helped")
    slow = Weighs(dict.fromkeys(ways, -4.0), *((way, 0.5) for way in ways))
    assert isinstance(acted_on(heard(Reads((ways[0], 1.0)), slow, sound=A_SECOND))[0], Explain)
