"""Setups told on the command line, with their scenes and where they stand in their files."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.errors import BadInput, Problem

if TYPE_CHECKING:
    from assistant.model.scene import Scene
    from assistant.model.setup import Setup
    from assistant.plain_yaml import Document


@dataclass(frozen=True, slots=True)
class Placed:
    """A setup and the scene it names.

    Parameters
    ----------
    where : str
        ``file:line`` of its places, or where it begins if it has none.
    """

    scene: Scene
    setup: Setup
    where: str


def read_places(paths: Sequence[Path]) -> list[Placed]:
    """Return the setups of files, one after another, or raise `BadInput` with all problems."""
    found: list[Placed] = []
    problems: list[Problem] = []
    for path in paths:
        try:
            told = _documents(path)
        except BadInput as error:
            problems += error.problems
            continue
        for document, setup in told:
            try:
                scene = _scene(setup, path, document.where(["scene"]))
            except BadInput as error:
                problems += error.problems
            else:
                found.append(Placed(scene, setup, document.where(["places"])))
    if problems:
        raise BadInput(problems)
    return found


def _documents(path: Path) -> list[tuple[Document, Setup]]:
    from assistant.files.setups import setups_of
    from assistant.plain_yaml import read_file

    documents = [each for each in read_file(path, flawed=True) if each.value is not None]
    if not documents:
        raise BadInput.one(f"{path}:1", "the file is empty", "begin with format: setup/1")
    return list(zip(documents, setups_of(documents), strict=True))


def _scene(setup: Setup, path: Path, where: str) -> Scene:
    """Return the scene a setup names; one that is nowhere is told where the setup names it."""
    from assistant.files.scenes import find_scene

    try:
        return find_scene(setup.scene, path)
    except BadInput as error:
        if error.problems[0].where != str(path):
            raise
        raise BadInput([Problem(where, one.what, one.right) for one in error.problems]) from error


def check_places(places: Sequence[Placed], check: Callable[[Scene, Setup], object]) -> None:
    """Check every setup, and tell what each lacks with its file and line.

    Raises
    ------
    BadInput
        With the problems of all setups.
    """
    problems: list[Problem] = []
    for placed in places:
        name = placed.setup.name
        try:
            check(placed.scene, placed.setup)
        except BadInput as error:
            problems += (
                Problem(placed.where, f"{name}: {one.what}", one.right) for one in error.problems
            )
    if problems:
        raise BadInput(problems)
