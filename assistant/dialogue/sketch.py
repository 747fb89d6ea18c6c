"""The sketch of a task tree that grows while the teacher introduces a task (paper II-A).

A node knows whether it is a single motion (`single` True), has parts (False), or has not been
asked about yet (None). Parts that were counted but not named have an empty name. Positions
from the root are counted from 1, as in `assistant.model.task`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from assistant.model.conditions import Condition
from assistant.model.task import Action, Index, Order, Primitive, Subtask


@dataclass(frozen=True, slots=True)
class Sketch:
    """One node of the tree as far as it has been told.

    Parameters
    ----------
    name : str
        Empty for a part that was counted but not named.
    single : bool or None
        True for one motion, False for a node with parts, None if nobody asked yet.
    parts : tuple of Sketch
    action : Action or None
        Of a single motion.
    """

    name: str = ""
    single: bool | None = None
    parts: tuple[Sketch, ...] = ()
    goal: str = ""
    order: Order = "sequential"
    optional: bool = False
    action: Action | None = None
    before: tuple[Condition, ...] = ()
    until: tuple[Condition, ...] = ()


def walk(node: Sketch, index: Index = ()) -> Iterator[tuple[Index, Sketch]]:
    """Yield every node below and including `node`, parents first, with its position."""
    yield index, node
    for position, part in enumerate(node.parts, start=1):
        yield from walk(part, (*index, position))


def at(root: Sketch, index: Index) -> Sketch:
    """Return the node at a position."""
    for position in index:
        root = root.parts[position - 1]
    return root


def put(root: Sketch, index: Index, node: Sketch) -> Sketch:
    """Return the tree with another node at a position."""
    if not index:
        return node
    head, *rest = index
    part = put(root.parts[head - 1], tuple(rest), node)
    return with_parts(root, (*root.parts[: head - 1], part, *root.parts[head:]))


def with_parts(node: Sketch, parts: tuple[Sketch, ...]) -> Sketch:
    """Return the node with these parts; with none it has not been asked about."""
    if not parts:
        return replace(node, parts=(), single=None, action=None)
    return replace(node, parts=parts, single=False, action=None)


def counted(node: Sketch, count: int) -> Sketch:
    """Return the node with that many parts, keeping those that have a name; 0 is one motion."""
    if count == 0:
        return replace(node, parts=(), single=True)
    named = tuple(part for part in node.parts if part.name)[:count]
    return with_parts(node, named + (Sketch(),) * (count - len(named)))


def removed(root: Sketch, index: Index) -> Sketch:
    """Return the tree without the node at a position; the root stays."""
    if not index:
        return root
    *above, position = index
    parent = at(root, tuple(above))
    left = parent.parts[: position - 1] + parent.parts[position:]
    return put(root, tuple(above), with_parts(parent, left))


def inserted(root: Sketch, parent: Index, position: int, node: Sketch) -> Sketch:
    """Return the tree with a new part of `parent` that comes at a position from 1."""
    old = at(root, parent)
    parts = (*old.parts[: position - 1], node, *old.parts[position - 1 :])
    return put(root, parent, with_parts(old, parts))


def names(root: Sketch) -> tuple[str, ...]:
    """Return the names of all named nodes below the root, in the order told."""
    return tuple(node.name for index, node in walk(root) if index and node.name)


def leaves(root: Sketch) -> tuple[tuple[Index, Sketch], ...]:
    """Return the nodes without parts, with their positions."""
    return tuple((index, node) for index, node in walk(root) if index and not node.parts)


def to_tree(node: Sketch) -> Subtask | Primitive:
    """Return the node as the model knows it; what nobody told is a free motion as shown."""
    if node.parts:
        parts = tuple(to_tree(part) for part in node.parts if part.name)
        return Subtask(node.name, parts, node.goal, node.order, node.optional)
    action = node.action or Action("free", node.name)
    return Primitive(node.name, action, node.before, node.until, node.optional)


def from_tree(node: Subtask | Primitive) -> Sketch:
    """Return the sketch of a tree that was read from a file."""
    if isinstance(node, Primitive):
        return Sketch(
            node.name,
            True,
            action=node.action,
            optional=node.optional,
            before=node.before,
            until=node.until,
        )
    parts = tuple(from_tree(part) for part in node.parts)
    single = False if parts else None
    return Sketch(node.name, single, parts, node.goal, node.order, node.optional)
