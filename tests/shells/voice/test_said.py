"""What an utterance and its readings tell about words that may have been said."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import Unknown
from assistant.shells.voice.deciding import Reading
from assistant.shells.voice.said import Said

pytestmark = pytest.mark.voice

NOTHING = Understanding((Unknown(),), 1.0, "")


def said(*readings: tuple[str, float, str], clear_db: float = 10.0) -> Said:
    told = [Reading(text, weight, NOTHING, name) for text, weight, name in readings]
    listening = Listening(stage="practice")
    return Said(np.zeros(1600, np.float32), 1.0, told, (), listening, clear_db)


def test_what_sounds_like_the_readings_is_alike() -> None:
    one = said(("close the ripper", 0.5, "quick"), ("close the grip", 0.8, "slow"))
    own, other = one.alike("close the gripper")
    assert own > one.alike("open the hand")[0]
    assert other > one.alike("open the hand")[1]
    assert one.alike("close the grip")[0] == pytest.approx(1.0)


def test_the_best_reading_is_the_measure_of_others() -> None:
    one = said(("to left", 0.5, "quick"), ("move left", 0.8, "slow"), ("move let", 0.4, "slow"))
    assert one.read["move left"] == pytest.approx(0.0)
    assert one.read["move let"] < 0.0
    assert "to left" not in one.read
    assert one.seconded == {"to left"}


def test_a_recognizer_that_trusts_nothing_it_read_is_in_doubt() -> None:
    sure, unsure = (said(("go", 0.5, "quick"), ("go", trust, "slow")) for trust in (0.95, 0.1))
    assert unsure.doubt > sure.doubt >= 0.0


def test_names_are_no_commands_and_a_quiet_room_is_not_loud() -> None:
    loud = said(("go to the left", 1.0, "slow"))
    assert loud.commanded
    assert not said(("go to the left", 1.0, "slow"), clear_db=40.0).commanded
    assert not replace(loud, listening=Listening(stage="introduction", asked="goal")).commanded


def test_a_word_alone_is_left_to_the_sound() -> None:
    assert not said(("go", 1.0, "slow")).commanded
