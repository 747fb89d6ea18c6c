"""Tasks told on the command line: by their file, or by the name they are kept under."""

from __future__ import annotations

from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.errors import BadInput

if TYPE_CHECKING:
    from assistant.model.task import Task


def task_path(told: Path | str) -> Path:
    """Return the file of a task that is told by its file or by its name.

    Raises
    ------
    BadInput
        If there is neither such a file nor a kept task of that name; it tells the likeliest
        names that there are.
    """
    from assistant.files.library import library

    path = Path(told)
    if path.exists() or path.suffix or len(path.parts) > 1:
        return path
    # A name is told as people say it: with blanks, and in any capitals.
    kept = library()
    if str(told) in kept:
        return kept.path(str(told))
    raise BadInput.one(str(told), "is no file and no task that is kept", _right(str(told)))


def learned_task(told: Path | str) -> Task:
    """Return a task that was learned, told by its file or by its name.

    Raises
    ------
    BadInput
        If there is none, or nothing has been learned for it yet.
    """
    from assistant.files.tasks import read_task

    path = task_path(told)
    return must_be_learned(read_task(path), path)


def must_be_learned(task: Task, path: Path) -> Task:
    """Return the task of a file, or raise `BadInput` if nothing was learned for it."""
    if task.learned is None:
        what, right = "nothing has been learned for this task yet", "show it first: assistant learn"
        raise BadInput.one(f"{path}:1", what, right)
    return task


def _right(told: str) -> str:
    from assistant.files.library import library

    names = library().names()
    if not names:
        return "a task file; no tasks are kept yet"
    near = get_close_matches(told.lower().replace(" ", "_"), names, n=3)
    return f"did you mean: {', '.join(near)}" if near else f"a file, or one of: {', '.join(names)}"
