"""Where what has been learned and journaled is kept."""

from __future__ import annotations

import os
from pathlib import Path

from platformdirs import user_data_path

from assistant.errors import BadInput

VARIABLE = "ASSISTANT_HOME"


def home() -> Path:
    """Return the folder ``ASSISTANT_HOME``, or the user's data folder; it may not exist yet.

    Raises
    ------
    BadInput
        If ``ASSISTANT_HOME`` is in the home folder of somebody unknown, or if neither it nor
        the home folder of the user is known.
    """
    told = os.environ.get(VARIABLE, "")
    try:
        found = Path(told).expanduser() if told else user_data_path("teaching-assistant", False)
    except RuntimeError as error:
        raise _unknown(told) from error
    if not told and found.parts[:1] == ("~",):
        raise _unknown(told)
    return found


def home_to_look_into() -> Path:
    """Return `home`, or raise `BadInput` if what is there is no folder.

    For listing what is kept: a file holds nothing, but saying so would mislead.
    """
    found = home()
    if os.path.exists(found) and not os.path.isdir(found):
        raise BadInput.one(VARIABLE, f"{found} is no folder", "name a folder")
    return found


def _unknown(told: str) -> BadInput:
    if not told:
        return BadInput.one(VARIABLE, "is not set, and you have no home folder", "set it")
    return BadInput.one(VARIABLE, f"there is no such home folder: {told}", "name a folder in full")
