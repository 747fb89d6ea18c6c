"""What an answer of the introduction adds to what is known (paper II-A)."""

from __future__ import annotations

from dataclasses import dataclass, replace

from assistant.dialogue.bodies import WIDEST_MM, too_wide, with_body
from assistant.dialogue.introduction import MOST_PARTS, all_understood, with_action
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.naming import (
    Value,
    alike,
    is_lone_verb,
    is_no_step,
    is_size,
    name_and_steps,
    number_of,
    steps_in,
    text_of,
    tidy_name,
)
from assistant.dialogue.sketch import Sketch, at, counted, names, put, with_parts
from assistant.dialogue.state import Introducing
from assistant.dialogue.things import placed, things_in
from assistant.dialogue.turn import line
from assistant.language.actions import mentioned_objects, read_action
from assistant.language.bodies import read_body
from assistant.model.robot_acts import RobotAct
from assistant.model.task import Action, Index

SHORTEST_GOAL = 3
"""Letters of a goal: "y" tells none."""


@dataclass(frozen=True, slots=True)
class Answered:
    """What is known now, what the robot says about it, and a question that comes first."""

    known: Knowledge
    lines: tuple[RobotAct, ...] = ()
    asks: Introducing | None = None


def answer(known: Knowledge, state: Introducing, value: Value) -> Answered:
    """Return what is known after the teacher's answer to the open question."""
    match state.asked:
        case "task_name":
            return _task_name(known, value)
        case "goal" if len(text_of(value).strip()) < SHORTEST_GOAL:
            return Answered(known, (line("error", "not_an_answer"),))
        case "goal":
            return Answered(replace(known, goal=tidy_name(text_of(value))))
        case "objects" if state.index:
            return _objects_of(known, state.index, value)
        case "objects":
            return _things(known, value)
        case "subtask_count":
            return _count(known, state, value)
        case "subtask_name":
            return _names(known, state, value)
        case "actions":
            return _action(known, state.index, value)
        case "which":
            return _extra(known, state, value)
        case "body":
            return _body(known, state.thing, value)
        case _:
            return Answered(known, (line("error", "not_an_answer"),))


def _things(known: Knowledge, value: Value) -> Answered:
    """Take the things named; a lone verb is none, told where a step was expected to be asked."""
    things = things_in(value, known.scene, known.language)
    phrases = value if isinstance(value, tuple) else (str(value),)
    verbs = {one: is_lone_verb(one, known.language, ending=bool(things)) for one in phrases}
    if phrases and all(verbs.values()):
        return Answered(known, (line("error", "no_thing", names=list(phrases)),))
    things = placed(things, (known.name, known.goal or ""), known.scene, known.language)
    return Answered(all_understood(replace(known, objects=things)))


def _task_name(known: Knowledge, value: Value) -> Answered:
    name, steps = name_and_steps(text_of(value), known.language)
    named = replace(known, name=name, root=replace(known.root, name=name))
    if not steps or known.root.parts:
        return Answered(named)
    root = with_parts(named.root, tuple(Sketch(step) for step in dict.fromkeys(steps)))
    return Answered(all_understood(replace(named, root=root)))


def _count(known: Knowledge, state: Introducing, value: Value) -> Answered:
    index = state.index
    sized = is_size(value)
    count = None if sized else number_of(value, known.language)
    named = not (sized or isinstance(value, int))
    steps = steps_in(value, 2, known.language) if named else ()
    if state.named and count is not None:
        return _settled(known, state, count)
    if len(steps) > 1 or (steps and count is None):
        return _placed(known, index, steps)
    if count is None or not 0 <= count <= MOST_PARTS:
        told = line("error", "count", most=MOST_PARTS)
        return Answered(known, (told,))
    return Answered(_with_count(known, index, count))


def _with_count(known: Knowledge, index: Index, count: int) -> Knowledge:
    node = at(known.root, index)
    # A step of one part is one motion.
    count = 0 if index and count == 1 else count
    if not index and count == 0:
        # A task of one motion is a root with that motion as its only part.
        alone = with_parts(node, (Sketch(known.name, True),))
        return all_understood(replace(known, root=alone))
    after = replace(known, root=put(known.root, index, counted(node, count)))
    return all_understood(after) if count == 0 else after


def _settled(known: Knowledge, state: Introducing, count: int) -> Answered:
    """Resolve "you said three, you named four" by the number the teacher now says."""
    if count < len(state.named) and count > 0:
        return Answered(known, asks=replace(state, asked="which", said=count))
    placed = _placed(known, state.index, state.named).known
    missing = min(count, MOST_PARTS) - len(state.named)
    if missing <= 0:
        return Answered(placed)
    node = counted(at(placed.root, state.index), len(state.named) + missing)
    return Answered(replace(placed, root=put(placed.root, state.index, node)))


