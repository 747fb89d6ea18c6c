"""What the introduction says about cuts: orders in which the primitives may come."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice, permutations, product

from assistant.model.task import Primitive, Subtask, Task

_MOST_ORDERS = 120


def orders(task: Task) -> tuple[tuple[int, ...], ...]:
    """Return the orders of the leaves that the tree allows, the one told first.

    Parts of a subtask of order ``any`` may come in every order, each as a whole; of very many
    orders only the first are returned.
    """
    counted: dict[str, int] = {}
    for leaf in _leaves(task.tree):
        counted[leaf.name] = len(counted)
    found = islice(_orders(task.tree), _MOST_ORDERS)
    return tuple(tuple(counted[name] for name in order) for order in found)


def other_orders(task: Task) -> tuple[tuple[int, ...], ...]:
    """Return orders the tree does not allow, but a hand could carry out.

    Parts that take things and let all of them go again begin and end with an empty hand: these
    can change places, as wholes, where the teacher told them in sequence.
    """
    told = set(orders(task))
    free = orders(replace(task, tree=_freed(task.tree)))
    counted = {leaf.name: k for k, leaf in enumerate(_leaves(task.tree))}
    moved = {leaf.name: k for k, leaf in enumerate(_leaves(_freed(task.tree)))}
    names = {k: name for name, k in moved.items()}
    found = (tuple(counted[names[k]] for k in order) for order in free)
    return tuple(order for order in found if order not in told)


def _freed(tree: Subtask) -> Subtask:
    """Return the tree with parts that can change places gathered in a node of any order."""
    parts = tuple(_freed(part) if isinstance(part, Subtask) else part for part in tree.parts)
    freed: list[Subtask | Primitive] = []
    run: list[Subtask | Primitive] = []
    for part in (*parts, None):
        if part is not None and _whole(part):
            run.append(part)
            continue
        if len(run) > 1:
            freed.append(Subtask(f"{tree.name}, freed {len(freed)}", tuple(run), order="any"))
        else:
            freed += run
        run = []
        if part is not None:
            freed.append(part)
    return replace(tree, parts=tuple(freed))


def _whole(part: Subtask | Primitive) -> bool:
    """Tell whether a part begins and ends with an empty hand and takes something between."""
    ways = [leaf.action.way for leaf in _leaves(part) if leaf.action.verb == "hand"]
    return ways.count("close") == ways.count("open") > 0


def _leaves(node: Subtask | Primitive) -> Iterator[Primitive]:
    if isinstance(node, Primitive):
        yield node
        return
    for part in node.parts:
        yield from _leaves(part)


def _orders(node: Subtask | Primitive) -> Iterator[tuple[str, ...]]:
    if isinstance(node, Primitive):
        yield (node.name,)
        return
    ways = permutations(node.parts) if node.order == "any" else iter((node.parts,))
    for way in islice(ways, _MOST_ORDERS):
        inner = [list(islice(_orders(part), _MOST_ORDERS)) for part in way]
        for choice in product(*inner):
            yield tuple(name for names in choice for name in names)
