"""Puts text on disk so that a crash or a full disk never destroys what was there before."""

from __future__ import annotations

import contextlib
import os
import tempfile
from pathlib import Path

from assistant.errors import BadInput

MOST_LETTERS = 40
"""Of a name that others are made from: a letter takes up to four of the 255 bytes of a name."""


def write_text(path: Path, text: str) -> None:
    """Write a file at once: it holds the old text or the new one, never half of either.

    Raises
    ------
    BadInput
        If the folder is missing, read-only or full; the old file is then untouched.
    """
    write_bytes(path, text.encode("utf-8", errors="replace"))


def write_bytes(path: Path, data: bytes) -> None:
    """Write a file at once, as `write_text` does."""
    try:
        if path.exists() and not path.is_file():
            path.write_bytes(data)  # a pipe or a device; a folder is refused by the system
        else:
            _replace(path.resolve(), data)
    except OSError as error:
        raise cannot_write(path, error) from error


def cannot_write(path: Path, error: OSError) -> BadInput:
    """Return the complaint that a file cannot be written."""
    why = error.strerror or str(error)
    if isinstance(error, FileNotFoundError):
        return BadInput.one(str(path), "its folder does not exist", f"make {path.parent} first")
    right = "name a folder you may write in, with room left"
    return BadInput.one(str(path), f"cannot be written ({why})", right)


def _replace(path: Path, data: bytes) -> None:
    handle, beside = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name[:MOST_LETTERS]}.")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(beside, _mode(path))
        os.replace(beside, path)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(beside)
        raise


def _mode(path: Path) -> int:
    """Return the rights the file has, or would have been given if made anew."""
    with contextlib.suppress(OSError):
        return path.stat().st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask
