"""What was taken for a thing and is none, and how big the others are taken to be (paper II-A)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from assistant.dialogue.asking import proceed, tell
from assistant.dialogue.bodies import size_line
from assistant.dialogue.naming import alike
from assistant.dialogue.state import Dialogue, Introducing
from assistant.dialogue.things import things_in
from assistant.dialogue.turn import Turn, Words, changed, first, line, say
from assistant.language.actions import called_things
from assistant.language.asides import after
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts
from assistant.model.task import TaskObject


def no_thing(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Take back a thing that is none, or take the ones told instead; None for other talk."""
    state = dialogue.state
    if not isinstance(state, Introducing) or dialogue.pending is not None:
        return None
    if state.asked not in ("body", "pose"):
        return None
    named = _others(dialogue, words)
    # "No" to the question where it is leaves that to the showing.
    return named or (_denied(dialogue, state.thing, words.text) if state.asked == "body" else None)


def sized(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Tell how big a thing is taken to be, for who asks; None for other talk."""
    bodies, text = dialogue.known.scene.bodies, words.text.lower()
    named = [name for name in bodies if mentions(text, called_things(name, dialogue.language))]
    if len(named) != 1 or not mentions(text, hints("asks_size", dialogue.language)):
        return None
    return tell(dialogue, size_line(dialogue.known, named[0]))


def _others(dialogue: Dialogue, words: Words) -> Turn | None:
    """Take the things that are told instead, where they are all there."""
    known, text = dialogue.known, words.text.lower()
    instead = mentions(text, hints("things_instead", dialogue.language))
    bodies, language = known.scene.bodies, known.language
    named = [name for name in bodies if mentions(text, called_things(name, language))]
    listed = after(words.text, "things_are", language)
    things = things_in(tuple(named) or listed, known.scene, language)
    if not instead or not things or any(character.isdigit() for character in text):
        return None
    return _with(dialogue, things)


def _denied(dialogue: Dialogue, name: str, text: str) -> Turn | None:
    """Forget a thing of which somebody says just "no" to the question how big it is."""
    if not alike(text.strip(" .!"), hints("no_thing", dialogue.language)):
        return None
    left = tuple(one for one in dialogue.known.objects or () if one.name != name)
    return _with(dialogue, left or None)


def _with(dialogue: Dialogue, things: tuple[TaskObject, ...] | None) -> Turn:
    known = replace(dialogue.known, objects=things)
    names = [one.name for one in things or ()]
    told = (line("done", "things", names=names),) if names else ()
    said = say(dialogue, *told)[1]
    return first(said, proceed(changed(dialogue, "objects", known)))
