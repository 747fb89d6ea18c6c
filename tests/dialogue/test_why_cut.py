"""Why a cut is where it is, and why there is none where the teacher asks about one."""

from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType

import pytest

from assistant.dialogue.why_cut import told_s
from assistant.language.hints import page
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Lesson, SegmentationPoint
from assistant.model.robot_acts import RobotAct
from assistant.model.settings import VoteSettings
from tests.dialogue.teaching import Lessons, lesson


def with_points(*told: tuple[float, bool]) -> Lesson:
    """Return a lesson with these instants, each kept or not."""
    votes = MappingProxyType({"speed": 0.4, "cue": 0.0})
    points = tuple(SegmentationPoint(at_s, 0.3, votes, kept) for at_s, kept in told)
    plain = lesson()
    return replace(plain, segmentation=replace(plain.segmentation, points=points))


def answer(text: str, shown: Lesson) -> RobotAct:
    teacher = Lessons().ready()
    known = replace(teacher.dialogue.known, lesson=shown)
    teacher.dialogue = replace(teacher.dialogue, known=known)
    return teacher.hear(acts.Explain(text), text=text).lines[0]


CUTS = with_points((2.0, True), (8.5, True), (10.8, False), (13.1, True))


def test_a_time_without_a_cut_is_not_answered_about_another_one() -> None:
    told = answer("why did you cut at 11 s", CUTS)
    assert told.topic == "no_cut_though"
    assert (told.slots["at_s"], told.slots["near_s"]) == (11.0, 10.8)
    assert (told.slots["before_s"], told.slots["after_s"]) == (8.5, 13.1)
    assert told.slots["signals"] == ["speed"]


def test_where_nothing_speaks_for_a_cut_that_is_said() -> None:
    told = answer("why did you cut at 5.5", CUTS)
    assert told.topic == "no_cut_at"
    assert (told.slots["before_s"], told.slots["after_s"]) == (2.0, 8.5)
    told = answer("why did you cut at 40 seconds", CUTS)
    assert (told.slots["before_s"], told.slots["after_s"]) == (13.1, None)


@pytest.mark.parametrize(
    ("text", "at_s"),
    [
        ("why did you cut at 8.5", 8.5),
        ("why did you cut at about 9 s", 8.5),
        ("why did you cut at thirteen seconds, or was it 13?", 13.1),
        ("why did you cut at two", 2.0),
        ("why did you make the second cut", 8.5),
    ],
)
def test_a_cut_that_is_there_is_told_with_its_signals(text: str, at_s: float) -> None:
    told = answer(text, CUTS)
    assert (told.topic, told.slots["at_s"]) == ("cut", at_s)


@pytest.mark.parametrize(
    ("text", "language", "at_s"),
    [
        ("warum hast du bei 8,5 geschnitten", "german", 8.5),
        ("warum schneidest du bei elf sekunden", "german", 11.0),
        ("why is there a cut at twelve", "english", 12.0),
        ("why that one", "english", None),
    ],
)
def test_the_time_is_read_as_it_is_written_or_spoken(
    text: str, language: str, at_s: float | None
) -> None:
    assert told_s(text, language) == at_s


@pytest.mark.parametrize("language", ["english", "german"])
@pytest.mark.parametrize("text", ["why did you cut at 11 s", "why did you cut at 5.5"])
def test_both_languages_say_it_with_the_nearest_cuts(text: str, language: str) -> None:
    said = phrase(answer(text, CUTS), language=language)
    times = ("11.0", "10.8", "8.5", "13.1") if "11" in text else ("5.5", "2.0", "8.5")
    assert all(one in said.replace(",", ".") for one in times)


@pytest.mark.parametrize("language", ["english", "german"])
def test_every_signal_that_votes_has_words(language: str) -> None:
    assert set(VoteSettings().weights) <= set(page("says", language)["signals"])
