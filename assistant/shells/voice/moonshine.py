"""Moonshine tiny from the files inside the package moonshine-voice, run by onnxruntime.

The package's own library hears the same words, but keeps twice the memory and takes twice the
time; and its voice activity detection drops short words such as "stop".
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from math import exp
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assistant.shells.voice.recognized import Recognized, merged, plain_words
from assistant.shells.voice.sound import RATE_HZ, Samples

TOKENS_PER_S = 6.5
"""Nobody speaks faster; noise makes such a model go on for ever."""
BEGIN, END = 1, 2
HEADS, WIDTH = 8, 36
BEAM = 4
"""So many readings are followed at once where more than the likeliest is asked for."""
SPACE = "\u2581"
Arrays = dict[str, NDArray[Any]]


@dataclass(frozen=True, slots=True)
class Begun:
    """A reading that has begun: its pieces, and the natural logarithm of how likely it is."""

    pieces: tuple[int, ...] = ()
    likely: float = 0.0


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
        words = plain_words(self._written(self._read(self._heard(samples), _most(samples))))
        return (Recognized(words),) if words else ()

    def reread(self, samples: Samples) -> tuple[Recognized, ...]:
        """Return the likeliest readings, each with how likely it is."""
        ended = self._followed(self._heard(samples), _most(samples))
        return merged((plain_words(self._written(one.pieces)), exp(one.likely)) for one in ended)

    def _heard(self, samples: Samples) -> Arrays:
        """Return the model's view of an utterance."""
        sound = np.asarray(samples, dtype=np.float32)[None]
        mask = np.ones(sound.shape, dtype=np.int64)
        encoded = self._encoder.run(None, {"input_values": sound, "attention_mask": mask})[0]
        return {"encoder_attention_mask": mask, "encoder_hidden_states": encoded}

    def _followed(self, given: Arrays, most: int) -> Iterator[Begun]:
        """Yield readings that came to an end, following the likeliest few piece by piece."""
        past = {name: np.zeros((1, HEADS, 0, WIDTH), dtype=np.float32) for name in self._past}
        open_now, ended = [Begun()], 0
        while open_now and ended < BEAM and len(open_now[0].pieces) < most:
            many, first = len(open_now), not open_now[0].pieces
            last = np.array([[one.pieces[-1] if one.pieces else BEGIN] for one in open_now])
            each = {name: np.repeat(one, many, axis=0) for name, one in given.items()}
            begun = {"input_ids": last, "use_cache_branch": np.array([not first])}
            told = dict(
                zip(self._told, self._decoder.run(None, {**each, **past, **begun}), strict=True)
            )
            past = self._kept(past, told, first=first)
            ways = _ways(open_now, told[self._told[0]][:, -1])
            goes_on = [(at, one) for at, one in ways if one.pieces[-1] != END][: BEAM - ended]
            for _, one in ways[:BEAM]:
                if one.pieces[-1] == END:
                    ended += 1
                    yield Begun(one.pieces[:-1], one.likely)
            open_now = [one for _, one in goes_on]
            past = {name: one[[at for at, _ in goes_on]] for name, one in past.items()}

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


def _most(samples: Samples) -> int:
    return int(len(samples) / RATE_HZ * TOKENS_PER_S) + 2


def _ways(open_now: Sequence[Begun], scores: NDArray[Any]) -> list[tuple[int, Begun]]:
    """Return how readings may go on, the likeliest first, each with the one it goes on from."""
    most = scores.max(axis=1, keepdims=True)
    likely = scores - most - np.log(np.exp(scores - most).sum(axis=1, keepdims=True))
    found = [
        (at, Begun((*one.pieces, int(piece)), one.likely + float(likely[at, piece])))
        for at, one in enumerate(open_now)
        for piece in np.argpartition(-likely[at], BEAM)[: BEAM + 1]
    ]
    return sorted(found, key=lambda way: -way[1].likely)


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
