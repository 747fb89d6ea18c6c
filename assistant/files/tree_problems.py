"""What no form of a tree can see: names that stand twice, objects nobody introduced.

The raw document is walked, so that these are told together with whatever else is wrong.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from assistant.errors import Problem
from assistant.plain_yaml import Document

Place = list[str | int]


def tree_problems(document: Document) -> list[Problem]:
    """Return the problems of a task's tree; parts of a wrong shape are passed over."""
    told = document.value if isinstance(document.value, dict) else {}
    objects = told.get("objects")
    known = [str(name) for name in objects] if isinstance(objects, dict) else []
    problems: list[Problem] = []
    seen: dict[tuple[str, str], int] = {}
    for place, kind, node in _nodes(told.get("tree"), ["tree"]):
        problems += _named_twice(document, [*place, kind], (kind, str(node[kind])), seen)
        if kind == "primitive":
            problems += _unknown_objects(node, known, document, place)
    return problems


def _nodes(node: Any, place: Place) -> Iterator[tuple[Place, str, dict[str, Any]]]:
    if not isinstance(node, dict):
        return
    for kind in ("subtask", "primitive"):
        if kind in node:
            yield place, kind, node
            break
    parts = node.get("parts")
    for number, part in enumerate(parts if isinstance(parts, list) else []):
        yield from _nodes(part, [*place, "parts", number])


def _named_twice(
    document: Document, place: Place, name: tuple[str, str], seen: dict[tuple[str, str], int]
) -> Iterator[Problem]:
    line = document.line(place)
    first = seen.get(name)
    seen.setdefault(name, line)
    if first is not None:
        what = f"the name {name[1]!r} stands here again (first on line {first})"
        yield Problem(
            f"{document.file}:{line}", what, "each name once, so that talk can refer to it"
        )


def _unknown_objects(
    node: dict[str, Any], known: list[str], document: Document, place: Place
) -> Iterator[Problem]:
    for key, name in _mentioned(node):
        if isinstance(name, str) and name not in known:
            right = f"introduce it under objects: (known: {', '.join(known) or 'none'})"
            yield Problem(document.where([*place, *key]), f"there is no object {name!r}", right)


def _mentioned(node: dict[str, Any]) -> Iterator[tuple[Place, Any]]:
    action = node.get("action")
    if isinstance(action, dict):
        yield ["action", "object"], action.get("object")
    for key in ("before", "until"):
        conditions = node.get(key)
        for number, condition in enumerate(conditions if isinstance(conditions, list) else []):
            for kind, told in condition.items() if isinstance(condition, dict) else ():
                if kind != "hand":
                    names = told.values() if isinstance(told, dict) else [told]
                    yield from (([key, number], name) for name in names)
