"""Order, merging and splitting of steps (paper II-A, III-C c)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from assistant.dialogue.asking import tell
from assistant.dialogue.finding import edited, find, name_at, unclear
from assistant.dialogue.sketch import (
    Sketch,
    at,
    inserted,
    put,
    removed,
    with_parts,
)
from assistant.dialogue.state import Dialogue, Pending
from assistant.dialogue.turn import Turn, changed, line
from assistant.language.hints import hints
from assistant.model import teacher_acts as acts
from assistant.model.robot_acts import RobotAct
from assistant.model.task import Action, Index

SHOW_AGAIN = "show_again_now"
"""The question whether a change is shown now; whoever denies it takes the change back."""


def unordered(dialogue: Dialogue, named: tuple[str, ...]) -> Turn:
    """Let the parts of a node come in any order."""
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
    parts = [part.name for part in node.parts]
    if 1 < len(set(found)) < len(parts) and node.order != "any":
        return _some_unordered(dialogue, parent, sorted(index[-1] for index in set(found)))
    root = put(known.root, parent, replace(node, order="any"))
    told = line("done", "unordered", names=parts, name=node.name or known.name)
    return edited(dialogue, "unordered", root, told)


def _some_unordered(dialogue: Dialogue, parent: Index, spots: list[int]) -> Turn:
    """Put some parts of a node that follow each other below one of their own, in any order."""
    known = dialogue.known
    node = at(known.root, parent)
    parts = [node.parts[spot - 1] for spot in spots]
    names = [part.name for part in parts]
    if spots != list(range(spots[0], spots[0] + len(spots))):
        return tell(dialogue, line("error", "not_siblings", names=names))
    name = joined_name(names, dialogue.language)
    group = Sketch(name, False, tuple(parts), order="any")
    left = (*node.parts[: spots[0] - 1], group, *node.parts[spots[-1] :])
    root = put(known.root, parent, with_parts(node, left))
    return edited(dialogue, "unordered", root, line("done", "unordered", names=names, name=name))


def joined_name(names: Sequence[str], language: str) -> str:
    """Return one name for steps that belong together."""
    joint: str = hints("joins", language)[0]
    return joint.join(names)


def ordered(dialogue: Dialogue, one: str, other: str) -> Turn:
    """Put one step before another; what was shown the other way must be shown anew."""
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
        return edited(dialogue, "ordered", root, told)
    root = inserted(removed(known.root, before), parent, after[-1], at(known.root, before))
    root = put(root, parent, replace(at(root, parent), order="sequential"))
    if known.lesson is None:
        return edited(dialogue, "ordered", root, told)
    # The path was shown in the old order: only another demonstration can teach the new one.
    ordered = changed(dialogue, "ordered", replace(known, root=root, learned_root=root))
    return offer_demonstration(ordered, told)


def offer_demonstration(dialogue: Dialogue, *lines: RobotAct) -> Turn:
    """Say that a change must be shown, and offer to watch now."""
    question = line("ask", SHOW_AGAIN, asked="ready")
    pending = Pending("ready", question, (acts.GoBack("demonstration"),))
    return tell(replace(dialogue, pending=pending), *lines)


def merge(dialogue: Dialogue, named: tuple[str, ...]) -> Turn:
    """Make one step of several that follow each other."""
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
    one = _joined(parts, dialogue.language)
    left = (*node.parts[: spots[0] - 1], one, *node.parts[spots[-1] :])
    root = put(known.root, parent, with_parts(node, left))
    told = line("done", "merged", names=[part.name for part in parts], name=one.name)
    return edited(dialogue, "merged", root, told, now=dict.fromkeys(_leaves_of(parts), one.name))


def _leaves_of(parts: tuple[Sketch, ...]) -> list[str]:
    """Return the names of the single motions that become one; those below others stay."""
    return [] if any(part.parts for part in parts) else [part.name for part in parts]


def _joined(parts: tuple[Sketch, ...], language: str) -> Sketch:
    name = joined_name([part.name for part in parts], language)
    if any(part.parts for part in parts):
        inner = tuple(piece for part in parts for piece in (part.parts or (part,)))
        return Sketch(name, False, inner)
    told = [part.action for part in parts if part.action is not None]
    hands = [action for action in told if action.verb == "hand"]
    action = (hands or told or [Action("free", name)])[0]
    return Sketch(name, True, (), action=action, until=parts[-1].until, before=parts[0].before)


def split(dialogue: Dialogue, name: str) -> Turn:
    """Open a step, or replace a node by its parts."""
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
        return edited(dialogue, "split", root, told)
    # A name that tells one motion would at once be read as one again: two parts are opened.
    opened = with_parts(replace(node, action=None), (Sketch(), Sketch()))
    root = put(known.root, index, opened)
    topic = "split" if known.lesson is None else "split_look"
    return edited(dialogue, "split", root, line("done", topic, name=node.name))
