"""The standard streams: none of them may fail on a letter, and all end quietly.

A shell may have closed a stream, its encoding may lack a letter, its reader may leave
(``| head``), its disk may be full: none of that is a fault of the program.
"""

from __future__ import annotations

import errno
import io
import os
import sys

_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EIO, errno.EFBIG)


def prepare() -> None:
    """Let a closed stream lead nowhere, and no stream fail on what it cannot spell.

    Bytes that are no text are read as words nobody understands; letters the output lacks are
    written as their numbers.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            flags = os.O_RDONLY if mode == "r" else os.O_WRONLY
            setattr(sys, name, os.fdopen(os.open(os.devnull, flags), mode, encoding="utf-8"))
    if isinstance(sys.stdin, io.TextIOWrapper):
        sys.stdin.reconfigure(errors="replace")
    # Where the locale has only plain letters, Python writes bytes it cannot spell as they came.
    unsafe = ("strict", "surrogateescape")
    if isinstance(sys.stdout, io.TextIOWrapper) and sys.stdout.errors in unsafe:
        sys.stdout.reconfigure(errors="backslashreplace")


def flush() -> None:
    """Write what is still held back, so that failing is told here and not at the very end."""
    sys.stdout.flush()


def silence() -> None:
    """Let what is still held back go nowhere: it cannot be written, and that is known."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        os.dup2(nowhere, stream.fileno())
    os.close(nowhere)


def unwritable(error: OSError) -> str:
    """Return the complaint that the output cannot be written, if that is what went wrong."""
    if error.filename is not None or error.errno not in _FULL:
        return ""
    return f"the output cannot be written ({error.strerror}); make room where it goes"
