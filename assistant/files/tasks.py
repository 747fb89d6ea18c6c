"""task/1: the tree a teacher introduced and, once shown, all that was learned."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal

from pydantic import Field

from assistant.files.forms import Form, Name, Text, check_format, the_document, validated
from assistant.files.lesson_forms import LearnedForm
from assistant.files.lessons import learned_values, lesson_of
from assistant.files.tree_forms import (
    ObjectForm,
    SubtaskForm,
    node_values,
    objects_of,
)
from assistant.files.tree_problems import tree_problems
from assistant.files.writing import write_text
from assistant.model.task import Task, primitives
from assistant.plain_yaml import Document, read_file, write

FORMAT = "task/1"
SPREAD = ("tree", "parts", "rows", "points", "episodes", "docking", "feedback", "learned")
ROWS = ("points", "episodes")


class TaskFile(Form):
    """task/1."""

    format: Literal["task/1"]
    name: Name
    goal: Text = ""
    objects: dict[Name, ObjectForm] = Field(default_factory=dict)
    tree: SubtaskForm
    learned: LearnedForm | None = None


def read_task(path: Path) -> Task:
    """Return the task of a file.

    Raises
    ------
    BadInput
        With every problem, each as ``file:line``.
    """
    return task_of(the_document(list(read_file(path, flawed=True)), str(path)))


def task_of(document: Document) -> Task:
    """Return the task a document tells."""
    check_format(document, FORMAT)
    form = validated(TaskFile, document, tree_problems(document))
    tree = form.tree.node()
    task = Task(form.name, tree, form.goal, objects_of(form.objects))
    leaves = len(primitives(tree))
    learned = None if form.learned is None else lesson_of(form.learned, document, leaves)
    return Task(task.name, task.tree, task.goal, task.objects, learned)


def write_task(task: Task, path: Path) -> None:
    """Write a task with all it has learned, so that reading gives the same values."""
    write_text(path, task_text(task))


def task_text(task: Task) -> str:
    """Return the text of a task/1 file."""
    return write(task_values(task), spread=SPREAD, rows=ROWS)


def task_values(task: Task) -> dict[str, Any]:
    """Return a task as plain values."""
    values: dict[str, Any] = {"format": FORMAT, "name": task.name}
    if task.goal:
        values["goal"] = task.goal
    if task.objects:
        values["objects"] = {each.name: {"role": each.role} for each in task.objects}
    values["tree"] = node_values(task.tree)
    if task.learned is not None:
        values["learned"] = learned_values(task.learned)
    return values
