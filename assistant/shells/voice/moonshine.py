"""Moonshine tiny from the files inside the package moonshine-voice, run by onnxruntime.

The package's own library hears the same words, but keeps twice the memory and takes twice the
time; and its voice activity detection drops short words such as "stop".
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assistant.shells.voice.recognized import Recognized, plain_words
from assistant.shells.voice.sound import RATE_HZ, Samples

TOKENS_PER_S = 6.5
"""Nobody speaks faster; noise makes such a model go on for ever."""
BEGIN, END = 1, 2
HEADS, WIDTH = 8, 36
SPACE = "\u2581"
Arrays = dict[str, NDArray[Any]]


def packaged_moonshine() -> Path | None:
    """Return the folder of Moonshine tiny's files in the package moonshine-voice, if installed."""
    spec = find_spec("moonshine_voice")
    if spec is None or spec.origin is None or find_spec("onnxruntime") is None:
        return None
    folder = Path(spec.origin).parent / "assets" / "tiny-en"
    return folder if (folder / "encoder_model.ort").is_file() else None


class Moonshine:
    """Reads an utterance word piece by word piece, always the likeliest: quick, no hot words.

    Parameters
    ----------
    folder : Path
        With encoder_model.ort, decoder_model_merged.ort and tokenizer.bin.
    """

    name = "moonshine tiny"

    def __init__(self, folder: Path) -> None:
        self._pieces = read_pieces((folder / "tokenizer.bin").read_bytes())
        self._encoder = _session(folder / "encoder_model.ort")
        self._decoder = _session(folder / "decoder_model_merged.ort")
        names = [one.name for one in self._decoder.get_inputs()]
        self._past = [name for name in names if name.startswith("past_key_values")]
        self._told = [one.name for one in self._decoder.get_outputs()]

    def recognize(
        self, samples: Samples, hot_words: Sequence[str] = (), *, loud: bool = False
    ) -> tuple[Recognized, ...]:
        """Return the words heard; hot words are not known to this model."""
        sound = np.asarray(samples, dtype=np.float32)[None]
        mask = np.ones(sound.shape, dtype=np.int64)
        encoded = self._encoder.run(None, {"input_values": sound, "attention_mask": mask})[0]
        given = {"encoder_attention_mask": mask, "encoder_hidden_states": encoded}
        most = int(sound.shape[1] / RATE_HZ * TOKENS_PER_S) + 2
        words = plain_words(self._written(self._read(given, most)))
        return (Recognized(words),) if words else ()

    def _read(self, given: Arrays, most: int) -> list[int]:
        """Return the numbers of the pieces heard, so many at most."""
        past = {name: np.zeros((1, HEADS, 0, WIDTH), dtype=np.float32) for name in self._past}
        read: list[int] = []
        while len(read) < most:
            last = np.array([[read[-1] if read else BEGIN]])
            begun = np.array([bool(read)])
            told = self._decoder.run(
                None, {**given, **past, "input_ids": last, "use_cache_branch": begun}
            )
            piece = int(np.argmax(told[0][0, -1]))
            if piece == END:
                break
            past = self._kept(past, dict(zip(self._told, told, strict=True)), first=not read)
            read.append(piece)
        return read

    def _kept(self, past: Arrays, told: Arrays, *, first: bool) -> Arrays:
        """Return what the decoder remembers: of the sound from the first piece, of all pieces."""
        return {
            name: told[name.replace("past_key_values", "present")]
            if first or ".decoder." in name
            else kept
            for name, kept in past.items()
        }

    def _written(self, read: Sequence[int]) -> str:
        told = b"".join(self._pieces[piece] for piece in read)
        return told.decode("utf-8", "replace").replace(SPACE, " ")


def read_pieces(told: bytes) -> list[bytes]:
    """Return the word pieces of a tokenizer file: each behind its length, in one byte or two."""
    pieces: list[bytes] = []
    at = 0
    while at < len(told):
        length = told[at]
        at += 1
        if length >= 128:
            length += 128 * told[at] - 128
            at += 1
        pieces.append(told[at : at + length])
        at += length
    return pieces


def _session(path: Path) -> Any:
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    options.log_severity_level = 3
    # Its buffers are small; an arena would keep far more.
    options.enable_cpu_mem_arena = False
    return onnxruntime.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])
