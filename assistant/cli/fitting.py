"""Which scene a task is evaluated in when none is named: one that has all its things."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from assistant.errors import BadInput

if TYPE_CHECKING:
    from assistant.model.scene import Scene
    from assistant.model.task import Task

USUAL = "table"


def fitting_scene(task: Task, near: Path, name: str = "") -> Scene:
    """Return the scene of a name, or without one the first that has all a task is about.

    Parameters
    ----------
    task : Task
    near : Path
        The task's file: scenes are looked for around it, and among those that ship.
    name : str
        Empty: the table of pick and place, then whatever scene fits.

    Raises
    ------
    BadInput
        If the scene named lacks something, or none has everything.
    """
    from assistant.files.scenes import find_scene

    if name:
        scene = find_scene(name, near)
        if lacking := _lacking(task, scene):
            what = f"scene {scene.name} has no {', no '.join(lacking)}"
            raise BadInput.one(str(near), what, "name one that has with --scene")
        return scene
    for known in _known(near):
        scene = find_scene(known, near)
        if not _lacking(task, scene):
            return scene
    things = ", ".join(thing.name for thing in task.objects)
    raise BadInput.one(str(near), f"no scene has {things}", "name one that has with --scene")


def _lacking(task: Task, scene: Scene) -> list[str]:
    return [thing.name for thing in task.objects if thing.name not in scene.bodies]


def _known(near: Path) -> list[str]:
    from assistant.files.shipped import shipped

    folders = [near.parent / "scenes", near.parent.parent / "scenes", shipped("tasks") / "scenes"]
    names = {path.stem for folder in folders for path in folder.glob("*.yaml")}
    return sorted(names, key=lambda name: (name != USUAL, name))
