"""transcript/1: scripted sessions and journals, read, written, and appended step by step.

A journal grows by `append_step`, which returns only when the step is on the disk. A step that
takes several lines ends with an empty one, so that one torn by a crash is told from a whole one.
"""

from __future__ import annotations

import os
import re
from io import FileIO
from pathlib import Path
from typing import Any

from assistant.errors import BadInput
from assistant.files.forms import check_format, the_document, validated
from assistant.files.step_problems import step_problems
from assistant.files.transcript_forms import TranscriptFile
from assistant.files.transcript_steps import choice_of, choice_value, step_of, step_values
from assistant.files.writing import cannot_write, write_text
from assistant.model.transcript import Step, Transcript
from assistant.plain_yaml import Document, read_text, text_of, write, write_item

FORMAT = "transcript/1"
SPREAD = ("steps",)
_LANGUAGES = {"en": "english", "de": "german"}
_STEP_BEGINS = re.compile(r"^  - ", re.MULTILINE)


def read_transcript(path: Path, *, resume: bool = False) -> Transcript:
    """Return the transcript of a file.

    Parameters
    ----------
    path : Path
    resume : bool
        Leave out a last step that was torn by a crash; else it is an error.

    Raises
    ------
    BadInput
        With every problem, each as ``file:line``.
    """
    text = _untorn(path) if resume else text_of(path)
    return transcript_of(the_document(list(read_text(text, str(path), flawed=True)), str(path)))


def mend_transcript(path: Path) -> str:
    """Cut a torn last step off a journal, so that it can be appended to; return what was cut."""
    text = _whatever(path)
    whole = text[: _whole(text)]
    if whole != text:
        write_text(path, whole)
    return text[len(whole) :]


def _untorn(path: Path) -> str:
    text = _whatever(path)
    return text[: _whole(text)]


def _whatever(path: Path) -> str:
    """Return the text of a journal, even one whose end is half a letter or zeros."""
    try:
        return path.read_bytes().decode("utf-8", errors="replace")
    except OSError:
        return text_of(path)  # says what is wrong with it


def _whole(text: str) -> int:
    """Return how much of a journal's text consists of whole steps, as `append_step` writes them."""
    text = text[: text.rstrip("\x00").rfind("\n") + 1]
    begins = [found.start() for found in _STEP_BEGINS.finditer(text)]
    if not begins:
        return len(text)
    last = text[begins[-1] :]
    one_line = last.count("\n") == 1 and not last.endswith(":\n")
    return len(text) if one_line or last.endswith("\n\n") else begins[-1]


def transcript_of(document: Document) -> Transcript:
    """Return the transcript a document tells, its steps with their lines."""
    check_format(document, FORMAT)
    form = validated(TranscriptFile, document, step_problems(document))
    steps = tuple(
        step_of(step, document.line(["steps", number])) for number, step in enumerate(form.steps)
    )
    return Transcript(
        title=form.title,
        steps=steps,
        setup=None if form.setup is None else choice_of(form.setup),
        arm=form.arm,
        task=form.task,
        language=_LANGUAGES.get(form.language, form.language),
        source=document.file,
    )


def write_transcript(transcript: Transcript, path: Path) -> None:
    """Write a transcript, so that reading gives the same values."""
    write_text(path, transcript_text(transcript))


def transcript_text(transcript: Transcript) -> str:
    """Return the text of a transcript/1 file."""
    return write(transcript_values(transcript), spread=SPREAD)


def transcript_values(transcript: Transcript) -> dict[str, Any]:
    """Return a transcript as plain values."""
    values: dict[str, Any] = {"format": FORMAT, "title": transcript.title}
    if transcript.setup is not None:
        values["setup"] = choice_value(transcript.setup)
    values["arm"] = transcript.arm
    if transcript.task is not None:
        values["task"] = transcript.task
    if transcript.language != "english":
        values["language"] = transcript.language
    values["steps"] = [step_values(step) for step in transcript.steps]
    return values


def begin_journal(transcript: Transcript, path: Path) -> None:
    """Write the head of a new journal and the steps it has; the file must not exist yet."""
    try:
        with path.open("xb", buffering=0) as file:
            head = write({**transcript_values(transcript), "steps": []}).removesuffix(" []\n")
            try:
                _flush(file, f"{head}\n{''.join(map(_item, transcript.steps))}")
            except OSError:
                # A journal without a head cannot be resumed: it would only hide those that can.
                path.unlink()
                raise
    except FileExistsError as error:
        raise BadInput.one(str(path), "a journal of this name exists", "another name") from error
    except OSError as error:
        raise cannot_write(path, error) from error


def append_step(path: Path, step: Step) -> None:
    """Append a step to a journal; when this returns the step is on the disk.

    Raises
    ------
    BadInput
        If it cannot be written; what was there before stays whole.
    """
    try:
        with path.open("ab", buffering=0) as file:
            before = file.tell()
            try:
                _flush(file, _item(step))
            except OSError:
                # A full disk may take half a step: the next reader must not find it.
                os.ftruncate(file.fileno(), before)
                raise
    except OSError as error:
        raise cannot_write(path, error) from error


def _flush(file: FileIO, text: str) -> None:
    left = memoryview(text.encode("utf-8", errors="replace"))
    while left:
        left = left[file.write(left) :]
    os.fsync(file.fileno())


def _item(step: Step) -> str:
    text = write_item(step_values(step))
    lines = "".join(f"  {line}\n" for line in text.splitlines())
    return lines if lines.count("\n") == 1 else f"{lines}\n"
