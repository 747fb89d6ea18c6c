"""demonstration/1: a recording, what was said meanwhile, and where things were."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal

from pydantic import Field

from assistant.errors import BadInput, Problem
from assistant.files.forms import Form, Name, Number, check_format, the_document, validated
from assistant.files.recordings import read_recording, write_recording
from assistant.files.setups import SetupForm, setup_values
from assistant.files.writing import write_text
from assistant.model.demonstration import Demonstration, Recording, Spoken
from assistant.model.setup import Setup
from assistant.plain_yaml import Document, read_file, tidy, write

FORMAT = "demonstration/1"


class SpokenForm(Form):
    """Words said at an instant of the recording."""

    at_s: Number
    say: Name

    def spoken(self) -> Spoken:
        """Return the value."""
        return Spoken(self.at_s, self.say)


class DemonstrationFile(Form):
    """demonstration/1."""

    format: Literal["demonstration/1"]
    recording: Name = Field(description="a CSV file, relative to this one")
    approach_axis: Literal["x", "y", "z", "-x", "-y", "-z"] = "x"
    setup: SetupForm = SetupForm()
    cues: tuple[SpokenForm, ...] = ()
    key_states: tuple[SpokenForm, ...] = ()


def read_demonstration(path: Path) -> Demonstration:
    """Return a demonstration with its recording, found relative to the file.

    Raises
    ------
    BadInput
        With the problems of the file and of its recording.
    """
    document = the_document(list(read_file(path, flawed=True)), str(path))
    check_format(document, FORMAT)
    return demonstration_of(document, path.parent)


def demonstration_of(document: Document, folder: Path) -> Demonstration:
    """Return the demonstration a document tells; its recording lies relative to a folder."""
    found, problems = _recording(document, folder)
    form = validated(DemonstrationFile, document, problems)
    (recording,) = found
    return Demonstration(
        recording=recording,
        cues=tuple(each.spoken() for each in form.cues),
        key_states=tuple(each.spoken() for each in form.key_states),
        setup=form.setup.setup(),
        approach_axis=form.approach_axis,
        source=document.file,
    )


def _recording(
    document: Document, folder: Path
) -> tuple[tuple[Recording, ...], tuple[Problem, ...]]:
    """Return the recording, or what is wrong with it, to be told together with the rest."""
    told = document.value.get("recording") if isinstance(document.value, dict) else None
    if not isinstance(told, str) or not told:
        return (), ()
    path = folder / told
    if not os.path.exists(path) or os.path.isdir(path):
        what, right = f"there is no recording {path}", "a CSV file beside this file"
        return (), (Problem(document.where(["recording"]), what, right),)
    try:
        return (read_recording(path),), ()
    except BadInput as error:
        return (), error.problems


def write_demonstration(demonstration: Demonstration, path: Path) -> None:
    """Write a demonstration, and its recording beside it under the same name as CSV."""
    write_recording(demonstration.recording, path.with_suffix(".csv"))
    write_text(path, demonstration_text(demonstration, path.with_suffix(".csv").name))


def demonstration_text(demonstration: Demonstration, recording: str) -> str:
    """Return the text of a demonstration/1 file that names its recording."""
    spread = ["setup", "places"] if demonstration.setup.places else []
    return write(demonstration_values(demonstration, recording), spread=spread)


def demonstration_values(demonstration: Demonstration, recording: str) -> dict[str, Any]:
    """Return a demonstration that names its recording as plain values."""
    values = {
        "format": FORMAT,
        "recording": recording,
        "approach_axis": demonstration.approach_axis,
        "setup": _setup_values(demonstration.setup),
        "cues": spoken_values(demonstration.cues),
        "key_states": spoken_values(demonstration.key_states),
    }
    return {key: value for key, value in values.items() if value or key == "cues"}


def _setup_values(setup: Setup) -> dict[str, Any]:
    """Return the setup without what a demonstration takes for granted."""
    plain = setup_values(Setup())
    told = setup_values(setup)
    return {key: told[key] for key in told if key == "robot_start" or told[key] != plain[key]}


def spoken_values(spoken: Sequence[Spoken]) -> list[dict[str, Any]]:
    """Return spoken words as plain values."""
    return [{"at_s": tidy(each.at_s), "say": each.say} for each in spoken]
