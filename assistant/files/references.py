"""What a file names and is not there: other files, scenes and their bodies; told as warnings."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from assistant.errors import BadInput, Problem
from assistant.files.finding import CHECK, find_setups
from assistant.files.scenes import find_scene
from assistant.model.setup import Setup
from assistant.model.transcript import Demonstrate, SetupChoice, SetupStep, Transcript


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
    found: list[Problem] = []
    for line, name in _named_files(play):
        if not (path.parent / name).is_file():
            where = f"{path}:{line}" if line else str(path)
            found.append(Problem(where, f"there is no file {path.parent / name}", CHECK))
    for line, choice in _named_setups(play):
        try:
            find_setups(choice, path)
        except BadInput as error:
            where = f"{path}:{line}" if line else str(path)
            found += [Problem(where, each.what, each.right) for each in error.problems]
    return tuple(found)


def _named_files(play: Transcript) -> Iterator[tuple[int, str]]:
    if play.task is not None:
        yield 0, play.task
    for step in play.steps:
        if isinstance(step, Demonstrate) and step.recording is not None:
            yield step.line, step.recording


def _named_setups(play: Transcript) -> Iterator[tuple[int, str]]:
    chosen: list[tuple[int, SetupChoice | None]] = [(0, play.setup)]
    chosen += [(step.line, step.choice) for step in play.steps if isinstance(step, SetupStep)]
    for line, choice in chosen:
        name = choice and (choice.file or choice.name)
        if name:
            yield line, name
