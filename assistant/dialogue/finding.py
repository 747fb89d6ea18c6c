"""Which step of the tree a teacher's words refer to; where that is unclear, the robot asks."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

from assistant.dialogue.asking import ask, settle, tell
from assistant.dialogue.introduction import all_understood, with_roles
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.referring import with_names
from assistant.dialogue.sketch import (
    Sketch,
    at,
    names,
    walk,
)
from assistant.dialogue.state import Dialogue, Pending, Running
from assistant.dialogue.turn import Turn, changed, line
from assistant.language.actions import mentioned_objects, read_action
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts
from assistant.model.robot_acts import RobotAct
from assistant.model.task import Action, Index, primitives
from assistant.model.teacher_acts import TeacherAct, Where

_ABOUT_ONE = (
    acts.Split,
    acts.RemoveSubtask,
    acts.Optional,
    acts.Required,
    acts.MoveCut,
    acts.Assign,
)


def find(known: Knowledge, text: str) -> Index | None:
    """Return the position of the node a text refers to, or None if it is not clear which."""
    hits = candidates(known, text)
    return hits[0] if len(hits) == 1 else None


def find_whole(known: Knowledge, text: str) -> Index | None:
    """Return the position of a node; of several that fit, the one the others are part of."""
    hits = candidates(known, text)
    whole = [one for one in hits if all(other[: len(one)] == one for other in hits)]
    return whole[0] if whole else None


def candidates(known: Knowledge, text: str) -> tuple[Index, ...]:
    """Return the positions of the nodes a text may refer to; the closest kind of likeness wins."""
    wanted = _plain(text)
    fillers, forms = hints("fillers", known.language), hints("forms", known.language)
    nodes = [(index, _plain(node.name)) for index, node in walk(known.root) if index and node.name]
    asked = set(wanted.split()) - set(fillers)
    for fits in (
        lambda name: wanted == name,
        lambda name: bool(wanted) and (wanted in name or name in wanted),
        lambda name: bool(asked) and asked <= _forms(name, forms),
    ):
        hits = tuple(index for index, name in nodes if fits(name))
        if hits:
            return hits
    return ()


def _plain(text: str) -> str:
    return " ".join(re.findall(r"\w+", text.lower()))


def _forms(name: str, forms: Sequence[str]) -> set[str]:
    """Return the words of a name in the forms a teacher may give them: "move", "moving"."""
    return {
        form.format(word=word, stem=word.removesuffix("e"), last=word[-1])
        for word in name.split()
        for form in forms
    }


def unclear(dialogue: Dialogue, name: str, act: TeacherAct | None = None) -> Turn:
    """Ask which step was meant, or tell that none is called that, with the names there are."""
    known = dialogue.known
    hits = [at(known.root, index).name for index in candidates(known, name)]
    if len(hits) > 1 and act is not None:
        question = line("ask", "which", asked="which", names=hits)
        pending = Pending("which", question, (act,), name)
        return ask(replace(dialogue, pending=pending))
    told = line("error", "no_such_step", name=name, names=list(names(known.root)))
    return tell(dialogue, told)


def with_name(act: TeacherAct, old: str, new: str) -> TeacherAct:
    """Return an act that refers to a step by another name."""
    told: dict[str, Any] = {}
    for field in fields(act):
        value = getattr(act, field.name)
        if isinstance(value, Where) and value.subtask == old:
            told[field.name] = replace(value, subtask=new)
        elif isinstance(value, tuple):
            told[field.name] = tuple(new if one == old else one for one in value)
        elif value == old:
            told[field.name] = new
    return replace(act, **told)


def fully_named(
    dialogue: Dialogue, meant: Iterable[TeacherAct], text: str
) -> tuple[TeacherAct, ...]:
    """Return acts about the one step whose whole name was said, whatever it was taken for.

    "Split move up" is about "move up", not about "move to the target", which shares a word.
    """
    said = with_names(dialogue, text)
    return tuple(_named_in_full(dialogue, act, said) for act in meant)


def _named_in_full(dialogue: Dialogue, act: TeacherAct, text: str) -> TeacherAct:
    if isinstance(act, acts.Merge | acts.Unordered):
        # "Steps 2 and 3": the word stands before the first number only.
        named = tuple(_numbered(dialogue.known.root, one) for one in act.subtasks)
        return replace(act, subtasks=named)
    if not isinstance(act, _ABOUT_ONE):
        return act
    known = dialogue.known
    said = [one for one in names(known.root) if one and _stands(one, text)]
    whole = [one for one in said if not any(one != more and _stands(one, more) for more in said)]
    index = find(known, act.subtask)
    taken = act.subtask if index is None else name_at(known, index)
    if len(whole) != 1 or taken in said:
        return act
    return with_name(act, act.subtask, whole[0])


def _numbered(root: Sketch, text: str) -> str:
    """Return the name of the step that a bare number calls, or the text as it is."""
    number = int(text) if text.isdecimal() else 0
    known = text in names(root) or not 0 < number <= len(root.parts)
    return text if known else root.parts[number - 1].name or text


def _stands(name: str, text: str) -> bool:
    return f" {_plain(name)} " in f" {_plain(text)} "


def edited(
    dialogue: Dialogue,
    label: str,
    root: Sketch,
    told: RobotAct,
    *,
    now: Mapping[str, str] | None = None,
) -> Turn:
    """Keep a changed tree and tell it.

    Parameters
    ----------
    now : mapping of str to str, optional
        Where the demonstration stays cut as it was: what steps became, by their old names.
        The parts of those that are gone are given to others.
    """
    known = dialogue.known if now is None else _as_cut(dialogue.known, now)
    known = all_understood(with_roles(replace(known, root=root)))
    return settle(changed(dialogue, label, known), told)


def _as_cut(known: Knowledge, now: Mapping[str, str]) -> Knowledge:
    """Return what is known with the cuts and parts of the lesson fixed, as steps are called now."""
    if known.lesson is None:
        return known
    episodes = known.lesson.segmentation.episodes
    parts = enumerate((one.primitive or "" for one in episodes), start=1)
    assigned = tuple((number, now.get(name, name)) for number, name in parts if name)
    return replace(known, cuts_s=tuple(one.to_s for one in episodes[:-1]), assigned=assigned)


def name_at(known: Knowledge, index: Index) -> str:
    """Return the name of the node at a position."""
    return at(known.root, index).name


def spoken_of(dialogue: Dialogue, words: str) -> str:
    """Return the one primitive whose action is spoken of: "grasp it a bit lower"; else none."""
    action = read_action(words, dialogue.known.objects or (), dialogue.language).action
    if action is None or (action.verb != "hand" and action.way != "approach"):
        return ""
    leaves = primitives(dialogue.known.task.tree)
    alike = [one.name for one in leaves if (one.action.verb, one.action.way) == action_key(action)]
    return alike[0] if len(alike) == 1 else ""


def acts_at(dialogue: Dialogue, words: str) -> str:
    """Return the one primitive in which the hand acts at a thing: "higher at the tray"."""
    things = mentioned_objects(words, dialogue.known.objects or (), dialogue.language)
    leaves = primitives(dialogue.known.task.tree)
    there = [
        one.name for one in leaves if one.action.verb == "hand" and one.action.object in things
    ]
    return there[0] if len(there) == 1 else ""


def way_to(dialogue: Dialogue, words: str) -> str:
    """Return the primitive before which a way is meant: "carry it higher", "higher on the way".

    In motion that is the next one in which the hand acts, else the last.
    """
    known, run = dialogue.known, dialogue.run
    if known.lesson is None or not mentions(words, hints("on_the_way", dialogue.language)):
        return ""
    names = [leaf.name for leaf in primitives(known.task.tree)]
    acted = [one.primitive for one in known.lesson.stations if one.primitive in names]
    moving = run is not None and isinstance(dialogue.state, Running)
    now = run.primitive_at if run is not None and moving else len(names)
    ahead = [one for one in acted if names.index(one) >= now]
    return next(iter(ahead), acted[-1] if acted else "")


def action_key(action: Action) -> tuple[str, str]:
    """Return what two actions on different things have in common."""
    return action.verb, action.way
