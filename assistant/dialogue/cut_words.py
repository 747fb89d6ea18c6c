"""Which cut a teacher means, and where to: "move the second cut half a second later".

Cuts are counted as the parts are told: the second cut ends the second part. A cut is also the
one between two steps, or the one at a time that was told of it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from itertools import pairwise

from assistant.dialogue.asking import tell
from assistant.dialogue.doubting import is_guess, without_guess
from assistant.dialogue.finding import find, name_at
from assistant.dialogue.recutting import cuts_of, put_cut, stepped
from assistant.dialogue.sketch import names
from assistant.dialogue.state import Dialogue
from assistant.dialogue.turn import Turn, Words, line
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Lesson

SAME_S = 0.06
"""Times are told to a tenth of a second."""


def recut(dialogue: Dialogue, words: Words, meant: Iterable[acts.TeacherAct]) -> Turn | None:
    """Move the cut that a sentence tells to where it tells; None for other talk."""
    lesson, pending = dialogue.known.lesson, dialogue.pending
    if lesson is None or "?" in words.text or (pending is not None and not is_guess(pending)):
        return None
    later, earlier = (_says(words.text, way, dialogue.language) for way in ("later", "earlier"))
    told = _times(words.text, dialogue.language)
    cut = _numbered(words.text, lesson, dialogue.language)
    if cut is None:
        cut = _between(dialogue, words.text, lesson)
    if cut is None and len(told) > 1:
        cut = _at_time(told, lesson) if _says(words.text, "cut_words", dialogue.language) else None
        told = told[1:] if cut is not None else told
    if cut is None and told and (later or earlier):
        cut = _ending(dialogue, meant, lesson)
    if cut is None or not (told or later or earlier):
        return None
    free = replace(without_guess(dialogue), arm="rest")
    count = len(cuts_of(lesson))
    if not 0 <= cut < count:
        return tell(free, line("error", "no_cut_number", number=cut + 1, count=count))
    return put_cut(free, lesson, cut, _goal(lesson, cut, told, later=later, earlier=earlier))


def _goal(lesson: Lesson, cut: int, told: list[float], *, later: bool, earlier: bool) -> float:
    """Return where a cut is to be: so much later or earlier, or at a time."""
    now_s = cuts_of(lesson)[cut]
    if later == earlier:
        return told[-1] if told else now_s
    if not told:
        return stepped(lesson, cut, later=later)
    return now_s + told[-1] if later else now_s - told[-1]


def _says(text: str, part: str, language: str) -> bool:
    return mentions(text, hints(part, language))


def _numbered(text: str, lesson: Lesson, language: str) -> int | None:
    """Return the position of a cut called by its number; one there is not, too."""
    found = _numbers(language).search(text)
    if found is None:
        return None
    ordinal, number = found.group("ordinal"), found.group("number")
    if ordinal and ordinal.lower() in hints("last_words", language):
        return len(cuts_of(lesson)) - 1
    values: dict[str, int] = {**hints("numbers", language), **hints("ordinals", language)}
    told = (ordinal or number).lower()
    return (int(told) if told.isdigit() else values[told]) - 1


def _between(dialogue: Dialogue, text: str, lesson: Lesson) -> int | None:
    """Return the position of the cut between two steps that are called by their names."""
    if not _says(text, "cut_words", dialogue.language):
        return None
    lowered = text.lower()
    said = [one for one in names(dialogue.known.root) if mentions(lowered, (one.lower(),))]
    steps = [one.primitive for one in lesson.segmentation.episodes]
    ends = [at for at, pair in enumerate(pairwise(steps)) if len(set(pair) & set(said)) == 2]
    return ends[0] if len(ends) == 1 else None


def _at_time(told: list[float], lesson: Lesson) -> int | None:
    near = [at for at, one in enumerate(cuts_of(lesson)) if abs(one - told[0]) < SAME_S]
    return near[0] if len(near) == 1 else None


def _ending(dialogue: Dialogue, meant: Iterable[acts.TeacherAct], lesson: Lesson) -> int | None:
    """Return the position of the cut that ends the step an understood sentence speaks of."""
    told = next((act for act in meant if isinstance(act, acts.MoveCut)), None)
    index = find(dialogue.known, told.subtask) if told is not None else None
    if index is None:
        return None
    name = name_at(dialogue.known, index)
    steps = [one.primitive for one in lesson.segmentation.episodes]
    hits = [at for at, step in enumerate(steps[:-1]) if step == name]
    return hits[-1] if hits else None


def _times(text: str, language: str) -> list[float]:
    """Return the times a sentence tells, in s, in their order: "6.5", "half a second"."""
    shares: dict[str, float] = hints("shares_of_a_second", language)
    numbers: dict[str, int] = hints("numbers", language)
    told: list[float] = []
    for found in _amounts(language).finditer(text):
        value = found.group("share") or found.group("spelled")
        if value is None:
            told.append(float((found.group("digits") or found.group("at")).replace(",", ".")))
        else:
            plain = " ".join(value.lower().split())
            told.append(shares[plain] if found.group("share") else float(numbers[plain]))
    return told


@cache
def _numbers(language: str) -> re.Pattern[str]:
    ordinals = _any((*hints("ordinals", language), *hints("last_words", language)))
    cuts, spelled = _any(hints("cut_words", language)), _any(hints("numbers", language))
    numbering = _any(hints("numbering_words", language))
    return re.compile(
        rf"\b(?P<ordinal>{ordinals})\s+(?:{cuts})\b"
        rf"|\b(?:{cuts})\s+(?:(?:{numbering})\s+)?(?P<number>\d+|{spelled})(?![.,]?\d)\b",
        re.IGNORECASE,
    )


@cache
def _amounts(language: str) -> re.Pattern[str]:
    seconds, places = _any(hints("second_words", language)), _any(hints("time_places", language))
    shares, spelled = _any(hints("shares_of_a_second", language)), _any(hints("numbers", language))
    return re.compile(
        rf"\b(?P<share>{shares})\b"
        rf"|(?P<digits>\d+(?:[.,]\d+)?)\s*(?:{seconds})\b"
        rf"|\b(?P<spelled>{spelled})\s+(?:{seconds})\b"
        rf"|\b(?:{places})\s+(?P<at>\d+(?:[.,]\d+)?)",
        re.IGNORECASE,
    )


def _any(phrases: Iterable[str]) -> str:
    longest = sorted(phrases, key=len, reverse=True)
    return "|".join(re.escape(one).replace(r"\ ", r"\s+") for one in longest)
