"""Events as journal steps and back, so that a resumed session is fed what it once found out.

Small values stand in the step itself; scenes, setups, tasks and demonstrations are written
into files beside the journal, once each however often they are told.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, assert_never

from assistant.dialogue import events
from assistant.errors import BadInput
from assistant.files.demonstrations import read_demonstration, write_demonstration
from assistant.files.scenes import read_scene, write_scene
from assistant.files.setups import read_setups, write_setups
from assistant.files.tasks import read_task, write_task
from assistant.model.lesson import Lesson
from assistant.model.motion import Alignment, ArmReport, Measure, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Subtask, Task
from assistant.model.transcript import Happened, TeacherLine


class Store:
    """Files beside a journal, each written once; a value written again keeps its name.

    Parameters
    ----------
    folder : Path
        The journal's own folder.

    Attributes
    ----------
    taught : Task or None
        The task being learned: a lesson is written as part of it.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.taught: Task | None = None
        self._names: dict[str, str] = {}

    def learn_names(self) -> None:
        """Take note of what an earlier run of the session has written."""
        for path in sorted(self.folder.glob("*_*.yaml")):
            self._names[path.read_text(encoding="utf-8")] = path.name

    def put(self, kind: str, write: Callable[[Path], None]) -> str:
        """Write a value to a fresh file and return its name, or that of an equal older file."""
        numbers = (path.stem.rsplit("_", 1)[1] for path in self.folder.glob(f"{kind}_*.yaml"))
        path = self.folder / f"{kind}_{max(map(int, numbers), default=0) + 1}.yaml"
        write(path)
        text = path.read_text(encoding="utf-8")
        known = self._names.setdefault(text, path.name)
        if known != path.name:
            path.unlink()
        return known

    def scene(self, scene: Scene) -> str:
        """Keep a scene."""
        return self.put("scene", lambda path: write_scene(scene, path))

    def setup(self, setup: Setup) -> str:
        """Keep a setup."""
        return self.put("setup", lambda path: write_setups([setup], path))

    def task(self, task: Task) -> str:
        """Keep a task with all it has learned."""
        return self.put("task", lambda path: write_task(task, path))


def to_step(
    event: events.Event, store: Store, at_s: float | None = None
) -> TeacherLine | Happened | None:
    """Return the journal's step for an event; None for what need not be remembered.

    Parameters
    ----------
    event : Event
    store : Store
    at_s : float, optional
        The recording's clock, for words said while a demonstration is watched.
    """
    if isinstance(event, events.Heard):
        return TeacherLine(event.text, at_s=at_s, by_voice=event.sure if event.by_voice else None)
    result = _result(event, store)
    return None if result is None else Happened(result)


def _result(event: events.Event, store: Store) -> dict[str, Any] | None:
    match event:
        case events.Begun():
            told: dict[str, Any] = _arranged(event.scene, event.setup, store)
            if event.task is not None:
                told["task"] = store.task(event.task)
            if event.saved_as:
                told["saved_as"] = event.saved_as
            return {"begun": told | {"saved": list(event.saved)}}
        case events.Shown():
            return {"shown": _shown(event, store)}
        case events.Learned():
            return {"learned": _learned(event, store)}
        case events.Checked():
            return {"checked": _checked(event, store)}
        case events.ArmReported():
            return {"arm": _without_blanks(asdict(event.report))}
        case events.Halted():
            return {"halted": event.why}
        case events.Arranged():
            return {"arranged": _arranged(event.scene, event.setup, store)}
        case events.Kept():
            told = {"name": event.name, "why_not": event.why_not}
            return {
                "kept": _without_blanks({**told, "discarded": event.discarded or None})
                | ({} if event.record is None else {"record": event.record})
            }
        case events.Loaded():
            loaded: dict[str, Any] = {"name": event.name, "why_not": event.why_not}
            if event.task is not None:
                loaded["task"] = store.task(event.task)
            return {"loaded": _without_blanks(loaded)}
        case events.Ticked() | events.Heard():
            return None
        case _:
            assert_never(event)


