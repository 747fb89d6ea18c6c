"""Where what has been learned and journaled is kept."""

from __future__ import annotations

import os
from pathlib import Path

from platformdirs import user_data_path


def home() -> Path:
    """Return the folder ``ASSISTANT_HOME``, or the user's data folder; it may not exist yet."""
    told = os.environ.get("ASSISTANT_HOME")
    return Path(told).expanduser() if told else user_data_path("teaching-assistant", False)
