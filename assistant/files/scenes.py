"""scene/1: what things look like; bodies, tables, obstacles and the hand's speed limit."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from assistant.errors import BadInput
from assistant.files.forms import (
    Form,
    Name,
    NotNegative,
    Number,
    Positive,
    Text,
    Triple,
    check_format,
    the_document,
    validated,
)
from assistant.files.shipped import shipped
from assistant.files.writing import write_text
from assistant.model.scene import Body, Obstacle, Scene
from assistant.model.setup import Triple as Numbers
from assistant.plain_yaml import Document, read_file, tidy, write

FORMAT = "scene/1"
Size = tuple[NotNegative, NotNegative, NotNegative]
_PLAIN = Body("")


class BodyForm(Form):
    """A thing on the table."""

    shape: Literal["box", "cylinder", "sphere", "cup"] = "box"
    size_mm: Size = Field(description="box: x, y, z; round ones: diameter, diameter, height")
    mass_kg: NotNegative = Field(_PLAIN.mass_kg, description="0 for what cannot be moved")
    friction: NotNegative = _PLAIN.friction
    grasp_xyz_mm: Triple = Field(
        _PLAIN.grasp_xyz_mm, description="the flange at the grasp, from the middle of the base"
    )
    grasp_rpy_deg: Triple = _PLAIN.grasp_rpy_deg
    normal: Triple = Field(_PLAIN.normal, description="surface normal of a target")
    color: Text = ""
    hole_mm: Size = Field(
        _PLAIN.hole_mm, description="of a box with a hole from above: x, y and depth"
    )

    @model_validator(mode="after")
    def _fits_hole(self) -> BodyForm:
        if not any(self.hole_mm):
            return self
        if self.shape != "box" or not all(self.hole_mm):
            raise ValueError("a hole that cannot be; it is in a box, and has x, y and depth")
        if any(hole >= size for hole, size in zip(self.hole_mm, self.size_mm, strict=True)):
            raise ValueError("the hole does not fit in the box; it is smaller on every side")
        return self

    @model_validator(mode="after")
    def _has_normal(self) -> BodyForm:
        if not any(self.normal):
            raise ValueError("the normal has no direction; [0, 0, 1] is up")
        return self

    def body(self, name: str) -> Body:
        """Return the body described."""
        return Body(name, **self.model_dump())


class ObstacleForm(Form):
    """A box the arm must not touch."""

    name: Name
    size_mm: tuple[Positive, Positive, Positive]
    xyz_mm: Triple = Field(description="middle of its base")
    rpy_deg: Triple = (0.0, 0.0, 0.0)
    color: Text = ""

    def obstacle(self) -> Obstacle:
        """Return the box described."""
        return Obstacle(**self.model_dump())


class SceneFile(Form):
    """scene/1."""

    format: Literal["scene/1"]
    name: Name
    bodies: dict[Name, BodyForm] = Field(default_factory=dict)
    tables: tuple[ObstacleForm, ...] = ()
    obstacles: tuple[ObstacleForm, ...] = ()
    hand_speed_m_s: Annotated[Number, Field(gt=0, le=5)] = 0.25


def read_scene(path: Path) -> Scene:
    """Return the scene of a file, or raise `BadInput` with all its problems."""
    return scene_of(the_document(list(read_file(path, flawed=True)), str(path)))


def scene_of(document: Document) -> Scene:
    """Return the scene a document tells."""
    check_format(document, FORMAT)
    form = validated(SceneFile, document)
    return Scene(
        name=form.name,
        bodies={name: body.body(name) for name, body in form.bodies.items()},
        tables=tuple(each.obstacle() for each in form.tables),
        obstacles=tuple(each.obstacle() for each in form.obstacles),
        hand_speed_m_s=form.hand_speed_m_s,
    )


def find_scene(name: str, near: Path) -> Scene:
    """Return the scene of a name, as setups tell it.

    Parameters
    ----------
    name : str
        A file relative to `near`, or a name: then ``NAME.yaml`` beside `near`, in ``scenes``
        beside it or beside its folder, or shipped.
    near : Path
        The file or folder that names it.
    """
    folder = near if near.is_dir() else near.parent
    if name.endswith((".yaml", ".yml", ".json")):
        return read_scene(folder / name)
    places = [folder, folder / "scenes", folder.parent / "scenes", shipped("tasks") / "scenes"]
    for place in places:
        path = place / f"{name}.yaml"
        if os.path.isfile(path) and _is_scene(path):
            return read_scene(path)
    where = "scene" if near.is_dir() else str(near)
    known = sorted({path.stem for place in places[1:] for path in place.glob("*.yaml")})
    raise BadInput.one(where, f"there is no scene {name!r}", f"known: {', '.join(known)}")


def _is_scene(path: Path) -> bool:
    with path.open(encoding="utf-8", errors="replace") as file:
        return f"format: {FORMAT}" in file.read(2000)


def write_scene(scene: Scene, path: Path) -> None:
    """Write a scene, so that reading gives the same values."""
    write_text(path, scene_text(scene))


def scene_text(scene: Scene) -> str:
    """Return the text of a scene/1 file."""
    return write(scene_values(scene), spread=["bodies", "tables", "obstacles"])


def scene_values(scene: Scene) -> dict[str, Any]:
    """Return a scene as plain values."""
    values: dict[str, Any] = {"format": FORMAT, "name": scene.name}
    if scene.bodies:
        values["bodies"] = {name: _body_values(body) for name, body in scene.bodies.items()}
    for key, boxes in (("tables", scene.tables), ("obstacles", scene.obstacles)):
        if boxes:
            values[key] = [_obstacle_values(box) for box in boxes]
    return {**values, "hand_speed_m_s": tidy(scene.hand_speed_m_s)}


def _body_values(body: Body) -> dict[str, Any]:
    values: dict[str, Any] = {
        "shape": body.shape,
        "size_mm": _row(body.size_mm),
        "mass_kg": tidy(body.mass_kg),
        "friction": tidy(body.friction),
        "grasp_xyz_mm": _row(body.grasp_xyz_mm),
    }
    if body.grasp_rpy_deg != _PLAIN.grasp_rpy_deg:
        values["grasp_rpy_deg"] = _row(body.grasp_rpy_deg)
    if body.normal != _PLAIN.normal:
        values["normal"] = _row(body.normal)
    if any(body.hole_mm):
        values["hole_mm"] = _row(body.hole_mm)
    return {**values, "color": body.color} if body.color else values


def _obstacle_values(box: Obstacle) -> dict[str, Any]:
    values: dict[str, Any] = {
        "name": box.name,
        "size_mm": _row(box.size_mm),
        "xyz_mm": _row(box.xyz_mm),
    }
    if any(box.rpy_deg):
        values["rpy_deg"] = _row(box.rpy_deg)
    return {**values, "color": box.color} if box.color else values


def _row(triple: Numbers) -> list[float | int]:
    return [tidy(value) for value in triple]
