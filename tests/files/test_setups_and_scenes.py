"""Setups and scenes: written by people, read with units and lines, found by name."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.errors import BadInput
from assistant.files.finding import find_setups
from assistant.files.scenes import find_scene, read_scene, scene_text, write_scene
from assistant.files.setups import read_setups, setup_text, write_setups
from assistant.files.shipped import shipped
from assistant.model.scene import Scene
from assistant.model.setup import READY, Place, Setup
from tests.files.examples import SCENE, scenes, setups
from tests.files.same import same

SETUP = """\
format: setup/1
name: mine
places:
  block: {hand_xyz_mm: [533, 270, 300]}
  target: {xyz_mm: [520, -248.6, 240], rpy_deg: [0, 0, 40]}
"""


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "file.yaml"
    path.write_text(text)
    return path


@pytest.mark.parametrize(
    "path", sorted((shipped("tasks") / "setups").glob("*.yaml")), ids=lambda p: p.name
)
def test_shipped_setups_written_again_are_the_same_text(path: Path) -> None:
    assert "---\n".join(map(setup_text, read_setups(path))) == path.read_text()


@pytest.mark.parametrize(
    "path", sorted((shipped("tasks") / "scenes").glob("*.yaml")), ids=lambda p: p.name
)
def test_shipped_scenes_written_again_are_the_same_text(path: Path) -> None:
    assert scene_text(read_scene(path)) == path.read_text()


@settings(max_examples=40, deadline=None)
@given(st.lists(setups, min_size=1, max_size=3))
def test_setups_come_back(tmp_path_factory: pytest.TempPathFactory, several: list[Setup]) -> None:
    path = tmp_path_factory.mktemp("s") / "s.yaml"
    write_setups(several, path)
    assert same(read_setups(path), tuple(several))


@settings(max_examples=30, deadline=None)
@given(scenes)
def test_scenes_come_back(tmp_path_factory: pytest.TempPathFactory, scene: Scene) -> None:
    path = tmp_path_factory.mktemp("s") / "s.yaml"
    write_scene(scene, path)
    assert read_scene(path) == scene
    assert scene_text(read_scene(path)) == path.read_text("utf-8")


def test_a_scene_comes_back(tmp_path: Path) -> None:
    write_scene(SCENE, tmp_path / "s.yaml")
    assert same(read_scene(tmp_path / "s.yaml"), SCENE)


def test_what_is_nowhere_is_told_without_a_folder_that_names_nothing(tmp_path: Path) -> None:
    for find, what in ((find_setups, "setup"), (find_scene, "scene")):
        with pytest.raises(BadInput, match=f"^{what}: there is no {what} 'moon'; known: "):
            find("moon", tmp_path)
        with pytest.raises(BadInput, match=f"^{tmp_path}/x.yaml: there is no {what} 'moon'"):
            find("moon", tmp_path / "x.yaml")


def test_what_is_not_told_is_as_usual(tmp_path: Path) -> None:
    (setup,) = read_setups(written(tmp_path, SETUP))
    assert setup.robot_start == READY
    assert setup.scene == "table"
    assert setup.places["block"] == Place("hand", (533.0, 270.0, 300.0))
    assert setup.places["target"] == Place("body", (520.0, -248.6, 240.0), (0.0, 0.0, 40.0))


@pytest.mark.parametrize(
    ("old", "new", "line", "told"),
    [
        ("hand_xyz_mm: [533", "hand_xyz_m: [533", 4, "did you mean 'hand_xyz_mm'?"),
        ("[533, 270, 300]", "[533, 270]", 4, "2 values; 3 are needed"),
        ("[533, 270, 300]", "[533, 270, 300, 1]", 4, "4 values; 3 are needed"),
        ("[533, 270, 300]", "[533, 270, .nan]", 4, "nan is not a number"),
        ("[533, 270, 300]", "[533, 270, high]", 4, "'high' is not a number"),
        ("rpy_deg: [0, 0, 40]", "hand_rpy_deg: [0, 0, 40]", 5, "xyz_mm goes with rpy_deg"),
        ("rpy_deg: [0, 0, 40]", "hand_xyz_mm: [0, 0, 40]", 5, "and not both"),
        ("{hand_xyz_mm: [533, 270, 300]}", "{}", 4, "and not both"),
    ],
)
def test_mistakes_in_setups_are_told_with_their_line(
    tmp_path: Path, old: str, new: str, line: int, told: str
) -> None:
    path = written(tmp_path, SETUP.replace(old, new, 1))
    with pytest.raises(BadInput) as caught:
        read_setups(path)
    assert told in str(caught.value)
    assert caught.value.problems[0].where == f"{path}:{line}"


def test_problems_of_all_documents_are_told(tmp_path: Path) -> None:
    bad = SETUP.replace("name", "nam")
    with pytest.raises(BadInput) as caught:
        read_setups(written(tmp_path, f"{bad}---\n{SETUP}---\n{bad}"))
    assert [
        each.where.rpartition(":")[2] for each in caught.value.problems if "unknown" in each.what
    ] == ["2", "14"]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("bodies: {b: {size_mm: [1, 2, -3]}}", "size_mm: -3 is out of range; at least 0"),
        ("bodies: {b: {shape: cone, size_mm: [1, 2, 3]}}", "one of box, cylinder, sphere, cup"),
        ("bodies: {b: {}}", "key 'size_mm' is missing"),
        ("bodies: {b: {size_mm: [1, 2, 3], normal: [0, 0, 0]}}", "no direction"),
        ("hand_speed_m_s: 0", "more than 0"),
        ("hand_speed_m_s: 250", "at most 5"),
        ("tables: [{name: t}]", "key 'xyz_mm' is missing"),
    ],
)
def test_mistakes_in_scenes_are_told(tmp_path: Path, text: str, told: str) -> None:
    with pytest.raises(BadInput) as caught:
        read_scene(written(tmp_path, f"format: scene/1\nname: s\n{text}\n"))
    assert told in str(caught.value)


def test_scenes_are_found_beside_the_file_before_those_shipped(tmp_path: Path) -> None:
    near = tmp_path / "setups" / "mine.yaml"
    near.parent.mkdir()
    near.write_text(SETUP)
    assert find_scene("table", near).name == "table"
    (tmp_path / "scenes").mkdir()
    write_scene(SCENE, tmp_path / "scenes" / "table.yaml")
    assert find_scene("table", near).name == "stage"
    assert find_scene("../scenes/table.yaml", near).name == "stage"
    with pytest.raises(BadInput, match=r"no scene 'moon'; known: .*table"):
        find_scene("moon", near)


def test_setups_are_found_by_file_and_by_name(tmp_path: Path) -> None:
    written(tmp_path, SETUP)
    assert find_setups("file.yaml", tmp_path)[0][0].name == "mine"
    assert find_setups("table1", tmp_path)[0][0].name == "table1_1"
    (one,), path = find_setups("table1_3", tmp_path)
    assert (one.name, path.name) == ("table1_3", "table1.yaml")
    with pytest.raises(BadInput, match=r"no setup 'moon'; known: .*table1_2"):
        find_setups("moon", tmp_path)
    with pytest.raises(BadInput, match="no setup file"):
        find_setups("moon.yaml", tmp_path)
