"""Any file is read by its format, and oddities are told without refusing it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from assistant.errors import BadInput
from assistant.files.converting import convert
from assistant.files.kinds import read_known
from assistant.files.shipped import shipped
from assistant.files.tasks import write_task
from assistant.model.setup import Setup
from assistant.model.task import Task
from tests.files.examples import lesson, task

EVERY = [
    *sorted(shipped("tasks").rglob("*.yaml")),
    *sorted(shipped("tasks").rglob("*.csv")),
    *sorted(shipped("transcripts").rglob("*.yaml")),
]


@pytest.mark.parametrize("path", EVERY, ids=lambda path: path.name)
def test_every_shipped_file_is_good_and_nothing_about_it_is_odd(path: Path) -> None:
    told = [warning.what for warning in read_known(path).warnings]
    # A push needs no fingers: its demonstration is told for what it is.
    pushed = path.parent.name == "demonstrations" and path.stem == "pushing"
    assert told == (["the hand never opens or closes"] if pushed else [])


@pytest.mark.parametrize("path", EVERY, ids=lambda path: path.name)
def test_every_shipped_file_written_again_is_the_same_text(path: Path, tmp_path: Path) -> None:
    again = tmp_path / path.name
    convert(read_known(path), path, again)
    # A demonstration that moves names its recording from where it is now.
    moved = f"{os.path.relpath(path.parent, tmp_path)}/"
    assert again.read_text("utf-8").replace(moved, "") == path.read_text("utf-8")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("a: 1\n", "there is no format; begin with format: task/1 or setup/1"),
        ("- 1\n- 2\n", "there is no format"),
        ("just text", "there is no format"),
        ("format: recipe/1\n", "format 'recipe/1' is not known here"),
        ("format: [task/1]\n", "is not known here"),
        ("", "the file is empty"),
        ("---\n---\n", "the file is empty"),
    ],
)
def test_what_is_none_of_our_files_is_told(tmp_path: Path, text: str, told: str) -> None:
    path = tmp_path / "x.yaml"
    path.write_text(text)
    with pytest.raises(BadInput) as caught:
        read_known(path)
    assert told in str(caught.value)


def test_places_told_in_metres_and_names_twice_are_odd(tmp_path: Path) -> None:
    one = "format: setup/1\nname: a\nplaces: {block: {xyz_mm: [0.5, 0.2, 0.3]}}\n"
    path = tmp_path / "x.yaml"
    path.write_text(f"{one}---\n{one}")
    known = read_known(path)
    assert isinstance(known.value, tuple)
    assert all(isinstance(each, Setup) for each in known.value)
    told = "\n".join(map(str, known.warnings))
    assert "a: block is less than 10 mm from the base; xyz_mm is in millimetres" in told
    assert "two setups are named 'a'" in told


def test_small_bodies_and_empty_subtasks_are_odd(tmp_path: Path) -> None:
    path = tmp_path / "x.yaml"
    path.write_text("format: scene/1\nname: s\nbodies: {b: {size_mm: [0.06, 0.04, 0.1]}}\n")
    assert "size_mm is in millimetres" in str(read_known(path).warnings[0])
    path.write_text("format: task/1\nname: t\ntree: {subtask: t}\n")
    known = read_known(path)
    assert isinstance(known.value, Task)
    assert "the subtask 't' has no parts" in str(known.warnings[0])


def test_what_a_file_names_and_is_not_there_is_told(tmp_path: Path) -> None:
    path = tmp_path / "x.yaml"
    path.write_text(
        "format: setup/1\nname: a\nplaces: {cup: {xyz_mm: [500, 0, 240]}}\n"
        "---\nformat: setup/1\nname: b\nscene: moon\n"
    )
    told = "\n".join(map(str, read_known(path).warnings))
    assert "a: 'cup' is no body of the scene table; bodies: block, target" in told
    assert "there is no scene 'moon'" in told
    path.write_text(
        "format: transcript/1\ntitle: t\nsetup: table1_1\ntask: none.yaml\nsteps:\n"
        "  - demonstrate: {recording: none.csv}\n  - setup: moon\n  - setup: none.yaml\n"
    )
    told = "\n".join(str(each).replace(str(tmp_path), "") for each in read_known(path).warnings)
    assert "/x.yaml:4: there is no file /none.yaml" in told
    assert "/x.yaml:6: there is no file /none.csv" in told
    assert "/x.yaml:7: there is no setup 'moon'; known: demonstration" in told
    assert "/x.yaml:8: there is no setup file /none.yaml" in told


def test_lessons_of_steps_that_are_not_in_the_tree_are_told(tmp_path: Path) -> None:
    write_task(task(lesson()), tmp_path / "x.yaml")
    assert read_known(tmp_path / "x.yaml").warnings == ()
    text = (tmp_path / "x.yaml").read_text()
    (tmp_path / "x.yaml").write_text(text.replace("primitive: part 2", "primitive: lift", 1))
    (told,) = read_known(tmp_path / "x.yaml").warnings
    assert "something was learned for 'part 2', which is not in the tree" in str(told)
