"""Reads any file of ours by its ending and its ``format``, with warnings where it is odd."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from assistant.errors import BadInput, Problem
from assistant.files import demonstrations, scenes, setups, tasks, transcripts
from assistant.files.arrays import read_npz, recording_of_json
from assistant.files.forms import check_format, the_document
from assistant.files.oddities import (
    odd_demonstration,
    odd_recording,
    odd_scene,
    odd_setup,
    odd_task,
)
from assistant.files.recordings import read_recording
from assistant.files.references import unknown_in_setups, unknown_in_transcript
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from assistant.model.transcript import Transcript
from assistant.plain_yaml import Document, read_file

Kind = Literal["task", "setup", "scene", "demonstration", "transcript", "recording"]
Value = Task | tuple[Setup, ...] | Scene | Demonstration | Transcript | Recording
FORMATS = (
    tasks.FORMAT,
    setups.FORMAT,
    scenes.FORMAT,
    demonstrations.FORMAT,
    transcripts.FORMAT,
)


@dataclass(frozen=True, slots=True)
class Known:
    """A file that was read.

    Parameters
    ----------
    kind : str
        ``task``, ``setup``, ``scene``, ``demonstration``, ``transcript`` or ``recording``.
    value : the value read
        Setups as a tuple.
    warnings : tuple of Problem
        What can be used but looks odd.
    recording : str
        Of a demonstration: its CSV file, relative to it.
    """

    kind: Kind
    value: Value
    warnings: tuple[Problem, ...] = ()
    recording: str = ""


def read_known(path: Path) -> Known:
    """Return the value of any file of ours, its kind, and what looks odd about it.

    Raises
    ------
    BadInput
        With every problem, each as ``file:line``.
    """
    match path.suffix.lower():
        case ".csv":
            return _recording(read_recording(path), path)
        case ".npz":
            return _recording(read_npz(path), path)
    documents = _documents(path)
    if documents and _is_recording(documents[0]):
        return _recording(recording_of_json(documents[0]), path)
    if not documents:
        the_document(documents, str(path))  # says that the file is empty
    told = check_format(documents[0], *FORMATS)
    if told == setups.FORMAT:
        several = setups.setups_of(documents)
        odd = (*odd_setup(several, str(path)), *unknown_in_setups(several, path))
        return Known("setup", several, odd)
    return _single(told, the_document(documents, str(path)), path)


def _recording(recording: Recording, path: Path) -> Known:
    return Known("recording", recording, odd_recording(recording, str(path)))


def _single(told: str, document: Document, path: Path) -> Known:
    """Return the value of a format that has one document a file."""
    match told:
        case tasks.FORMAT:
            task = tasks.task_of(document)
            return Known("task", task, odd_task(task, str(path)))
        case scenes.FORMAT:
            scene = scenes.scene_of(document)
            return Known("scene", scene, odd_scene(scene, str(path)))
        case demonstrations.FORMAT:
            shown = demonstrations.demonstration_of(document, path.parent)
            named = document.value["recording"] if isinstance(document.value, dict) else ""
            odd = odd_demonstration(shown, str(path))
            return Known("demonstration", shown, odd, str(named))
        case transcripts.FORMAT:
            play = transcripts.transcript_of(document)
            return Known("transcript", play, unknown_in_transcript(play, path))
    raise BadInput.one(f"{path}:1", f"format {told!r} is not known", f"one of {', '.join(FORMATS)}")


def _documents(path: Path) -> list[Document]:
    """Return the documents of a file; a list, as JSON has it, holds several."""
    documents = [each for each in read_file(path, flawed=True) if each.value is not None]
    if len(documents) != 1 or not isinstance(documents[0].value, list):
        return documents
    value, lines = documents[0].value, documents[0].lines
    parts = lines[1] if isinstance(lines, tuple) else []
    listed = parts if isinstance(parts, list) else []
    flaws = documents[0].flaws
    return [
        Document(each, line, str(path), () if number else flaws)
        for number, (each, line) in enumerate(zip(value, listed, strict=True))
    ]


def _is_recording(document: Document) -> bool:
    value = document.value
    return isinstance(value, dict) and "format" not in value and "t_s" in value
