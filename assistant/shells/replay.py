"""Replays a transcript in a folder of its own and tells how it went."""

from __future__ import annotations

import tempfile
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from assistant.errors import AssistantError
from assistant.model.transcript import Transcript
from assistant.session.equipment import EquipmentMaker
from assistant.session.player import Listener, Played, Player, silent, write_actual


@dataclass(frozen=True, slots=True)
class Replayed:
    """How the replay of one file went.

    Parameters
    ----------
    line : int or None
        Where transcript and play differ.
    wall_s : float
    """

    file: str
    passed: bool
    line: int | None
    why: str
    wall_s: float

    def as_json(self) -> dict[str, Any]:
        """Return what programs read."""
        return asdict(self)

    def told(self) -> str:
        """Return one line for people."""
        if self.passed:
            return f"{self.file}: passed ({self.wall_s:.1f} s)"
        return f"{self.file}:{self.line or 1}: {self.why}"


def _kept(played: Played) -> str:
    try:
        return f"see {write_actual(played)}"
    except AssistantError as error:
        # What differs is worth more than where it is written down.
        return f"what really happened is not kept: {error}"


def replay(
    transcript: Transcript, equipment: EquipmentMaker, listener: Listener = silent
) -> Replayed:
    """Play a transcript; where it differs, write what really happened beside it."""
    began_s = time.monotonic()
    line, why = None, ""
    with tempfile.TemporaryDirectory(prefix="assistant-") as folder:
        try:
            played = Player(transcript, equipment, Path(folder), listener).play()
        except AssistantError as error:
            why = str(error)
        else:
            if played.difference is not None:
                line, why = played.difference.line, played.difference.why
                why += f" ({_kept(played)})"
    wall_s = round(time.monotonic() - began_s, 3)
    return Replayed(transcript.source, not why, line, why, wall_s)
