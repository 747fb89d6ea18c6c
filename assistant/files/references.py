"""What a file names and is not there: other files, scenes and their bodies; told as warnings."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from assistant.errors import BadInput, Problem
from assistant.files.finding import CHECK, find_setups
from assistant.files.scenes import find_scene
from assistant.model.setup import Setup
from assistant.model.transcript import Demonstrate, SetupChoice, SetupStep, Transcript
from assistant.plain_yaml import read_file


def unknown_in_setups(setups: Sequence[Setup], path: Path) -> tuple[Problem, ...]:
    """Return scenes that are not there, and places of bodies their scene does not have."""
    found: list[Problem] = []
    for setup in setups:
        try:
            scene = find_scene(setup.scene, path)
        except BadInput as error:
            found += error.problems
            continue
        known = ", ".join(scene.bodies) or "none"
        found += [
            Problem(
                str(path),
                f"{setup.name}: {name!r} is no body of the scene {setup.scene}",
                f"bodies: {known}",
            )
            for name in setup.places
            if name not in scene.bodies
        ]
    return tuple(dict.fromkeys(found))


def unknown_in_transcript(play: Transcript, path: Path) -> tuple[Problem, ...]:
    """Return files and setups that a transcript names and that are not there."""
    found = list(unknown_in_head(play, path))
    for step in play.steps:
        where = f"{path}:{step.line}"
        if isinstance(step, Demonstrate) and step.recording is not None:
            found += _no_file(step.recording, path, where)
        if isinstance(step, SetupStep):
            found += _no_setup(step.choice, path, where)
    return tuple(found)


def unknown_in_head(play: Transcript, path: Path) -> tuple[Problem, ...]:
    """Return the task and setup a transcript begins with and that are not there."""
    task = () if play.task is None else _no_file(play.task, path, "task")
    told = (*task, *_no_setup(play.setup, path, "setup"))
    if not told:
        return ()
    (document,) = read_file(path, flawed=True)
    return tuple(Problem(document.where([each.where]), each.what, each.right) for each in told)


def _no_file(name: str, path: Path, where: str) -> tuple[Problem, ...]:
    if os.path.isfile(path.parent / name):
        return ()
    return (Problem(where, f"there is no file {path.parent / name}", CHECK),)


def _no_setup(choice: SetupChoice | None, path: Path, where: str) -> tuple[Problem, ...]:
    name = choice and (choice.file or choice.name)
    if not name:
        return ()
    try:
        find_setups(name, path)
    except BadInput as error:
        return tuple(Problem(where, each.what, each.right) for each in error.problems)
    return ()
