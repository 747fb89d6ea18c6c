"""The teacher corrects the task tree, before or after it was learned (paper II-A, III-C c)."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from assistant.dialogue.asking import settle, tell
from assistant.dialogue.introduction import all_understood, with_roles
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
from assistant.dialogue.state import Dialogue, Knowledge, Pending, Reviewing
from assistant.dialogue.turn import Turn, changed, line, say
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Lesson
from assistant.model.robot_acts import RobotAct
from assistant.model.task import Action, Index

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
    if dialogue.arm in ("moving", "checking") and not isinstance(act, acts.Rename):
        return say(dialogue, line("error", "while_moving"))
    dialogue = _answering(dialogue, act)
    match act:
        case acts.Rename(old, new):
            return rename(dialogue, old, new)
        case acts.Optional(name) | acts.Required(name):
            return _optional(dialogue, name, isinstance(act, acts.Optional))
        case acts.Unordered(named):
            return _unordered(dialogue, named)
        case acts.Ordered(one, other):
            return _ordered(dialogue, one, other)
        case acts.AddSubtask():
            return _add(dialogue, act)
        case acts.RemoveSubtask(name):
            return _remove(dialogue, name)
        case acts.Merge(named):
            return _merge(dialogue, named)
        case acts.Split(name):
            return _split(dialogue, name)


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


def find(known: Knowledge, text: str) -> Index | None:
    """Return the position of the node a text refers to, or None if it is not clear which."""
    wanted = _plain(text)
    nodes = [(index, _plain(node.name)) for index, node in walk(known.root) if index and node.name]
    for fits in (_same, _inside, _most_words):
        hits = [index for index, name in nodes if fits(wanted, name)]
        if len(hits) == 1:
            return hits[0]
    return None


def _plain(text: str) -> str:
    return " ".join(re.findall(r"\w+", text.lower()))


def _same(wanted: str, name: str) -> bool:
    return wanted == name


def _inside(wanted: str, name: str) -> bool:
    return bool(wanted) and (wanted in name or name in wanted)


def _most_words(wanted: str, name: str) -> bool:
    asked = {word for word in wanted.split() if word not in ("the", "a", "step", "part")}
    return bool(asked) and asked <= {part for word in name.split() for part in _forms(word)}


def _forms(word: str) -> Sequence[str]:
    stem = word.removesuffix("e")
    return (word, f"{word}s", f"{stem}ing", f"{word}{word[-1]}ing")


def unclear(dialogue: Dialogue, name: str) -> Turn:
    """Tell that no one step is called that, with the names there are."""
    told = line("error", "no_such_step", name=name, names=list(names(dialogue.known.root)))
    return tell(dialogue, told)


def _done(dialogue: Dialogue, label: str, root: Sketch, told: RobotAct) -> Turn:
    known = all_understood(with_roles(replace(dialogue.known, root=root)))
    return settle(changed(dialogue, label, known), told)


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
    return _done(dialogue, topic, root, line("done", topic, name=node.name))


def _unordered(dialogue: Dialogue, named: tuple[str, ...]) -> Turn:
    known = dialogue.known
    indexes = [find(known, name) for name in named]
    lost = [name for name, index in zip(named, indexes, strict=True) if index is None]
    if lost:
        return unclear(dialogue, lost[0])
    found = [index for index in indexes if index]
    parent = found[0][:-1] if len(found) > 1 else (found[0] if found else ())
    if any(index[:-1] != parent for index in found) and len(found) > 1:
        return tell(dialogue, line("error", "not_siblings", names=list(named)))
    node = at(known.root, parent)
    if not node.parts:
        return tell(dialogue, line("error", "no_parts", name=node.name))
    root = put(known.root, parent, replace(node, order="any"))
    parts = [part.name for part in node.parts]
    told = line("done", "unordered", names=parts, name=node.name or known.name)
    return _done(dialogue, "unordered", root, told)


def _ordered(dialogue: Dialogue, one: str, other: str) -> Turn:
    known = dialogue.known
    before, after = find(known, one), find(known, other)
    if before is None or after is None:
        return unclear(dialogue, one if before is None else other)
    if before == after or before[:-1] != after[:-1]:
        return tell(dialogue, line("error", "not_siblings", names=[one, other]))
    parent = before[:-1]
    node = at(known.root, parent)
    told = line("done", "ordered", first=at(known.root, before).name, second=name_at(known, after))
    if before[-1] < after[-1]:
        root = put(known.root, parent, replace(node, order="sequential"))
        return _done(dialogue, "ordered", root, told)
    root = inserted(removed(known.root, before), parent, after[-1], at(known.root, before))
    root = put(root, parent, replace(at(root, parent), order="sequential"))
    if known.lesson is None:
        return _done(dialogue, "ordered", root, told)
    # The path was shown in the old order: only another demonstration can teach the new one.
    ordered = changed(dialogue, "ordered", replace(known, root=root, learned_root=root))
    return offer_demonstration(ordered, told)


def name_at(known: Knowledge, index: Index) -> str:
    """Return the name of the node at a position."""
    return at(known.root, index).name


def offer_demonstration(dialogue: Dialogue, *lines: RobotAct) -> Turn:
    """Say that a change must be shown, and offer to watch now."""
    question = line("ask", "show_again_now", asked="ready")
    pending = Pending("ready", question, (acts.GoBack("demonstration"),))
    return tell(replace(dialogue, pending=pending), *lines)


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
    return _done(dialogue, "added", root, line("done", topic, name=name))


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
    return _done(dialogue, "removed", root, line("done", topic, name=told))


def _merge(dialogue: Dialogue, named: tuple[str, ...]) -> Turn:
    known = dialogue.known
    found = [find(known, name) for name in named]
    indexes = sorted({index for index in found if index})
    if len(indexes) < 2 or None in found:
        lost = [name for name, index in zip(named, found, strict=True) if index is None]
        return unclear(dialogue, lost[0] if lost else ", ".join(named))
    parent, spots = indexes[0][:-1], [index[-1] for index in indexes]
    together = all(index[:-1] == parent for index in indexes)
    if not together or spots != list(range(spots[0], spots[0] + len(spots))):
        return tell(dialogue, line("error", "not_siblings", names=list(named)))
    node = at(known.root, parent)
    parts = node.parts[spots[0] - 1 : spots[-1]]
    one = _joined(parts)
    left = (*node.parts[: spots[0] - 1], one, *node.parts[spots[-1] :])
    root = put(known.root, parent, with_parts(node, left))
    told = line("done", "merged", names=[part.name for part in parts], name=one.name)
    return _done(dialogue, "merged", root, told)


def _joined(parts: tuple[Sketch, ...]) -> Sketch:
    name = " and ".join(part.name for part in parts)
    if any(part.parts for part in parts):
        inner = tuple(piece for part in parts for piece in (part.parts or (part,)))
        return Sketch(name, False, inner)
    told = [part.action for part in parts if part.action is not None]
    hands = [action for action in told if action.verb == "hand"]
    action = (hands or told or [Action("free", name)])[0]
    return Sketch(name, True, (), action=action, until=parts[-1].until, before=parts[0].before)


def _split(dialogue: Dialogue, name: str) -> Turn:
    known = dialogue.known
    index = find(known, name)
    if index is None:
        return unclear(dialogue, name)
    node = at(known.root, index)
    if node.parts:
        parent = at(known.root, index[:-1])
        spot = index[-1]
        parts = (*parent.parts[: spot - 1], *node.parts, *parent.parts[spot:])
        root = put(known.root, index[:-1], with_parts(parent, parts))
        told = line("done", "dissolved", name=node.name, names=[part.name for part in node.parts])
        return _done(dialogue, "split", root, told)
    # A name that tells one motion would at once be read as one again: two parts are opened.
    opened = with_parts(replace(node, action=None), (Sketch(), Sketch()))
    root = put(known.root, index, opened)
    return _done(dialogue, "split", root, line("done", "split", name=node.name))
