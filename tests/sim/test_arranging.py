"""Setups are drawn so that a task makes sense: lines ahead of what is pushed, balls in cups."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np
import pytest

from assistant.files.scenes import find_scene
from assistant.files.tasks import read_task
from assistant.geometry import IDENTITY, Array, compose, inverse, relative
from assistant.model.lesson import Lesson, Segmentation, Station
from assistant.model.scene import Scene
from assistant.model.task import Task
from sim.arranging import arranged, concerned, contained, pushed_ahead
from sim.touching import lies_in

Kind = Literal["grasp", "release", "touch"]
TASKS = Path(__file__).parents[2] / "tasks"


def station(scene: Scene, kind: Kind, name: str, frame: str, base: Array) -> Station:
    pose = compose(base, scene.bodies[frame].hand_in_body)
    none = np.array(IDENTITY)
    return Station(kind, name, frame, "", 0, 0, 0, pose, none, none)


def at(x: float, y: float) -> Array:
    return np.array([x, y, 0.24, 0.0, 0.0, 0.0, 1.0])


def taught(name: str, *stations: Station) -> Task:
    lesson = Lesson(Segmentation((), (), None), None, stations)
    return replace(read_task(TASKS / f"{name}.yaml"), learned=lesson)


def pushing() -> tuple[Task, Scene]:
    scene = find_scene("pushing_table", TASKS)
    touch = station(scene, "touch", "box", "box", at(0.72, 0.04))
    push = station(scene, "touch", "box", "line", at(0.885, 0.04))
    return taught("pushing", touch, push), scene


def pouring() -> tuple[Task, Scene]:
    scene = find_scene("pouring_table", TASKS)
    return taught("pouring", station(scene, "grasp", "cup", "cup", at(0.6, 0.2))), scene


def test_a_line_lies_ahead_of_what_is_pushed_to_it() -> None:
    task, scene = pushing()
    assert pushed_ahead(task, scene)["line"][1] == pytest.approx([0.165, 0.0, 0.0], abs=1e-9)
    random = np.random.default_rng(1)
    drawn = [places for _ in range(40) if (places := arranged(task, scene, random, 180.0))]
    assert len(drawn) > 10
    for places in drawn:
        line = relative(places["box"].pose, places["line"].pose)
        assert 0.12 < float(line[0]) < 0.21
        assert abs(float(line[1])) < 0.02


def test_balls_lie_in_the_cup_that_is_carried() -> None:
    task, scene = pouring()
    drawn = arranged(task, scene, np.random.default_rng(3), 60.0)
    while drawn is None:
        drawn = arranged(task, scene, np.random.default_rng(4), 60.0)
    balls = [name for name in drawn if scene.bodies[name].shape == "sphere"]
    assert len(balls) == 4
    cup = scene.body_pose("cup", drawn["cup"])
    spots = [compose(inverse(cup), scene.body_pose(name, drawn[name])) for name in balls]
    assert all(lies_in(scene.bodies["cup"], spot) for spot in spots)
    gaps = [np.linalg.norm(a[:3] - b[:3]) for k, a in enumerate(spots) for b in spots[:k]]
    assert min(gaps) > 0.018


def test_nothing_is_put_in_a_cup_no_one_carries() -> None:
    _, scene = pouring()
    assert contained(read_task(TASKS / "pouring.yaml"), scene, {}) == {}


def test_things_the_lesson_came_upon_are_concerned() -> None:
    task, _ = pushing()
    assert concerned(replace(task, objects=())) == ("box", "line")
