"""Everything that completion offers beyond the phrasebook is understood where it is offered."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from assistant.dialogue import events as ev
from assistant.dialogue.machine import listening
from assistant.language.completion import filled
from assistant.language.hints import page
from assistant.model import teacher_acts as acts
from assistant.session.meaning import meant
from tests.dialogue.teaching import Lessons

LOST = ("error", "confirm.did_you_mean", "told.yes_or_no")


def corrected() -> Lessons:
    teacher = Lessons().ready().hear(acts.Inform("x"), text="beside you")
    teacher.hear(acts.Translate("up"), text="up").hear(acts.Translate("down"), text="down")
    return teacher


PLACES: dict[str, Callable[[], Lessons]] = {
    "introduction": lambda: Lessons().introduce(),
    "demonstration": lambda: Lessons().confirmed(),
    "learning": lambda: Lessons().learned(),
    "practice": corrected,
    "moving": lambda: corrected().moving().report("primitive", 1),
    "paused": lambda: corrected().moving().report("primitive", 1).hear(acts.Pause()),
    "stopped": lambda: corrected().moving().report("primitive", 1).hear(acts.Stop()),
}


@pytest.mark.parametrize("language", ["english", "german"])
@pytest.mark.parametrize("place", PLACES)
def test_what_is_offered_is_understood(place: str, language: str) -> None:
    teacher = PLACES[place]()
    known = replace(teacher.dialogue.known, language=language, facing="own")
    there = replace(teacher.dialogue, known=known)
    for text in filled(page("terminal", language)["offers"][place], listening(there)):
        lesson = Lessons(replace(there, misses=0))
        lesson.happen(ev.Heard(text, meant(there, text, 1.0, language)))
        topics = [topic for topic in lesson.topics if topic.startswith(LOST)]
        assert not topics, f"{place}: {text!r} {topics}"
        assert lesson.effects, text
