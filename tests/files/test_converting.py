"""Conversions: there and back is the same; what makes no sense is refused."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from assistant.errors import BadInput
from assistant.files.converting import ENDINGS, convert
from assistant.files.demonstrations import write_demonstration
from assistant.files.kinds import read_known
from assistant.files.recordings import write_recording
from assistant.files.scenes import write_scene
from assistant.files.setups import write_setups
from assistant.files.tasks import write_task
from assistant.files.transcripts import write_transcript
from assistant.model.demonstration import Recording
from assistant.model.setup import Setup
from assistant.model.transcript import Note, RobotLine, TeacherLine, Transcript
from tests.files import examples
from tests.files.same import same

NAMES = ("x_m", "y_m", "z_m", "qx", "qy", "qz", "qw")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with one file of each kind."""
    write_task(examples.task(examples.lesson()), tmp_path / "task.yaml")
    write_scene(examples.SCENE, tmp_path / "scene.yaml")
    write_setups([Setup("a"), Setup("b")], tmp_path / "setup.yaml")
    write_demonstration(examples.demonstration(), tmp_path / "demonstration.yaml")
    write_recording(examples.recording(), tmp_path / "recording.csv")
    steps = (Note("*so*"), TeacherLine("two", "too"), RobotLine(act="ask", asked="goal"))
    write_transcript(Transcript("a play", steps), tmp_path / "transcript.yaml")
    return tmp_path


def converted(source: Path, goal: Path) -> Path:
    convert(read_known(source), source, goal)
    return goal


@pytest.mark.parametrize("kind", ["task", "scene", "setup", "transcript"])
def test_yaml_to_json_and_back_is_the_same_text(folder: Path, kind: str) -> None:
    source = folder / f"{kind}.yaml"
    json_file = converted(source, folder / "x.json")
    assert json.loads(json_file.read_text())
    assert converted(json_file, folder / "x.yaml").read_text() == source.read_text()


@pytest.mark.parametrize("ending", ["json", "npz", "csv"])
@pytest.mark.parametrize("gripper", [True, False])
def test_recordings_come_back_from_every_dress(
    tmp_path: Path, ending: str, *, gripper: bool
) -> None:
    recording = examples.recording(gripper=gripper)
    write_recording(recording, tmp_path / "a.csv")
    dressed = converted(tmp_path / "a.csv", tmp_path / f"b.{ending}")
    assert same(read_known(dressed).value, recording)


def test_a_demonstration_still_finds_its_recording(folder: Path) -> None:
    (folder / "inner").mkdir()
    moved = converted(folder / "demonstration.yaml", folder / "inner" / "d.json")
    assert json.loads(moved.read_text())["recording"] == "../demonstration.csv"
    again = converted(moved, folder / "d.yaml")
    assert again.read_text() == (folder / "demonstration.yaml").read_text()


def test_a_behavior_tree_has_every_step_in_order(folder: Path) -> None:
    root = ElementTree.parse(converted(folder / "task.yaml", folder / "t.xml")).getroot()
    assert root.get("BTCPP_format") == "4"
    assert [each.get("ID") for each in root.iter("Action")] == [
        "move_approach",
        "turn_clockwise",
        "hand_close",
        "free_motion",
    ]
    assert len(list(root.iter("ForceSuccess"))) == 2
    assert len(list(root.iter("Condition"))) == 28


def test_signs_that_xml_forbids_are_left_out(folder: Path) -> None:
    task = replace(examples.task(), goal='a\x07 < "b" & c')
    write_task(task, folder / "task.yaml")
    root = ElementTree.parse(converted(folder / "task.yaml", folder / "t.xml")).getroot()
    assert root[0].get("_description") == 'a  < "b" & c'


def test_a_graph_names_every_node(folder: Path) -> None:
    text = converted(folder / "task.yaml", folder / "t.dot").read_text()
    assert text.count("->") == 5
    assert 'digraph "on" {' in text


def test_records_are_markdown(folder: Path) -> None:
    record = converted(folder / "task.yaml", folder / "t.md").read_text()
    for told in ("# on", "1. **no**", "## What was learned", "| 1.25 | 4.00 |", "## Corrections"):
        assert told in record
    play = converted(folder / "transcript.yaml", folder / "p.md").read_text()
    assert "**Teacher:** two \\[heard: too\\]" in play
    assert "**Robot:** ask, goal" in play
    assert "*\\*so\\**" in play


@pytest.mark.parametrize("kind", sorted(ENDINGS))
@pytest.mark.parametrize("name", ["x.pdf", "x"])
def test_other_endings_are_refused_with_those_that_work(folder: Path, kind: str, name: str) -> None:
    source = folder / ("recording.csv" if kind == "recording" else f"{kind}.yaml")
    with pytest.raises(BadInput, match=rf"a {kind} cannot become .*; a name that ends in .*json"):
        converted(source, folder / name)


@pytest.mark.parametrize(
    ("columns", "told"),
    [
        ({"t_s": [1, 2, 3]}, "missing: x_m"),
        ({"t_s": [1, "a", 3], "x_m": 1}, "t_s is not a list of numbers"),
        ({**{key: [0, 0, 0] for key in NAMES}, "t_s": [0, 1]}, "different lengths"),
    ],
)
def test_columns_that_do_not_fit_are_told(
    tmp_path: Path, columns: dict[str, object], told: str
) -> None:
    path = tmp_path / "r.json"
    path.write_text(json.dumps(columns))
    with pytest.raises(BadInput, match=told):
        read_known(path)


def test_npz_files_that_hold_something_else_are_told(tmp_path: Path) -> None:
    path = tmp_path / "r.npz"
    path.write_bytes(b"no zip")
    with pytest.raises(BadInput, match="no npz file"):
        read_known(path)
    np.savez(path, t_s=np.zeros((3, 3)))
    with pytest.raises(BadInput, match="not a column"):
        read_known(path)
    np.savez(path, t_s=np.array([{"code": 1}], dtype=object))
    with pytest.raises(BadInput, match="no npz file"):
        read_known(path)
    shown = examples.recording()
    bad = Recording(shown.t_s[::-1], shown.path)
    write_recording(shown, tmp_path / "r.csv")
    np.savez(
        path,
        t_s=bad.t_s,
        **dict(zip(NAMES, bad.path.T, strict=True)),
    )
    with pytest.raises(BadInput, match=r"sample 2: time runs backward"):
        read_known(path)


def test_a_file_that_was_moved_without_its_recording_is_told(folder: Path) -> None:
    (folder / "inner").mkdir()
    shutil.move(folder / "demonstration.yaml", folder / "inner")
    with pytest.raises(BadInput, match="there is no recording"):
        read_known(folder / "inner" / "demonstration.yaml")