def from_happened(result: Mapping[str, Any], folder: Path) -> events.Event:
    """Return the event a ``happened`` step tells of.

    Raises
    ------
    BadInput
        If the step is of no known kind.
    """
    (kind, told), *more = result.items()
    read = _READERS.get(kind)
    if read is None or more:
        raise BadInput.one("happened", f"unknown result {kind!r}", f"one of {', '.join(_READERS)}")
    return read(told, folder)


def _arranged(scene: Scene, setup: Setup, store: Store) -> dict[str, Any]:
    return {"scene": store.scene(scene), "setup": store.setup(setup)}


def _shown(event: events.Shown, store: Store) -> dict[str, Any]:
    shown = event.demonstration
    if shown is None:
        return {"why_not": event.why_not}
    return {"demonstration": store.put("demonstration", lambda at: write_demonstration(shown, at))}


def _learned(event: events.Learned, store: Store) -> dict[str, Any]:
    if event.lesson is None:
        return {"why_not": event.why_not, "facts": _plain(event.facts)}
    # A task file is the one format that holds a lesson, so the lesson is kept with its task.
    task = store.taught or Task("lesson", Subtask("lesson"))
    return {"lesson": store.task(replace(task, learned=event.lesson))}


def _checked(event: events.Checked, store: Store) -> dict[str, Any]:
    told: dict[str, Any] = {"setup": store.setup(event.setup), "duration_s": event.duration_s}
    if event.refusal is not None:
        told["refusal"] = _without_blanks(asdict(event.refusal))
    return told | ({"note": event.note} if event.note else {})


def _without_blanks(told: Mapping[str, Any]) -> dict[str, Any]:
    return {key: _plain(value) for key, value in told.items() if value not in ("", None, ())}


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {str(key): _plain(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(one) for one in value]
    return value if isinstance(value, str | int | float | bool | None) else str(value)


def _read_begun(told: Any, folder: Path) -> events.Event:
    task = read_task(folder / told["task"]) if "task" in told else None
    scene, saved = read_scene(folder / told["scene"]), tuple(told["saved"])
    return events.Begun(scene, _setup(told, folder), task, saved, told.get("saved_as", ""))


def _setup(told: Any, folder: Path) -> Setup:
    return read_setups(folder / told["setup"])[0]


def _read_shown(told: Any, folder: Path) -> events.Event:
    if "demonstration" not in told:
        return events.Shown(None, told["why_not"])
    return events.Shown(read_demonstration(folder / told["demonstration"]))


def _read_learned(told: Any, folder: Path) -> events.Event:
    lesson: Lesson | None = None
    if "lesson" in told:
        lesson = read_task(folder / told["lesson"]).learned
    return events.Learned(lesson, told.get("why_not", ""), told.get("facts", {}))


def _read_checked(told: Any, folder: Path) -> events.Event:
    refusal = Refusal(**told["refusal"]) if "refusal" in told else None
    return events.Checked(
        _setup(told, folder), refusal, float(told["duration_s"]), told.get("note", "")
    )


def _read_arm(told: Any, folder: Path) -> events.Event:
    alignments = tuple(Alignment(**one) for one in told.get("alignments", ()))
    measures = tuple(Measure(**one) for one in told.get("measures", ()))
    return events.ArmReported(ArmReport(**{**told, "alignments": alignments, "measures": measures}))


def _read_loaded(told: Any, folder: Path) -> events.Event:
    task = read_task(folder / told["task"]) if "task" in told else None
    return events.Loaded(told["name"], task, told.get("why_not", ""))


_READERS: Mapping[str, Callable[[Any, Path], events.Event]] = {
    "begun": _read_begun,
    "shown": _read_shown,
    "learned": _read_learned,
    "checked": _read_checked,
    "arm": _read_arm,
    "halted": lambda told, folder: events.Halted(told),
    "arranged": lambda told, folder: events.Arranged(
        _setup(told, folder), read_scene(folder / told["scene"])
    ),
    "kept": lambda told, folder: events.Kept(
        told["name"], told.get("why_not", ""), bool(told.get("discarded")), told.get("record")
    ),
    "loaded": _read_loaded,
}
