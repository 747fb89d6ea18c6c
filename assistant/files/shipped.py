"""Where the files that come with the program lie: in the wheel, or in the checkout."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import assistant
from assistant.errors import BadInput


def shipped(kind: Literal["tasks", "transcripts"]) -> Path:
    """Return the folder of shipped tasks (with ``scenes`` and ``setups``) or transcripts."""
    package = Path(assistant.__file__).resolve().parent
    for folder in (package / "shipped" / kind, package.parent / kind):
        if folder.is_dir():
            return folder
    right = "install the program anew"
    raise BadInput.one(str(package), f"the shipped {kind} are missing", right)
