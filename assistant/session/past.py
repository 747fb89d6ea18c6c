"""Sessions of the past: which there are, where they stand, which is the newest."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from assistant.errors import BadInput
from assistant.files.transcripts import read_transcript
from assistant.model.transcript import RobotLine, TeacherLine
from assistant.session.journal import NAME


@dataclass(frozen=True, slots=True)
class PastSession:
    """One session that was journaled.

    Parameters
    ----------
    name : str
    changed_s : float
        When its journal was last written, seconds since 1970.
    lines : int
        How many lines the teacher said.
    last : str
        The robot's last words.
    trouble : str
        Why its journal cannot be read; empty if it can.
    """

    name: str
    changed_s: float
    lines: int = 0
    last: str = ""
    trouble: str = ""


def past_sessions(folder: Path) -> tuple[PastSession, ...]:
    """Return all sessions, the newest last."""
    found = [_told(path) for path in folder.glob(f"*/{NAME}")]
    return tuple(sorted(found, key=lambda past: (past.changed_s, past.name)))


def newest_session(folder: Path) -> str:
    """Return the name of the session written last that can be read; of none, the last one's.

    Raises
    ------
    BadInput
        If there is none.
    """
    newest = _newest_first(folder)
    if not newest:
        raise BadInput.one("--resume", "there is no session yet", "begin one: assistant teach")
    readable = (path for path in newest if not _told(path).trouble)
    return next(readable, newest[0]).parent.name


def newer_sessions(folder: Path, name: str) -> tuple[str, ...]:
    """Return the names of the sessions written after one, the newest first."""
    names = [path.parent.name for path in _newest_first(folder)]
    return tuple(names[: names.index(name)]) if name in names else ()


def _newest_first(folder: Path) -> list[Path]:
    journals = folder.glob(f"*/{NAME}")
    return sorted(journals, key=lambda path: path.stat().st_mtime_ns, reverse=True)


def _told(path: Path) -> PastSession:
    name, changed_s = path.parent.name, path.stat().st_mtime
    try:
        steps = read_transcript(path, resume=True).steps
    except BadInput as error:
        return PastSession(name, changed_s, trouble=str(error.problems[0]))
    said = [step.words or "" for step in steps if isinstance(step, RobotLine)]
    lines = sum(isinstance(step, TeacherLine) for step in steps)
    return PastSession(name, changed_s, lines, said[-1] if said else "")
