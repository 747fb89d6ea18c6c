"""The second-best reading of a sentence, for a teacher who says that the first is not it."""

from __future__ import annotations

from assistant.language.seeking import chance, sought
from assistant.language.understanding import read
from assistant.model.listening import Listening
from assistant.model.teacher_acts import TeacherAct, Unknown

Acts = tuple[TeacherAct, ...]


def second_reading(
    text: str, listening: Listening, first: Acts, language: str = "english"
) -> Acts | None:
    """Return what a sentence means if not what it was taken for; None if nothing is likely.

    Parameters
    ----------
    text : str
    listening : Listening
        As when the sentence was heard.
    first : tuple of TeacherAct
        What it was taken for.
    language : str
    """
    reading = read(text, listening, language)
    if not reading.words or not reading.chances:
        return None
    found = {
        parse.acts: likely
        for parse, likely in sought(reading.heard, reading.hearing, reading.chances)
    }
    found.setdefault(reading.parse.acts, chance(reading.parse.acts, reading.chances))
    others = [acts for acts in found if acts != first and not isinstance(acts[0], Unknown)]
    return max(others, key=lambda acts: found[acts], default=None)
