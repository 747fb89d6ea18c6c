"""The task tree for other programs: a behavior tree (BehaviorTree.CPP 4) and Graphviz."""

from __future__ import annotations

import json
import re
from xml.etree import ElementTree

from assistant.files.wording import action_words, conditions_words
from assistant.model.conditions import Condition
from assistant.model.task import Primitive, Subtask, Task, walk

_NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def behavior_tree(task: Task) -> str:
    """Return the tree as XML: sequences of actions, guarded by their before-conditions.

    What may be skipped never fails; parts in any order are marked in their description,
    since they follow one another but may be exchanged.
    """
    root = ElementTree.Element("root", BTCPP_format="4", main_tree_to_execute=task.name)
    tree = ElementTree.SubElement(root, "BehaviorTree", ID=task.name)
    if task.goal:
        tree.set("_description", task.goal)
    _add(tree, task.tree)
    for element in root.iter():
        for name, text in element.attrib.items():
            element.set(name, _NO_XML.sub(" ", text))
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def _add(parent: ElementTree.Element, node: Subtask | Primitive) -> None:
    if node.optional:
        parent = ElementTree.SubElement(parent, "ForceSuccess", _description="optional")
    sequence = ElementTree.SubElement(parent, "Sequence", name=node.name)
    if isinstance(node, Subtask):
        told = [node.goal, "parts in any order" if node.order == "any" else ""]
        if any(told):
            sequence.set("_description", "; ".join(filter(None, told)))
        for part in node.parts:
            _add(sequence, part)
        return
    for condition in node.before:
        _add_condition(sequence, condition)
    action = node.action
    kind = "free_motion" if action.verb == "free" else f"{action.verb}_{action.way}"
    leaf = ElementTree.SubElement(sequence, "Action", ID=kind, name=node.name)
    if action.verb == "free":
        leaf.set("text", action.way)
    if action.object:
        leaf.set("object", action.object)
    for condition in node.until:
        _add_condition(sequence, condition)


def _add_condition(sequence: ElementTree.Element, condition: Condition) -> None:
    leaf = ElementTree.SubElement(sequence, "Condition", ID=condition.kind)
    if condition.object:
        leaf.set("state" if condition.kind == "hand" else "object", condition.object)
    if condition.target:
        leaf.set("target", condition.target)


def dot(task: Task) -> str:
    """Return the tree as a Graphviz graph."""
    lines = [f"digraph {_quoted(task.name)} {{", "  node [shape=box, fontname=sans];"]
    for index, node in walk(task.tree):
        style = ", style=dashed" if node.optional else ""
        lines.append(f"  {_id(index)} [label={_quoted(_label(node))}{style}];")
        if index:
            lines.append(f"  {_id(index[:-1])} -> {_id(index)};")
    return "\n".join([*lines, "}", ""])


def _id(index: tuple[int, ...]) -> str:
    return "_".join(["n", *map(str, index)])


def _label(node: Subtask | Primitive) -> str:
    if isinstance(node, Subtask):
        order = "\n(in any order)" if node.order == "any" else ""
        return f"{node.name}{order}"
    conditions = conditions_words(node)
    return "\n".join(filter(None, [node.name, action_words(node), conditions]))


def _quoted(text: str) -> str:
    return re.sub(r"\\(?![n\"\\])", r"\\\\", json.dumps(text, ensure_ascii=False))
