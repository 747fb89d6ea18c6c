"""A teacher who does not know what to answer: the robot suggests, assumes, or does without."""

from __future__ import annotations

import re
from dataclasses import replace

from assistant.dialogue.asking import ask, proceed, tell
from assistant.dialogue.helping import help_line
from assistant.dialogue.naming import alike
from assistant.dialogue.replying import in_state
from assistant.dialogue.reviewing import next_question
from assistant.dialogue.sketch import at, names, with_parts
from assistant.dialogue.spots import offered
from assistant.dialogue.state import Dialogue, Introducing, Pending, Reviewing
from assistant.dialogue.things import thing_names
from assistant.dialogue.turn import Turn, Words, changed, first, line, say
from assistant.language import asides
from assistant.language.actions import read_action
from assistant.language.bodies import read_body
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts

FEWEST_PARTS = 2
"""Of the motions that are offered for one step; one alone is the step itself."""
REPLAY_NOW = Pending("ready", line("ask", "replay_now", asked="ready"), (acts.Again(),))
"""Shall I show it slowly with my arm?"""


def unknowing(dialogue: Dialogue, text: str) -> bool:
    """Whether the teacher says not to know what the introduction asks."""
    state = dialogue.state
    if isinstance(state, Reviewing):
        return asides.unknowing(text, dialogue.language) and "?" not in text
    if not isinstance(state, Introducing):
        return False
    later = state.asked == "pose" and mentions(text, hints("shown_later", dialogue.language))
    if (
        state.asked == "body"
        and read_body(text, dialogue.language, state.thing).size_mm is not None
    ):
        # "No idea, 10 by 6 by 4" is an idea.
        return False
    told = later and re.search(r"\d", text) is None
    return told or asides.unknowing(text, dialogue.language)


def unknown_to(dialogue: Dialogue, words: Words) -> Turn:
    """Go on without the answer where that is possible, else help to find one."""
    state = dialogue.state
    free = replace(dialogue, pending=None, misses=0)
    if isinstance(state, Reviewing):
        return _left_open(free, state)
    if not isinstance(state, Introducing):
        return tell(free, line("told", "need_to_know"))
    if state.asked == "task_name":
        return _named_for_now(free)
    if state.asked == "subtask_count" and not state.index and not state.named:
        return _suggested(free, words)
    if state.asked == "subtask_count" and state.index and not state.named:
        return _suggested_parts(free, state, words)
    if state.asked == "subtask_name":
        return _unnamed(free, state, words)
    if state.asked == "pose" and mentions(words.text, hints("all_of_them", dialogue.language)):
        return _all_shown(free)
    if state.asked == "objects" and not state.index:
        return _all_things(free, words)
    if state.asked == "pose" and not mentions(words.text, hints("shown_later", dialogue.language)):
        spot = offered(free, state.thing)
        if spot is not None:
            return spot
    return in_state(free, acts.Deny(), words)


def _left_open(dialogue: Dialogue, state: Reviewing) -> Turn:
    """Take what is safe where a question of learning is left open; show what was seen."""
    asked = state.questions[0].asked if state.questions else ""
    if asked in ("optional", "order"):
        told = line("told", "kept_order" if asked == "order" else "kept_all_the_same")
        return first(say(dialogue, told)[1], next_question(dialogue, state))
    if dialogue.known.lesson is None or dialogue.known.lesson.path is None:
        return tell(dialogue, help_line(dialogue))
    return ask(replace(dialogue, pending=REPLAY_NOW))


def _all_shown(dialogue: Dialogue) -> Turn:
    """Leave the places of all things to the demonstration."""
    known = dialogue.known
    left = tuple(one.name for one in known.objects or () if one.name not in known.setup.places)
    return proceed(changed(dialogue, "pose", replace(known, unplaced=left)))


def _all_things(dialogue: Dialogue, words: Words) -> Turn:
    """Take what stands on the table for what the task needs."""
    known = dialogue.known
    there = thing_names(known.scene, known.setup)
    if not there:
        return in_state(dialogue, acts.Deny(), words)
    told = line("told", "assumed_things", things=there)
    return first(say(dialogue, told)[1], in_state(dialogue, acts.Inform(tuple(there)), words))


def _named_for_now(dialogue: Dialogue) -> Turn:
    name: str = hints("default_name", dialogue.language)
    known = dialogue.known
    named = replace(known, name=name, root=replace(known.root, name=name))
    told = line("told", "assumed_name", name=name)
    return first(say(dialogue, told)[1], proceed(changed(dialogue, "task_name", named)))


def _unnamed(dialogue: Dialogue, state: Introducing, words: Words) -> Turn:
    """Suggest all steps to who cannot name the first one; else tell what a name may be."""
    known = dialogue.known
    if state.index[:-1] or any(part.name for part in known.root.parts):
        return tell(dialogue, help_line(dialogue))
    if not suggested_steps(dialogue):
        return tell(dialogue, help_line(dialogue))
    uncounted = replace(known, root=with_parts(known.root, ()))
    asking = replace(dialogue, known=uncounted, state=Introducing("subtask_count"))
    return _suggested(asking, words)


def _suggested(dialogue: Dialogue, words: Words) -> Turn:
    """Offer the steps by which one thing usually comes to its place."""
    steps = suggested_steps(dialogue)
    if not steps:
        return tell(dialogue, line("help", "subtask_count"))
    return _offered(dialogue, "suggested_steps", steps, words)


def _offered(dialogue: Dialogue, topic: str, steps: tuple[str, ...], words: Words) -> Turn:
    question = line("confirm", topic, asked="did_you_mean", names=list(steps))
    pending = Pending("did_you_mean", question, (acts.Inform(steps),), words.text)
    return ask(replace(dialogue, pending=pending))


def _suggested_parts(dialogue: Dialogue, state: Introducing, words: Words) -> Turn:
    """Offer the motions that "pick it up" or "put it there" usually are; else it is one."""
    known = dialogue.known
    reading = read_action(at(known.root, state.index).name, known.objects or (), known.language)
    usual: dict[str, list[str]] = hints("suggested_parts", dialogue.language)
    way = reading.action.way if reading.action is not None else ""
    thing = reading.action.object if reading.action is not None else None
    thing = thing or (reading.mentioned[-1] if reading.mentioned else None)
    if way not in usual or thing is None:
        return in_state(dialogue, acts.Deny(), words)
    # "Put the red one on the blue one" begins with the red one.
    fetched = reading.mentioned[0] if way == "open" else thing
    order = ((fetched, "close"), (thing, "open")) if fetched != thing else ((thing, way),)
    own: dict[str, list[str]] = hints("things", dialogue.language)
    told = [
        one.format(thing=own.get(name, [name])[0]) for name, kind in order for one in usual[kind]
    ]
    steps = tuple(step for step in told if not alike(step, names(known.root)))
    if len(steps) < FEWEST_PARTS:
        return in_state(dialogue, acts.Deny(), words)
    return _offered(dialogue, "suggested_parts", steps, words)


def suggested_steps(dialogue: Dialogue) -> tuple[str, ...]:
    """Return the usual steps for one object and one target; none for other tasks."""
    things = dialogue.known.objects or ()
    carried = [one.name for one in things if one.role == "object"]
    targets = [one.name for one in things if one.role == "target"]
    if len(carried) != 1 or len(targets) != 1:
        return ()
    told: list[str] = hints("suggested_steps", dialogue.language)
    own: dict[str, list[str]] = hints("things", dialogue.language)
    thing, target = (own.get(name, [name])[0] for name in (carried[0], targets[0]))
    return tuple(one.format(object=thing, target=target) for one in told)
