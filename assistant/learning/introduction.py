"""What the introduction says about cuts: orders in which the primitives may come."""

from __future__ import annotations

from collections.abc import Iterator
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
