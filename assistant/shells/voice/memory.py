"""Memory that is done with goes back at once, where the C library can be told so (glibc).

Models hold large buffers for a moment while they load and weigh; kept for later they would make
half of what listening takes. Elsewhere both functions do nothing.
"""

from __future__ import annotations

import ctypes
from functools import cache

LARGE = 65536
"""Bytes from which a buffer stands alone and is given back as soon as it is free."""
_MMAP_THRESHOLD = -3
"""The number glibc knows the setting by (mallopt, M_MMAP_THRESHOLD)."""


@cache
def _glibc() -> ctypes.CDLL | None:
    try:
        library = ctypes.CDLL("libc.so.6")
    except OSError:
        return None
    return library if hasattr(library, "malloc_trim") else None


def keep_small() -> bool:
    """Have large buffers given back as soon as they are free; return whether that is so."""
    library = _glibc()
    return library is not None and bool(library.mallopt(_MMAP_THRESHOLD, LARGE))


def give_back() -> None:
    """Give back what is free but kept."""
    library = _glibc()
    if library is not None:
        library.malloc_trim(0)
