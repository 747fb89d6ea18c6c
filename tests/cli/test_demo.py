from __future__ import annotations

import json
import threading
from pathlib import Path

import pytest

from assistant.cli import adapters, main
from assistant.files.tasks import read_task
from assistant.ports import Arm

MAKE_ARM = adapters.make_arm


def without_physics(
    name: str, stop_flag: threading.Event | None = None, *, window: bool = False
) -> Arm:
    return MAKE_ARM("kinematic", stop_flag, window=window)


def test_the_demo_teaches_practices_and_writes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(adapters, "make_arm", without_physics)
    out = tmp_path / "new" / "folder"
    assert main(["demo", "--out", str(out), "--json"]) == 0
    told, aside = capsys.readouterr()
    answer = json.loads(told.splitlines()[-1])
    assert [one["name"] for one in answer["setups"]] == [f"table1_{k}" for k in (1, 2, 3, 4)]
    assert all(one["status"] == "done" and one["distance_mm"] <= 0.1 for one in answer["setups"])
    assert len(answer["segmentation_points_s"]) == 4
    assert "What is the task called?" in aside
    assert "paper: mm" in aside
    names = {"pick_and_place.yaml", "votes.png", "paths.png", "weights.png"}
    assert {path.name for path in out.iterdir()} == names
    assert read_task(out / "pick_and_place.yaml").learned is not None


def test_a_folder_that_cannot_be_made_is_bad_input(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    assert main(["demo", "--out", str(tmp_path / "file" / "inside")]) == 2
    assert "a folder you may write in" in capsys.readouterr().err
