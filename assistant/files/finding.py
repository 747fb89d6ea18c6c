"""Finds setups by the names people use: a file, the name of a shipped file, or of a setup."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from assistant.errors import BadInput
from assistant.files.setups import read_setups
from assistant.files.shipped import shipped
from assistant.model.setup import Setup

CHECK = "check the name and the folder"


def find_setups(name: str, near: Path) -> tuple[tuple[Setup, ...], Path]:
    """Return the setups a name stands for, and the file they are in.

    Parameters
    ----------
    name : str
        A file relative to `near`; the name of a file in ``setups`` beside it or shipped
        (``table1``); or of a single setup in one (``table1_1``).
    near : Path
        The file or folder that names it.

    Raises
    ------
    BadInput
        Where there is none; the message lists the names that are known.
    """
    folder = near if near.is_dir() else near.parent
    # A folder names nothing: where the program stands is not where it is wrong.
    where = "setup" if near.is_dir() else str(near)
    if os.path.isfile(folder / name):  # also of a name too long for a file
        return read_setups(folder / name), folder / name
    if name.endswith((".yaml", ".yml", ".json")):
        raise BadInput.one(where, f"there is no setup file {folder / name}", CHECK)
    known: list[str] = []
    for path in _files(folder):
        setups = read_setups(path)
        if path.stem == name:
            return setups, path
        for setup in setups:
            if setup.name == name:
                return (setup,), path
        known += [path.stem, *(setup.name for setup in setups)]
    listed = ", ".join(dict.fromkeys(known))
    raise BadInput.one(where, f"there is no setup {name!r}", f"known: {listed}")


def _files(folder: Path) -> Iterator[Path]:
    places = [folder / "setups", folder.parent / "setups", shipped("tasks") / "setups"]
    for place in dict.fromkeys(place.resolve() for place in places):
        yield from sorted(place.glob("*.yaml"))
