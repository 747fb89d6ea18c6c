"""What shape things are, told without a size: "yes, but the jar is round"."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

from assistant.dialogue.asking import proceed
from assistant.dialogue.bodies import size_line, with_body
from assistant.dialogue.doubting import without_guess
from assistant.dialogue.state import AwaitingShow, Dialogue, Introducing
from assistant.dialogue.turn import Turn, Words, changed, first, say
from assistant.language.actions import mentioned_objects
from assistant.language.bodies import shape_in
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts


def told_shape(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Take the shape of a thing whose size was told before; None for other talk."""
    if not isinstance(dialogue.state, AwaitingShow | Introducing) or "?" in words.text:
        return None
    text = " ".join(words.text.lower().split())
    hit = _told(dialogue.language).search(text)
    thing = _thing(dialogue, text[: hit.start()]) if hit else ""
    shape = shape_in(hit.group(1), dialogue.language) if hit else None
    if shape is None or not thing:
        return None
    known = dialogue.known
    x, y, z = known.scene.bodies[thing].size_mm
    # What is round is as wide as its longer side.
    wide = (x, y) if shape == "box" else (max(x, y), max(x, y))
    shaped = with_body(known, thing, shape, (*wide, z))
    told = say(dialogue, size_line(shaped, thing))[1]
    return first(told, proceed(changed(without_guess(dialogue), "body", shaped)))


def _thing(dialogue: Dialogue, text: str) -> str:
    """Return the thing told of before that a text names, or points to; empty if it is unclear."""
    known, state = dialogue.known, dialogue.state
    told = [one for one in known.objects or () if one.name in known.shaped]
    named = mentioned_objects(text, told, known.language)
    if len(named) == 1:
        return named[0]
    pointed = not named and mentions(text, hints("pronouns", known.language))
    asked = state.thing if isinstance(state, Introducing) and pointed else ""
    return asked if asked in known.shaped else ""


@cache
def _told(language: str) -> re.Pattern[str]:
    """Return what matches "the jar is really round", and not "the jar is in the box"."""

    def any_of(phrases: Iterable[str]) -> str:
        return "|".join(map(re.escape, sorted(phrases, key=len, reverse=True)))

    shapes: dict[str, list[str]] = hints("shapes", language)
    shape = any_of(word for words in shapes.values() for word in words)
    between = any_of((*hints("articles", language), *hints("said_softly", language)))
    verb = any_of(hints("is_shaped", language))
    return re.compile(rf"\b(?:{verb}) (?:(?:{between}) )*({shape})\b(?! ?\d)")
