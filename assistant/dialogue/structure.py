"""The teacher corrects the task tree, before or after it was learned (paper II-A, III-C c)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from assistant.dialogue import grouping
from assistant.dialogue.asking import settle, tell
from assistant.dialogue.finding import candidates, edited, find, name_at, unclear
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.naming import alike
from assistant.dialogue.sketch import (
    Sketch,
    at,
    inserted,
    names,
    put,
    removed,
    walk,
    with_parts,
)
from assistant.dialogue.state import Dialogue, Reviewing
from assistant.dialogue.turn import Turn, changed, line, say
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Lesson
from assistant.model.task import Index

Edit = (
    acts.Rename
    | acts.Optional
    | acts.Required
    | acts.Unordered
    | acts.Ordered
    | acts.AddSubtask
    | acts.RemoveSubtask
    | acts.Merge
    | acts.Split
)


def edit(dialogue: Dialogue, act: Edit) -> Turn:
    """Change the tree as the teacher says and tell what was changed."""
    if dialogue.busy and not isinstance(act, acts.Rename):
        return say(dialogue, line("error", "while_moving"))
    for name in _referred(act):
        if len(candidates(dialogue.known, name)) > 1:
            return unclear(dialogue, name, act)
    dialogue = _answering(dialogue, act)
    match act:
        case acts.Rename(old, new):
            return rename(dialogue, old, new)
        case acts.Optional(name) | acts.Required(name):
            return _optional(dialogue, name, isinstance(act, acts.Optional))
        case acts.Unordered(named):
            return grouping.unordered(dialogue, named)
        case acts.Ordered(one, other):
            return grouping.ordered(dialogue, one, other)
        case acts.AddSubtask():
            return _add(dialogue, act)
        case acts.RemoveSubtask(name):
            return _remove(dialogue, name)
        case acts.Merge(named):
            return grouping.merge(dialogue, named)
        case acts.Split(name):
            return grouping.split(dialogue, name)


def _referred(act: Edit) -> tuple[str, ...]:
    """Return the texts by which an act refers to steps."""
    match act:
        case acts.Rename(old, _):
            return (old,)
        case acts.Unordered(named) | acts.Merge(named):
            return named
        case acts.Ordered(one, other):
            return (one, other)
        case acts.AddSubtask(_, after, before):
            return tuple(name for name in (after, before) if name)
        case _:
            return (act.subtask,)


def _answering(dialogue: Dialogue, act: Edit) -> Dialogue:
    """Return the dialogue without the question of learning that this very change answers."""
    state = dialogue.state
    named = getattr(act, "subtask", None)
    if not isinstance(state, Reviewing) or not state.questions or named is None:
        return dialogue
    index = find(dialogue.known, named)
    if index is None or name_at(dialogue.known, index) != state.questions[0].about:
        return dialogue
    return replace(dialogue, state=Reviewing(state.questions[1:]))


def rename(dialogue: Dialogue, old: str, new: str) -> Turn:
    """Give a step, a thing or the task another name, in what was learned too."""
    known = dialogue.known
    if not new.strip():
        return tell(dialogue, line("error", "not_an_answer"))
    index = find(known, old)
    if index is None and alike(old, (known.name, "task", "the task", "it")) and known.name:
        renamed = replace(known, name=new, root=replace(known.root, name=new))
        return settle(changed(dialogue, "name", renamed), line("done", "renamed", old=old, new=new))
    if index is None:
        return unclear(dialogue, old)
    name = at(known.root, index).name
    if alike(new, [other for other in names(known.root) if other != name]):
        return tell(dialogue, line("error", "name_taken", name=new))
    told = line("done", "renamed", old=name, new=new)
    return settle(changed(dialogue, "name", _renamed(known, index, new)), told)


def _renamed(known: Knowledge, index: Index, new: str) -> Knowledge:
    old = at(known.root, index).name
    root = put(known.root, index, replace(at(known.root, index), name=new))
    learned = known.learned_root
    if learned is not None:
        learned = _with_name(learned, old, new)
    assigned = tuple((number, new if one == old else one) for number, one in known.assigned)
    lesson = known.lesson and _lesson_renamed(known.lesson, old, new)
    return replace(known, root=root, learned_root=learned, assigned=assigned, lesson=lesson)


def _with_name(root: Sketch, old: str, new: str) -> Sketch:
    for index, node in tuple(walk(root)):
        if index and node.name == old:
            root = put(root, index, replace(node, name=new))
    return root


def _lesson_renamed(lesson: Lesson, old: str, new: str) -> Lesson:
    def fit(name: Any) -> Any:
        return new if name == old else name

    def keys(told: Mapping[str, Any]) -> dict[str, Any]:
        return {fit(name): value for name, value in told.items()}

    found = lesson.segmentation
    episodes = tuple(replace(one, primitive=fit(one.primitive)) for one in found.episodes)
    questions = tuple(replace(one, about=fit(one.about)) for one in found.questions)
    return replace(
        lesson,
        segmentation=replace(found, episodes=episodes, questions=questions),
        stations=tuple(replace(one, primitive=fit(one.primitive)) for one in lesson.stations),
        feedback=tuple(replace(one, primitive=fit(one.primitive)) for one in lesson.feedback),
        before=keys(lesson.before),
        until=keys(lesson.until),
    )


def _optional(dialogue: Dialogue, name: str, optional: bool) -> Turn:
    index = find(dialogue.known, name)
    if index is None:
        return unclear(dialogue, name)
    node = at(dialogue.known.root, index)
    topic = "optional" if optional else "required"
    root = put(dialogue.known.root, index, replace(node, optional=optional))
    return edited(dialogue, topic, root, line("done", topic, name=node.name))


def _add(dialogue: Dialogue, act: acts.AddSubtask) -> Turn:
    known = dialogue.known
    name = act.name.strip()
    if not name or alike(name, names(known.root)):
        topic = "name_taken" if name else "not_an_answer"
        return tell(dialogue, line("error", topic, name=name))
    beside = act.after or act.before
    index = find(known, beside) if beside else None
    if beside and index is None:
        return unclear(dialogue, beside)
    root = _with_new(known.root, index, Sketch(name), after=act.after is not None)
    topic = "added_look" if known.lesson is not None else "added"
    return edited(dialogue, "added", root, line("done", topic, name=name))


def add_inside(dialogue: Dialogue, name: str, whole: Index) -> Turn:
    """Add a part at the end of a step; a single motion gets it and another that is asked for."""
    known = dialogue.known
    if dialogue.busy:
        return say(dialogue, line("error", "while_moving"))
    if alike(name, names(known.root)):
        return tell(dialogue, line("error", "name_taken", name=name))
    node = at(known.root, whole)
    if node.parts:
        root = inserted(known.root, whole, len(node.parts) + 1, Sketch(name))
    else:
        opened = with_parts(replace(node, action=None), (Sketch(name), Sketch()))
        root = put(known.root, whole, opened)
    topic = "added_look" if known.lesson is not None else "added_inside"
    told = line("done", topic, name=name, parent=node.name)
    return edited(dialogue, "added", root, told)


def _with_new(root: Sketch, index: Index | None, new: Sketch, *, after: bool) -> Sketch:
    if index is not None:
        return inserted(root, index[:-1], index[-1] + after, new)
    blank = next((place for place, node in walk(root) if place and not node.name), None)
    if blank is not None:
        return put(root, blank, new)
    return inserted(root, (), len(root.parts) + 1, new)


def _remove(dialogue: Dialogue, name: str) -> Turn:
    index = find(dialogue.known, name)
    if index is None:
        return unclear(dialogue, name)
    told = at(dialogue.known.root, index).name
    topic = "removed" if dialogue.known.lesson is None else "removed_shown"
    root = removed(dialogue.known.root, index)
    parent = index[:-1]
    if parent and not any(part.name for part in at(root, parent).parts):
        # What has no named part left is a step like any other again.
        root = put(root, parent, with_parts(at(root, parent), ()))
    return edited(dialogue, "removed", root, line("done", topic, name=told), now={})
