"""How big things are, told beside what was asked: "the jar is 6 cm tall, 5 wide"."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from functools import cache

from assistant.dialogue.asking import proceed, tell
from assistant.dialogue.bodies import size_line, with_body
from assistant.dialogue.doubting import is_guess, without_guess
from assistant.dialogue.introduction import all_understood
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.state import AwaitingShow, Dialogue, Introducing
from assistant.dialogue.things import placed, things_in
from assistant.dialogue.turn import Turn, Words, changed, first, line, say
from assistant.language.actions import mentioned_objects, read_action
from assistant.language.bodies import read_body, read_lengths_mm
from assistant.language.hints import hints, matter, mentions
from assistant.model import teacher_acts as acts
from assistant.model.task import TaskObject

LONGEST_THING = 3
"""Words of a thing's name out of a sentence; more are a piece of it."""
DEEP_MM = 60.0
"""Nobody puts a thing so far below a table's top, however coarsely they measure."""


def told_size(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Take a size that was not asked for as what it is, never as an answer; None for other talk."""
    state, free, text = dialogue.state, without_guess(dialogue), words.text
    between = dialogue.pending is not None and not is_guess(dialogue.pending)
    talked = isinstance(state, AwaitingShow | Introducing) and not between
    if not talked or "?" in text or not tells_size(text, dialogue.language):
        return None
    if isinstance(state, Introducing) and state.asked == "objects" and not state.index:
        return _things_with_sizes(free, text)
    asked = state.asked if isinstance(state, Introducing) else ""
    if asked != "body" and not _described(free, text):
        # "500 x 100 x 240" answers where it is, and "move it 10 cm" what is done.
        return None
    thing = _thing_meant(free, text)
    if isinstance(state, Introducing) and state.asked == "body" and thing in ("", state.thing):
        return None
    if not thing:
        goal = isinstance(state, Introducing) and state.asked == "goal"
        return tell(free, line("error", "size_no_goal")) if goal else None
    sized = _with_size(free.known, thing, text)
    if sized == free.known:
        return None
    naming = isinstance(state, Introducing) and state.asked == "task_name"
    # A name that was guessed is asked for again.
    told = say(free, size_line(sized, thing))[1]
    return first(told, proceed(changed(dialogue if naming else free, "body", sized)))


def _described(dialogue: Dialogue, text: str) -> bool:
    """Whether words of size stand beside the numbers of a text, or a shape."""
    language, state = dialogue.language, dialogue.state
    told = mentions(text, hints("size_words", language)) or _in_a_table(dialogue, text)
    if isinstance(state, Introducing) and state.asked != "goal":
        told = told or bool(matter(text, "shapes", language))
    plain = without_sizes(text, language)
    return told and read_action(plain, (), language).action is None


def _in_a_table(dialogue: Dialogue, text: str) -> bool:
    """Whether lengths "by" each other, taken for a place, would lie deep in every table.

    "15 by 15 by 1 cm" is how big a thing is, also where it was asked where it is.
    """
    state, language = dialogue.state, dialogue.language
    sides = read_lengths_mm(text, language)
    between = any(one in text.lower() for one in hints("size_by", language))
    if not isinstance(state, Introducing) or state.asked != "pose" or len(sides) != 3:
        return False
    tops = [one.xyz_mm[2] + one.size_mm[2] for one in dialogue.known.scene.tables]
    return between and bool(tops) and sides[2] < min(tops) - DEEP_MM


def tells_size(text: str, language: str) -> bool:
    """Whether a text tells a size, and not where something is or how far it goes."""
    return bool(_size(language).search(_of_size(text, language)))


def _of_size(text: str, language: str) -> str:
    """Return the pieces of a text that tell no place and no way."""
    pieces = re.split(r"[,;.]\s", text)
    return ", ".join(one for one in pieces if not mentions(one, hints("no_size", language)))


def without_sizes(text: str, language: str) -> str:
    """Return a text without the sizes in it."""
    return re.sub(r"\(\s*\)", " ", _size(language).sub(" ", text)).strip()


def _thing_meant(dialogue: Dialogue, text: str) -> str:
    """Return the thing whose size a text tells: named, the one not described yet, or a new one."""
    known, state, language = dialogue.known, dialogue.state, dialogue.language
    things = known.objects or ()
    named = mentioned_objects(text, things, language)
    if matter(text, "shapes", language) or mentions(text, hints("pronouns", language)):
        # "A flat box" is the one asked about, whatever else is a box.
        named = tuple(one for one in named if mentions(text, (one.lower(),)))
    if len(named) == 1:
        return named[0]
    pronoun = mentions(text, hints("pronouns", language))
    if isinstance(state, Introducing) and state.asked == "pose":
        lacking = [one.name for one in things if one.name not in known.scene.bodies]
        return lacking[0] if len(lacking) == 1 and not pronoun else state.thing
    if named or known.objects is not None:
        return ""
    new = _named(without_sizes(text, language), dialogue)
    return new[0].name if len(new) == 1 else ""


def _named(text: str, dialogue: Dialogue) -> tuple[TaskObject, ...]:
    """Return the things a sentence names, without its other pieces."""
    found = things_in(text, dialogue.known.scene, dialogue.language)
    return tuple(one for one in found if len(one.name.split()) <= LONGEST_THING)


def _things_with_sizes(dialogue: Dialogue, text: str) -> Turn | None:
    """Take the things of a sentence with the sizes told behind or before their names."""
    known, language = dialogue.known, dialogue.language
    plain = without_sizes(text, language)
    things = placed(_named(plain, dialogue), (plain,), known.scene, language)
    if not things:
        return None
    if len(things) == 1 and mentions(text, hints("standing", language)):
        # "The jar is 6 cm tall" names one thing of those that are asked for.
        told = _with_size(known, things[0].name, text)
        noted = changed(dialogue, "body", told)
        return tell(noted, size_line(told, things[0].name)) if told != known else None
    sized = all_understood(replace(known, objects=things))
    for thing, clause in _clauses(text, things):
        sized = _with_size(sized, thing.name, clause)
    lines = [line("done", "things", names=[one.name for one in things])]
    new = [one.name for one in things if sized.scene.bodies.get(one.name) is not None]
    lines += [size_line(sized, name) for name in new if name in sized.shaped]
    after = changed(dialogue, "objects", sized, clean=dialogue.clean)
    return first(say(after, *lines)[1], proceed(after))


def _clauses(text: str, things: tuple[TaskObject, ...]) -> list[tuple[TaskObject, str]]:
    """Return each thing with the words from its name to the next one's; the first's from before."""
    lowered = text.lower()
    found = sorted((lowered.find(one.name.lower()), one.name, one) for one in things)
    starts = [at for at, _, _ in found if at >= 0]
    if not starts:
        return []
    ends = (*starts[1:], len(text))
    led = [0 if not number else at for number, at in enumerate(starts)]
    there = [one for at, _, one in found if at >= 0]
    return [(one, text[a:z]) for one, a, z in zip(there, led, ends, strict=True)]


def _with_size(known: Knowledge, thing: str, text: str) -> Knowledge:
    sizes = _size(known.language).finditer(_of_size(text, known.language))
    told = " ".join(hit.group() for hit in sizes)
    body = read_body(told, known.language, f"{text} {thing}")
    if body.size_mm is None:
        return known
    return with_body(known, thing, body.shape or "box", body.size_mm)


@cache
def _size(language: str) -> re.Pattern[str]:
    """Return what matches a number with a unit, with a word of size, or with another number."""

    def any_of(words: Iterable[str]) -> str:
        return "|".join(map(re.escape, sorted(words, key=len, reverse=True)))

    number = rf"(?:\d+(?:[.,]\d+)?|\b(?:{any_of(hints('numbers', language))})\b)"
    unit = rf"(?:(?:{any_of(hints('units', language))})\b)"
    kind = rf"\b(?:{any_of(hints('size_words', language))})\b"
    by = rf"(?:{any_of(hints('size_by', language))})"
    length = rf"{number}\s*{unit}?"
    told = rf"{length}(?:\s*{by}\s*{length})+|{number}\s*{unit}|{number}(?=\s*{kind})"
    return re.compile(rf"(?:{told})(?:\s*{kind})?", re.IGNORECASE)
