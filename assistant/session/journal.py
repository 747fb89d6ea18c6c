"""The journal: a live session written down as a transcript, on disk before it is acted on.

A program killed at any instant leaves a whole journal but for at most a torn last step. One
session writes one journal, held by a lock. A disk that is full or read-only ends the writing,
not the session: what could not be written stays in memory and is said once.
"""

from __future__ import annotations

import fcntl
from pathlib import Path
from typing import IO

from assistant.errors import BadInput, Problem, WorkFailed
from assistant.files.transcripts import (
    append_step,
    begin_journal,
    mend_transcript,
    read_transcript,
)
from assistant.model.transcript import Step, Transcript

NAME = "journal.yaml"
LOCK = "lock"
ROOM = "name a folder you may write in, with room left"


class Journal:
    """Where a session is written down.

    Parameters
    ----------
    folder : Path
        ``ASSISTANT_HOME/sessions/<id>``.

    Attributes
    ----------
    trouble : str
        Why nothing can be written any more; empty as long as it can.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.path = folder / NAME
        self.trouble = ""
        self._lock: IO[bytes] | None = None

    @property
    def name(self) -> str:
        """The session's id."""
        return self.folder.name

    def create(self, header: Transcript) -> None:
        """Begin a new journal; its folder is there and empty."""
        try:
            self._take()
            begin_journal(header, self.path)
        except (OSError, BadInput) as error:
            self.fail(error)

    def resume(self) -> Transcript:
        """Return what the journal holds, a torn last step cut off, and go on writing it.

        Raises
        ------
        BadInput
            If there is no such journal, or it cannot be read.
        WorkFailed
            If another program has it open.
        """
        if not self.path.is_file():
            raise BadInput.one(self.name, "no such session", "see `assistant sessions`")
        self._take()
        mend_transcript(self.path)
        return read_transcript(self.path)

    def write(self, step: Step) -> None:
        """Append a step; it is on the disk when this returns."""
        if self.trouble:
            return
        try:
            append_step(self.path, step)
        except BadInput as error:
            self.fail(error)

    def fail(self, error: Exception) -> None:
        """Write nothing any more, and remember why."""
        problems = error.problems if isinstance(error, BadInput) else ()
        if isinstance(error, OSError):
            problems = (Problem(str(error.filename or self.folder), str(error.strerror), ROOM),)
        self.trouble = str(problems[0]) if problems else str(error)

    def close(self) -> None:
        """Give the journal free for another session."""
        if self._lock is not None:
            self._lock.close()
        self._lock = None

    def _take(self) -> None:
        lock = (self.folder / LOCK).open("ab")
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            lock.close()
            raise WorkFailed(
                f"session {self.name} is open in another program; "
                "leave it there first, or begin a new one with `assistant teach`"
            ) from error
        self._lock = lock
