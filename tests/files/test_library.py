"""Kept tasks: nothing that was taught is lost by saving, not even on a bad disk."""

from __future__ import annotations

import errno
import os
from dataclasses import replace
from pathlib import Path

import pytest

from assistant.errors import BadInput
from assistant.files.home import home, home_to_look_into
from assistant.files.library import MOST_EARLIER, Library, library
from assistant.files.tasks import task_text
from assistant.files.writing import write_text
from tests.files.examples import lesson, task
from tests.files.same import same


@pytest.fixture
def kept(tmp_path: Path) -> Library:
    return Library(tmp_path / "tasks")


def test_a_kept_task_comes_back_under_its_name(kept: Library) -> None:
    assert kept.names() == ()
    kept.save("Pick & Place!", task(lesson()))
    assert kept.names() == ("pick_place",)
    assert "pick & place" in kept
    assert same(kept.load("pick_place"), task(lesson()))


def test_a_long_name_in_any_script_is_kept(kept: Library) -> None:
    name = "積み木を赤い台の上に置く" * 20
    assert name not in kept
    kept.save(name, task())
    kept.save(name, replace(task(), goal="x"), overwrite=True)
    assert name in kept
    assert len(kept.earlier(name)) == 1
    write_text(kept.folder / ("積" * 80), "a name as long as the system takes")


@pytest.mark.parametrize("name", ["My Task", "a.b", "_b", "[c]"])
def test_a_file_somebody_put_there_is_kept_under_the_name_it_has(kept: Library, name: str) -> None:
    kept.folder.mkdir()
    write_text(kept.folder / f"{name}.yaml", task_text(task()))
    assert kept.names() == (name,)
    kept.save(name, replace(task(), goal="x"), overwrite=True)
    assert kept.names() == (name,)
    assert kept.load(name).goal == "x"
    assert len(kept.earlier(name)) == 1
    kept.delete(name)
    assert not [path for path in kept.folder.rglob("*") if path.is_file()]


def test_what_is_no_file_or_hidden_is_no_kept_task(kept: Library) -> None:
    (kept.folder / "folder.yaml").mkdir(parents=True)
    (kept.folder / "broken.yaml").symlink_to("nowhere")
    write_text(kept.folder / ".half.yaml", task_text(task()))
    assert kept.names() == ()


def test_the_file_of_a_kept_task_tells_its_name_and_no_other_file_does(
    kept: Library, tmp_path: Path
) -> None:
    assert kept.name_of(kept.path("stacking")) == "stacking"
    assert kept.name_of(tmp_path / "elsewhere" / "stacking.yaml") == ""


def test_saving_over_another_task_needs_to_be_said_and_keeps_the_old_one(kept: Library) -> None:
    first, second = task(), replace(task(), goal="another")
    kept.save("it", first)
    kept.save("it", first)
    with pytest.raises(BadInput, match="another task is kept as 'it'; choose another name"):
        kept.save("it", second)
    kept.save("it", second, overwrite=True)
    assert kept.load("it").goal == "another"
    (old,) = kept.earlier("it")
    assert old.name == "it.1.yaml"
    assert kept.names() == ("it",)


def test_only_the_latest_versions_are_kept(kept: Library) -> None:
    for number in range(MOST_EARLIER + 5):
        kept.save("it", replace(task(), goal=str(number)), overwrite=True)
    earlier = kept.earlier("it")
    assert len(earlier) == MOST_EARLIER
    assert earlier[-1].name == f"it.{MOST_EARLIER + 4}.yaml"


def test_a_deleted_task_is_gone_and_others_stay(kept: Library) -> None:
    kept.save("one", task())
    kept.save("one", replace(task(), goal="x"), overwrite=True)
    kept.save("two", task())
    kept.delete("one")
    assert kept.names() == ("two",)
    assert kept.earlier("one") == ()
    with pytest.raises(BadInput, match="no task 'one' is kept; known: two"):
        kept.delete("one")
    with pytest.raises(BadInput, match="no task 'one' is kept; known: two"):
        kept.load("one")


def test_a_full_disk_costs_nothing_that_was_kept(
    kept: Library, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept.save("it", task())
    before = kept.path("it").read_bytes()

    def full(handle: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(BadInput, match=r"cannot be written \(No space left on device\)"):
        kept.save("it", replace(task(), goal="new"), overwrite=True)
    assert kept.path("it").read_bytes() == before
    assert [path.name for path in kept.folder.iterdir() if path.is_file()] == ["it.yaml"]


def test_a_folder_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(BadInput, match="cannot be written"):
        Library(tmp_path / "file" / "tasks").save("it", task())


def test_files_keep_their_rights_and_links_their_goal(tmp_path: Path) -> None:
    path = tmp_path / "it.yaml"
    write_text(path, "old")
    path.chmod(0o640)
    link = tmp_path / "link.yaml"
    link.symlink_to(path)
    write_text(link, "new")
    assert path.read_text() == "new"
    assert path.stat().st_mode & 0o777 == 0o640
    assert link.is_symlink()


def test_writing_where_no_folder_is_says_so(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="its folder does not exist; make"):
        write_text(tmp_path / "none" / "x", "")
    with pytest.raises(BadInput, match="cannot be written"):
        write_text(tmp_path, "")


def test_the_home_folder_is_where_it_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ASSISTANT_HOME", str(tmp_path))
    assert home() == tmp_path
    assert library().folder == tmp_path / "tasks"
    monkeypatch.delenv("ASSISTANT_HOME")
    assert home().name == "teaching-assistant"


def test_a_home_folder_nobody_has_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ASSISTANT_HOME", "~nobody at all/x")
    with pytest.raises(BadInput, match="there is no such home folder: ~nobody at all/x"):
        home()
    monkeypatch.delenv("ASSISTANT_HOME")
    monkeypatch.setattr("assistant.files.home.user_data_path", lambda *_: Path("~/.local/share"))
    with pytest.raises(BadInput, match="is not set, and you have no home folder; set it"):
        home()


def test_a_home_that_is_a_file_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "file"
    path.write_text("")
    monkeypatch.setenv("ASSISTANT_HOME", str(path))
    with pytest.raises(BadInput, match=f"ASSISTANT_HOME: {path} is no folder; name a folder"):
        home_to_look_into()
    monkeypatch.setenv("ASSISTANT_HOME", str(tmp_path / "not there yet"))
    assert home_to_look_into() == home()


def test_a_task_is_written_down_beside_the_kept_ones(kept: Library) -> None:
    path = kept.write_record("Pick & Place!", task(lesson()))
    assert path.name == "pick_place.md"
    assert path.read_text(encoding="utf-8").startswith("# ")
    assert kept.names() == ()
    kept.folder.joinpath("x").write_text("a file")
    with pytest.raises(BadInput):
        Library(kept.folder / "x").write_record("any", task())
