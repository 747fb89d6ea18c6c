"""Reading whole sound files: what one clip means."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import Stop, Unknown
from assistant.shells.voice.deciding import SURE, is_unknown
from assistant.shells.voice.endpointing import frames_in, silero, utterances_in, utterances_of
from assistant.shells.voice.hearing import Hearing
from assistant.shells.voice.phonemes import distance, phonemes
from assistant.shells.voice.recognized import Recognizer
from assistant.shells.voice.recognizers import installed
from assistant.shells.voice.sound import (
    PIECE_S,
    RATE_HZ,
    Sound,
    length_s,
    read_sound,
    sound_pieces,
)

if TYPE_CHECKING:
    from assistant.shells.voice.spotter import StopSpotter

ONE_SENTENCE_S = 12.0
EDGE_S = 0.25
MOST_UTTERANCES = 40
LIKE_STOP = 0.5
LANGUAGES = {"en": "english", "de": "german"}


class ClipReader:
    """Understands clips; models are loaded once.

    Parameters
    ----------
    language : {"en", "de"}
    model_folder : Path, optional
        A Whisper model the teacher names.
    recognizers : sequence of Recognizer, optional
        Used in place of those installed, the quickest first.
    """

    def __init__(
        self,
        language: str = "en",
        model_folder: Path | None = None,
        recognizers: Sequence[Recognizer] | None = None,
    ) -> None:
        found = recognizers if recognizers is not None else installed(model_folder)
        self._hearing = Hearing(found, LANGUAGES[language])
        self._spotter: StopSpotter | None = None

    def read_file(self, path: Path, listening: Listening) -> Understanding:
        """Return what a sound file means; a long one is heard piece by piece.

        Raises
        ------
        BadInput
            If it is no sound.
        """
        if length_s(path) <= PIECE_S:
            return self.read(read_sound(path), listening)
        told: list[Understanding] = []
        for one in utterances_of(frames_in(sound_pieces(path)), silero()):
            meant = self._understand(one.sound, listening)
            told.append(meant)
            if len(told) == MOST_UTTERANCES:
                # Noise for an hour is no sentence, and nobody waits for it.
                break
        return _joined(told) if told else Understanding((Unknown(),), 1.0, "")

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
            whole = sound.cut(max(0.0, first - EDGE_S), last + EDGE_S)
            return self._understand(whole, listening)
        return _joined([self._understand(one.sound, listening) for one in spoken])

    def _understand(self, sound: Sound, listening: Listening) -> Understanding:
        heard = self._hearing.hear(sound.samples, listening)
        if heard.understanding.confidence < SURE or is_unknown(heard.understanding):
            like_stop = distance(phonemes(heard.text), phonemes("stop")) <= LIKE_STOP
            if (like_stop or not heard.text) and self._spots(sound):
                return Understanding((Stop(),), SURE, "stop")
        return replace(heard.understanding, heard=heard.text)

    def _spots(self, sound: Sound) -> bool:
        """Whether the spotter, where installed, hears stop in a clip."""
        if self._spotter is None:
            if find_spec("livekit") is None:
                return False
            from assistant.shells.voice.spotter import StopSpotter

            self._spotter = StopSpotter()
        self._spotter.reset()
        quiet = np.zeros(RATE_HZ // 2, dtype=np.float32)
        return self._spotter.hear(np.concatenate([sound.samples, quiet]))


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
