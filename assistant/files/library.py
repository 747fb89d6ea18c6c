"""Tasks kept between sessions: one file a task in ``tasks`` of the home folder.

Nothing is lost by saving: a file is replaced at once, and what it held before is kept as an
earlier version beside it, in ``tasks/earlier/NAME.1.yaml``, ``NAME.2.yaml`` and so on.
"""

from __future__ import annotations

import re
import shutil
from dataclasses import dataclass
from glob import escape
from pathlib import Path

from assistant.errors import BadInput
from assistant.files.home import home
from assistant.files.records import record
from assistant.files.tasks import read_task, task_text
from assistant.files.writing import cannot_write, write_text
from assistant.model.task import Task

MOST_EARLIER = 20
MOST_LETTERS, MOST_BYTES = 100, 200
"""Of a task's name in that of its file: the system takes 255 bytes, with all endings."""


@dataclass(frozen=True, slots=True)
class Library:
    """The kept tasks of a folder, made when something is first saved."""

    folder: Path

    def names(self) -> tuple[str, ...]:
        """Return the names of kept tasks, sorted."""
        found = (path for path in self.folder.glob("*.yaml") if path.is_file())
        return tuple(sorted(path.stem for path in found if not path.name.startswith(".")))

    def path(self, name: str) -> Path:
        """Return the file of a kept task; the name is made fit for a file.

        A file somebody put there keeps the name it has.
        """
        if name in self.names():
            return self.folder / f"{name}.yaml"
        fit = re.sub(r"[^\w-]+", "_", name.strip().lower()).strip("_")[:MOST_LETTERS]
        short = fit.encode("utf-8", errors="replace")[:MOST_BYTES].decode("utf-8", errors="ignore")
        return self.folder / f"{short or 'task'}.yaml"

    def name_of(self, path: Path) -> str:
        """Return the name of the kept task whose file this is, or nothing."""
        return path.stem if path.parent.resolve() == self.folder.resolve() else ""

    def __contains__(self, name: str) -> bool:
        return self.path(name).is_file()

    def load(self, name: str) -> Task:
        """Return a kept task, or raise `BadInput` with the names that are known."""
        return read_task(self._known(name))

    def holds(self, name: str, task: Task) -> bool:
        """Return whether just this task is kept under a name: saving it changes nothing."""
        try:
            return self.path(name).read_text(encoding="utf-8") == task_text(task)
        except (OSError, UnicodeError):
            return False

    def save(self, name: str, task: Task, *, overwrite: bool = False) -> Path:
        """Keep a task under a name and return its file.

        Raises
        ------
        BadInput
            If another task has that name and `overwrite` is not given, or if the folder
            cannot be written; what was kept before stays.
        """
        path = self.path(name)
        if name in self and not self.holds(name, task):
            if not overwrite:
                right = "choose another name, or overwrite it"
                raise BadInput.one(str(path), f"another task is kept as {path.stem!r}", right)
            self._set_aside(path)
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise cannot_write(self.folder, error) from error
        write_text(path, task_text(task))
        return path

    def write_record(self, name: str, task: Task, language: str = "english") -> Path:
        """Write a task down for people, in Markdown beside the kept tasks, and return the file."""
        path = self.path(name).with_suffix(".md")
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise cannot_write(self.folder, error) from error
        write_text(path, record(task, language))
        return path

    def earlier(self, name: str) -> tuple[Path, ...]:
        """Return the earlier versions of a kept task, oldest first."""
        stem = self.path(name).stem
        found = (self.folder / "earlier").glob(f"{escape(stem)}.*.yaml")
        return tuple(sorted((path for path in found if _number(path) > 0), key=_number))

    def delete(self, name: str) -> None:
        """Remove a kept task and its earlier versions."""
        path = self._known(name)
        try:
            for each in (path, *self.earlier(name)):
                each.unlink()
        except OSError as error:
            right = "the folder must be one you may write in"
            raise BadInput.one(str(path), f"cannot be removed ({error.strerror})", right) from error

    def _known(self, name: str) -> Path:
        path = self.path(name)
        if not path.is_file():
            known = ", ".join(self.names()) or "none yet"
            raise BadInput.one(str(self.folder), f"no task {name!r} is kept", f"known: {known}")
        return path

    def _set_aside(self, path: Path) -> None:
        folder = self.folder / "earlier"
        before = self.earlier(path.stem)
        number = _number(before[-1]) + 1 if before else 1
        try:
            folder.mkdir(exist_ok=True)
            shutil.copy2(path, folder / f"{path.stem}.{number}.yaml")
            for old in before[: max(0, len(before) + 1 - MOST_EARLIER)]:
                old.unlink()
        except OSError as error:
            raise cannot_write(folder, error) from error


def _number(path: Path) -> int:
    number = path.stem.rpartition(".")[2]
    return int(number) if number.isdigit() else 0


def library() -> Library:
    """Return the library of the home folder."""
    return Library(home() / "tasks")
