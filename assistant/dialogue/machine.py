"""The dialogue as a pure state machine: ``step(dialogue, event) -> (dialogue, effects)``.

It sees no clock, file, screen or robot and does no long work; the session carries out the
effects and brings their results back as events (design, three ideas).
"""

from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType
from typing import assert_never

from assistant.dialogue import practicing, reporting, reviewing, showing
from assistant.dialogue.asking import ask
from assistant.dialogue.effects import Arrange, Effect, Say
from assistant.dialogue.events import (
    ArmReported,
    Arranged,
    Begun,
    Checked,
    Event,
    Halted,
    Heard,
    Kept,
    Learned,
    Loaded,
    Shown,
    Ticked,
)
from assistant.dialogue.hearing import hear
from assistant.dialogue.introduction import need
from assistant.dialogue.keeping import kept, known_as, loaded, resumed, taken_up
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.listening import beneath, listening
from assistant.dialogue.state import Closed, Dialogue, Introducing
from assistant.dialogue.things import thing_names
from assistant.dialogue.turn import Turn, first, line, say
from assistant.dialogue.view import public_view
from assistant.model.robot_acts import About


def begin(language: str = "english") -> Dialogue:
    """Return the dialogue before anything happened, in a language of the phrasebooks."""
    return Dialogue(Knowledge(language=language))


def step(dialogue: Dialogue, event: Event) -> tuple[Dialogue, tuple[Effect, ...]]:
    """Return the dialogue after an event, and what is to be done, in this order."""
    if isinstance(dialogue.state, Closed):
        return dialogue, ()
    after, effects = _answer(dialogue, event)
    effects = tuple(
        _shorter(dialogue, effect) for effect in (*_reshaped(dialogue, after), *effects)
    )
    lines = tuple(effect.line for effect in effects if isinstance(effect, Say))
    return (replace(after, said=lines) if lines else after), effects


def _reshaped(before: Dialogue, after: Dialogue) -> tuple[Effect, ...]:
    """Return what shows the session the bodies a teacher told of."""
    known = after.known
    told = known.shaped and known.scene.bodies != before.known.scene.bodies
    return (Arrange(known.setup, known.scene),) if told else ()


def _shorter(dialogue: Dialogue, effect: Effect) -> Effect:
    """Return a question asked a moment ago in its short form; all else as it is."""
    if not isinstance(effect, Say) or effect.line.act not in ("ask", "confirm"):
        return effect
    before = {(line.act, line.topic, line.about) for line in dialogue.said}
    asked = effect.line
    in_full = asked.slots.get("again") is False
    if in_full or (asked.act, asked.topic, asked.about) not in before:
        return effect
    if asked.slots.get("tree") not in (None, *(line.slots.get("tree") for line in dialogue.said)):
        return effect
    return Say(replace(asked, slots=MappingProxyType({**asked.slots, "again": True})))


def _answer(dialogue: Dialogue, event: Event) -> Turn:
    match event:
        case Begun():
            return _begun(dialogue, event)
        case Heard():
            return hear(dialogue, event)
        case Shown():
            return showing.shown(dialogue, event)
        case Learned():
            return reviewing.learned(dialogue, event)
        case Checked():
            return reporting.checked(dialogue, event)
        case ArmReported(report):
            return reporting.reported(dialogue, report)
        case Halted():
            return practicing.halted(dialogue, event)
        case Arranged():
            return practicing.arranged(dialogue, event)
        case Kept():
            return kept(dialogue, event)
        case Loaded():
            return loaded(dialogue, event)
        case Ticked():
            return dialogue, ()
        case _:
            assert_never(event)


def _begun(dialogue: Dialogue, event: Begun) -> Turn:
    """Greet, and begin with the introduction or go on with a task that was given."""
    known = replace(dialogue.known, scene=event.scene, setup=event.setup)
    # Kept tasks come by their files' names.
    saved = tuple(name.replace("_", " ") for name in event.saved)
    open_dialogue = replace(dialogue, known=known, saved=saved)
    if event.task is None:
        things = thing_names(known.scene, known.setup)
        topic = "first" if not event.saved else "again"
        greeting = line("greet", topic, names=list(saved), things=things)
        asking = replace(open_dialogue, state=need(known) or Introducing("task_name"))
        return first(say(asking, greeting)[1], ask(asking))
    known = taken_up(known, event.task)
    greeting = line("greet", "with_task", about=About(known.name), task=known.name)
    # A file of the same name from elsewhere is another task.
    saved_as = known_as(open_dialogue, event.saved_as)
    taught = replace(open_dialogue, known=known, saved_as=saved_as)
    return first(say(taught, greeting)[1], resumed(taught))


__all__ = ["begin", "beneath", "listening", "public_view", "step"]
