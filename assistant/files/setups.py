"""setup/1: where the robot starts and where things are; one or several documents a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

from pydantic import Field, model_validator

from assistant.errors import BadInput, Problem
from assistant.files.forms import Form, Name, Triple, check_format, exactly_one, validated
from assistant.files.writing import write_text
from assistant.model.setup import READY, Place, Setup
from assistant.plain_yaml import Document, read_file, tidy, write

FORMAT = "setup/1"


class PlaceForm(Form):
    """A place, told either by the body's base or by the flange, never mixed."""

    model_config = exactly_one("xyz_mm", "hand_xyz_mm")
    xyz_mm: Triple | None = Field(None, description="middle of the body's base")
    rpy_deg: Triple | None = Field(None, description="turns about fixed x, then y, then z")
    hand_xyz_mm: Triple | None = Field(None, description="the flange when it grasps there")
    hand_rpy_deg: Triple | None = None

    @model_validator(mode="after")
    def _one_way(self) -> PlaceForm:
        body = self.xyz_mm is not None
        hand = self.hand_xyz_mm is not None
        if body == hand:
            raise ValueError(
                "a place is told once; by xyz_mm (of the body) or hand_xyz_mm, and not both"
            )
        if (self.rpy_deg if hand else self.hand_rpy_deg) is not None:
            raise ValueError(
                "two ways are mixed; xyz_mm goes with rpy_deg, hand_xyz_mm with hand_rpy_deg"
            )
        return self

    def place(self) -> Place:
        """Return the place told."""
        if self.hand_xyz_mm is not None:
            return Place("hand", self.hand_xyz_mm, self.hand_rpy_deg or (0.0, 0.0, 0.0))
        return Place("body", self.xyz_mm or (0.0, 0.0, 0.0), self.rpy_deg or (0.0, 0.0, 0.0))


class HandPlaceForm(Form):
    """A place of the hand's flange."""

    hand_xyz_mm: Triple
    hand_rpy_deg: Triple = (0.0, 0.0, 0.0)


class SetupForm(Form):
    """Where things are, inside another file."""

    name: Name = "setup"
    scene: Name = "table"
    robot_start: HandPlaceForm | None = None
    places: dict[Name, PlaceForm] = Field(default_factory=dict)

    def setup(self) -> Setup:
        """Return the setup told."""
        start = self.robot_start
        return Setup(
            name=self.name,
            scene=self.scene,
            robot_start=Place("hand", start.hand_xyz_mm, start.hand_rpy_deg) if start else READY,
            places={name: form.place() for name, form in self.places.items()},
        )


class SetupFile(SetupForm):
    """setup/1."""

    format: Literal["setup/1"]


def read_setups(path: Path) -> tuple[Setup, ...]:
    """Return the setups of a file, one a document.

    Raises
    ------
    BadInput
        With the problems of all documents, each as ``file:line``.
    """
    documents = [each for each in read_file(path, flawed=True) if each.value is not None]
    if not documents:
        raise BadInput.one(f"{path}:1", "the file is empty", f"begin with format: {FORMAT}")
    return setups_of(documents)


def setups_of(documents: Sequence[Document]) -> tuple[Setup, ...]:
    """Return the setups that documents tell, or raise `BadInput` with the problems of all."""
    setups: list[Setup] = []
    problems: list[Problem] = []
    for document in documents:
        try:
            setups.append(setup_of(document))
        except BadInput as error:
            problems.extend(error.problems)
    if problems:
        raise BadInput(problems)
    return tuple(setups)


def setup_of(document: Document) -> Setup:
    """Return the setup a document tells."""
    check_format(document, FORMAT)
    return validated(SetupFile, document).setup()


def write_setups(setups: Sequence[Setup], path: Path) -> None:
    """Write setups, one a document, so that reading gives the same values."""
    write_text(path, "---\n".join(setup_text(setup) for setup in setups))


def setup_text(setup: Setup) -> str:
    """Return the text of a setup/1 document."""
    return write(setup_file_values(setup), spread=["places"])


def setup_file_values(setup: Setup) -> dict[str, Any]:
    """Return a setup/1 document as plain values."""
    return {"format": FORMAT, **setup_values(setup)}


def setup_values(setup: Setup) -> dict[str, Any]:
    """Return a setup as plain values."""
    return {
        "name": setup.name,
        "scene": setup.scene,
        "robot_start": place_values(setup.robot_start),
        "places": places_values(setup.places),
    }


def places_values(places: Mapping[str, Place]) -> dict[str, Any]:
    """Return named places as plain values."""
    return {name: place_values(place) for name, place in places.items()}


def place_values(place: Place) -> dict[str, Any]:
    """Return a place as plain values, with the keys of its kind."""
    prefix = "hand_" if place.kind == "hand" else ""
    return {
        f"{prefix}xyz_mm": [tidy(value) for value in place.xyz_mm],
        f"{prefix}rpy_deg": [tidy(value) for value in place.rpy_deg],
    }
