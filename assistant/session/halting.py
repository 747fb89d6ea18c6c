"""Why the arm was halted from outside the conversation, as keys of the phrasebook's ``whys``."""

from __future__ import annotations

KEY = "key"
"""Ctrl-C, or a button."""
NOBODY = "nobody"
"""The input ended, the window was closed."""
HEARTBEAT = "heartbeat"
"""The shell gives no sign of life: it could not pass a stop on."""
REARRANGED = "rearranged"
"""Things are put elsewhere."""
INTERRUPTED = "interrupted"
"""The program was killed while the arm moved."""
