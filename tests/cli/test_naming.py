"""Tasks told at the command line by file or by name."""

from __future__ import annotations

from pathlib import Path

import pytest

from assistant.cli.naming import task_path
from assistant.errors import BadInput
from assistant.files.library import Library
from tests.dialogue.teaching import tree_task


@pytest.fixture(autouse=True)
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Keep one task in a home of its own and return its file."""
    monkeypatch.setenv("ASSISTANT_HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    return Library(tmp_path / "tasks").save("Version One", tree_task())


@pytest.mark.parametrize("name", ["version_one", "Version One", "version one"])
def test_a_kept_task_is_called_by_its_name(name: str, kept: Path) -> None:
    assert task_path(name) == kept


def test_a_file_is_a_file_even_where_a_task_has_its_name(tmp_path: Path) -> None:
    (tmp_path / "version_one").touch()
    for told in ("version_one", "other.yaml", "folder/other", "./version_one"):
        assert task_path(told) == Path(told)


def test_an_unknown_name_is_told_with_the_likeliest_ones() -> None:
    with pytest.raises(BadInput, match="did you mean: version_one"):
        task_path("versoin one")
    with pytest.raises(BadInput, match="a file, or one of: version_one"):
        task_path("stacking")


def test_without_kept_tasks_a_file_is_asked_for(kept: Path) -> None:
    kept.unlink()
    with pytest.raises(BadInput, match="no tasks are kept yet"):
        task_path("version one")
