"""Reading whole sound files: what one clip means."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

import numpy as np

from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import Stop, Unknown
from assistant.shells.voice.endpointing import silero, utterances_in
from assistant.shells.voice.hearing import Hearing
from assistant.shells.voice.recognizers import installed
from assistant.shells.voice.sound import RATE_HZ, Sound

ONE_SENTENCE_S = 12.0
LANGUAGES = {"en": "english", "de": "german"}


class ClipReader:
    """Understands clips; models are loaded once.

    Parameters
    ----------
    language : {"en", "de"}
    model_folder : Path, optional
        A Whisper model the teacher names.
    """

    def __init__(self, language: str = "en", model_folder: Path | None = None) -> None:
        self._hearing = Hearing(installed(model_folder), LANGUAGES[language])

    def read(self, sound: Sound, listening: Listening) -> Understanding:
        """Return what a clip means; a clip without speech means nothing.

        Pauses within a sentence do not divide a short clip; a long one is understood utterance
        by utterance.
        """
        spoken = tuple(utterances_in(_leveled(sound), silero()))
        if not spoken:
            return Understanding((Unknown(),), 1.0, "")
        first, last = spoken[0].speech_from_s, spoken[-1].speech_to_s
        if last - first <= ONE_SENTENCE_S:
            whole = sound.cut(max(0.0, first - 0.25), last + 0.25)
            return self._understand(whole, listening)
        return _joined([self._understand(one.sound, listening) for one in spoken])

    def _understand(self, sound: Sound, listening: Listening) -> Understanding:
        heard = self._hearing.hear(sound.samples, listening)
        if len(heard.text.split()) <= 2 and spotted_stop(sound):
            return Understanding((Stop(),), max(heard.understanding.confidence, 0.9), "stop")
        return heard.understanding


def spotted_stop(sound: Sound) -> bool:
    """Whether the spotter, where installed, hears stop in a clip."""
    if find_spec("livekit") is None:
        return False
    from assistant.shells.voice.spotter import StopSpotter

    quiet = np.zeros(RATE_HZ // 2, dtype=np.float32)
    return StopSpotter().hear(np.concatenate([sound.samples, quiet]))


def _leveled(sound: Sound) -> Sound:
    # Faint recordings are brought up for voice activity only; silence stays silence.
    peak = float(np.max(np.abs(sound.samples), initial=0.0))
    if not 1e-3 < peak < 0.3:
        return sound
    return Sound(np.asarray(sound.samples * (0.5 / peak), dtype=np.float32), sound.from_s)


def _joined(told: list[Understanding]) -> Understanding:
    acts = tuple(act for one in told for act in one.acts if not isinstance(act, Unknown))
    sure = min(one.confidence for one in told)
    return Understanding(acts or (Unknown(),), sure, ". ".join(one.heard for one in told))
