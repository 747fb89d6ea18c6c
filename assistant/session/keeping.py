"""Saving and loading tasks for the dialogue, with what stands against it told as a reason."""

from __future__ import annotations

from assistant.dialogue.events import Kept, Loaded
from assistant.errors import BadInput
from assistant.files.library import Library
from assistant.model.task import Task

EXISTS = "exists"
UNKNOWN = "unknown"


def keep(library: Library, task: Task, name: str, *, overwrite: bool) -> Kept:
    """Write a task down, unless that would replace another one unasked."""
    if not overwrite and name in library and not library.holds(name, task):
        return Kept(name, EXISTS)
    try:
        library.save(name, task, overwrite=overwrite)
    except BadInput as error:
        return Kept(name, str(error.problems[0]))
    return Kept(name)


def discard(library: Library, name: str) -> Kept:
    """Delete a kept task."""
    try:
        library.delete(name)
    except BadInput as error:
        return Kept(name, str(error.problems[0]), discarded=True)
    return Kept(name, discarded=True)


def write_down(library: Library, task: Task, name: str, language: str) -> Kept:
    """Write the record of a task beside the kept ones, in a language of the phrasebooks."""
    try:
        return Kept(name, record=str(library.write_record(name, task, language)))
    except BadInput as error:
        return Kept(name, str(error.problems[0]), record="")


def load(library: Library, name: str) -> Loaded:
    """Read a kept task."""
    if name not in library:
        return Loaded(name, None, UNKNOWN)
    try:
        return Loaded(name, library.load(name))
    except BadInput as error:
        return Loaded(name, None, str(error.problems[0]))