def _extra(known: Knowledge, state: Introducing, value: Value) -> Answered:
    text = text_of(value).lower()
    extra = [name for name in state.named if name.lower() in text or text in name.lower()]
    if len(extra) != 1:
        return Answered(known, (line("error", "not_among", names=list(state.named)),), state)
    left = tuple(name for name in state.named if name != extra[0])
    if len(left) > state.said:
        return Answered(known, asks=replace(state, named=left))
    return _placed(known, state.index, left)


def _names(known: Knowledge, state: Introducing, value: Value) -> Answered:
    parent, position = state.index[:-1], state.index[-1]
    parts = at(known.root, parent).parts
    room = len(parts) - position + 1
    steps = steps_in(value, room, known.language)
    before = tuple(part.name for part in parts[: position - 1])
    if not steps or is_no_step(steps[0], known.language):
        return Answered(known, (line("error", "not_an_answer"),))
    if len(steps) > room:
        named = (*before, *steps)
        asks = Introducing("subtask_count", parent, named=named, said=len(parts))
        return Answered(known, asks=asks)
    return _placed(known, parent, (*before, *steps), len(parts))


def _placed(known: Knowledge, parent: Index, steps: tuple[str, ...], count: int = 0) -> Answered:
    """Give the parts of a node these names, refusing a name that is taken elsewhere."""
    node = at(known.root, parent)
    own = [part.name for part in node.parts]
    elsewhere = [name for name in names(known.root) if name not in own]
    taken = _taken(steps, elsewhere)
    if taken:
        return Answered(known, (line("error", "name_taken", name=taken),))
    old = {part.name: part for part in node.parts if part.name}
    parts = tuple(old.get(step, Sketch(step)) for step in steps)
    blank = (Sketch(),) * max(0, count - len(parts))
    after = replace(known, root=put(known.root, parent, with_parts(node, parts + blank)))
    return Answered(all_understood(after))


def _taken(steps: tuple[str, ...], elsewhere: list[str]) -> str:
    for position, step in enumerate(steps):
        if alike(step, elsewhere) or alike(step, steps[:position]):
            return step
    return ""


def _objects_of(known: Knowledge, index: Index, value: Value) -> Answered:
    node = at(known.root, index)
    known, mentioned = _mentioned(known, value)
    if not mentioned or node.action is None:
        return Answered(known, (line("error", "not_an_answer"),))
    return Answered(with_action(known, index, replace(node.action, object=mentioned[0])))


def _mentioned(known: Knowledge, value: Value) -> tuple[Knowledge, tuple[str, ...]]:
    """Return the known things an answer mentions; a new thing becomes known."""
    things = known.objects or ()
    found = mentioned_objects(text_of(value), things, known.language)
    if found:
        return known, found
    new = tuple(
        thing for thing in things_in(value, known.scene, known.language) if thing not in things
    )
    return replace(known, objects=(*things, *new)), tuple(thing.name for thing in new)


def _action(known: Knowledge, index: Index, value: Value) -> Answered:
    text = text_of(value)
    node = at(known.root, index)
    reading = read_action(text, known.objects or (), known.language)
    if reading.action is None:
        return Answered(with_action(known, index, _free(known, text, reading.mentioned)))
    action = reading.action
    if not reading.mentioned:
        spoken = read_action(node.name, known.objects or (), known.language).mentioned
        named = [name for name in spoken if name.lower() in node.name.lower()]
        action = replace(action, object=named[-1] if named else action.object)
    return Answered(with_action(known, index, action))


def _free(known: Knowledge, text: str, mentioned: tuple[str, ...]) -> Action:
    # Where it ends is what it is carried to another setup by: "push the box to the line".
    targets = [thing.name for thing in known.objects or () if thing.role == "target"]
    told = [name for name in mentioned if name in targets] or list(mentioned)
    return Action("free", tidy_name(text), told[0] if told else None)


def _body(known: Knowledge, thing: str, value: Value) -> Answered:
    told = read_body(text_of(value), known.language, thing)
    if told.size_mm is None:
        return Answered(known, (line("error", "size", thing=thing),))
    after = with_body(known, thing, told.shape or "box", told.size_mm)
    wide = (line("told", "too_wide", thing=thing, most_mm=WIDEST_MM),)
    return Answered(after, wide if too_wide(after) == thing else ())
