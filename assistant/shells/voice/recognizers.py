"""Which recognizers can be used here: quickest first, best named at start.

Each comes inside an installed package or a folder the teacher names; what is not installed is
not offered.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from assistant.errors import BadInput
from assistant.shells.voice.memory import give_back, keep_small
from assistant.shells.voice.moonshine import Moonshine, packaged_moonshine
from assistant.shells.voice.recognized import Recognizer
from assistant.shells.voice.whisper import Whisper, packaged_whisper


def installed(model_folder: Path | None = None) -> tuple[Recognizer, ...]:
    """Return the recognizers that can be used here, the quickest first.

    Parameters
    ----------
    model_folder : Path, optional
        A Whisper model the teacher names; it is used in place of a packaged one.

    Raises
    ------
    BadInput
        If none can be used.
    """
    keep_small()
    found: list[Recognizer] = []
    # The larger one first: while a model loads it takes more than it keeps.
    if find_spec("faster_whisper") and (folder := model_folder or packaged_whisper()):
        found.append(Whisper(folder))
        give_back()
    if folder := packaged_moonshine():
        found.insert(0, Moonshine(folder))
    if not found:
        right = "pip install 'teaching-assistant[voice]'"
        raise BadInput.one("voice", "no speech recognizer is installed", right)
    give_back()
    return tuple(found)
