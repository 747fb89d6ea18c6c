"""Train the stop spotter's classifier on synthesized voices and noise.

Run ``python -m assistant.shells.voice.train_spotter`` where espeak-ng and flite are installed
(and, for one more voice, Piper). Voices for the held-out figures are never trained on.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assistant.shells.voice.mouth import Mouth, Voice
from assistant.shells.voice.sound import RATE_HZ, Samples, read_sound
from assistant.shells.voice.spotter import HOP, WEIGHTS, Embedder, Features, stacked

STOPS = ("stop", "stop it", "stop now", "please stop", "no stop", "stop stop")
OTHERS = (
    "step", "first step", "next step", "start", "top", "shop", "stock", "star", "stuff", "spot",
    "move more left", "a bit more right", "slower", "faster", "open the hand", "close the hand",
    "yes", "no", "then", "and then", "pick up the block", "place it on the target", "stack them",
    "go back to the demonstration", "what did you say", "turn clockwise ten degrees", "up", "down",
    "it's called pick and place", "there are two subtasks", "the red block and a target", "good",
    "again", "pause", "go on", "help", "undo that", "two centimetres up", "that is right", "steep",
    "the weather is nice today", "did you see the game last night", "I need to buy some apples",
    "a story about a stone", "he studies at the station", "studio", "strap", "swap them", "drop it",
)  # fmt: skip
_TRAINED_VARIANTS = (
    "", "f1", "f2", "f4", "m1", "m3", "m5", "m7", "Andrea", "Andy", "Annie", "Denis", "Gene", "Lee",
    "Linda", "Michael", "Mike", "Paul", "Pedro", "Rob", "Steph", "adam", "benjamin", "edward",
    "grandpa", "klatt2", "victor",
)  # fmt: skip
_HELD_OUT_VARIANTS = ("f3", "f5", "m2", "m4", "m6", "David", "Alicia", "belinda", "Max", "anika")
_ACCENTS = ("en-us", "en-gb", "en-gb-scotland", "en-gb-x-rp", "en-029")


@dataclass(frozen=True, slots=True, eq=False)
class Examples:
    """Stacked embeddings and what each is an example of (1 for stop)."""

    features: Features
    labels: NDArray[np.float32]


def voices(held_out: bool, piper: Sequence[str] = ()) -> tuple[Voice, ...]:
    """Return synthesized speakers to train on, or those kept for the figures.

    Parameters
    ----------
    held_out : bool
    piper : sequence of str
        Piper model files to train on as well.
    """
    variants = _HELD_OUT_VARIANTS if held_out else _TRAINED_VARIANTS
    told = [
        Voice("espeak-ng", f"{_ACCENTS[at % len(_ACCENTS)]}+{variant}".rstrip("+"), rate)
        for at, variant in enumerate(variants)
        for rate in ((160,) if held_out else (130, 180))
    ]
    flite = ("rms",) if held_out else ("slt", "awb", "kal")
    told += [Voice("flite", name, rate) for name in flite for rate in (135, 165, 195)]
    told += [Voice("piper", model) for model in piper]
    return tuple(told)


def spoken(voice: Voice, sentences: Sequence[str], folder: Path) -> Iterator[Samples]:
    """Yield each sentence as this voice speaks it, silence at both ends cut off."""
    mouth = Mouth(voice)
    for sentence in sentences:
        mouth.write(sentence, folder / "spoken.wav")
        samples = read_sound(folder / "spoken.wav").samples
        loud = np.flatnonzero(np.abs(samples) > 0.02 * np.max(np.abs(samples)))
        yield samples[loud[0] : loud[-1] + 1]


def examples(
    speakers: Sequence[Voice], embed: Embedder, rng: np.random.Generator, copies: int
) -> Examples:
    """Return embeddings around the ends of sentences, in rooms of several noises."""
    features: list[Features] = []
    labels: list[NDArray[np.float32]] = []
    with tempfile.TemporaryDirectory() as folder:
        for voice in speakers:
            for at, samples in enumerate(spoken(voice, (*STOPS, *OTHERS), Path(folder))):
                for _ in range(copies * (4 if at < len(STOPS) else 1)):
                    rows, marks = _one(samples, at < len(STOPS), embed, rng)
                    features.append(rows)
                    labels.append(marks)
            sys.stderr.write(f"{voice.engine} {voice.name}: {len(features)} clips\n")
    return Examples(np.concatenate(features), np.concatenate(labels))


def _one(
    samples: Samples, is_stop: bool, embed: Embedder, rng: np.random.Generator
) -> tuple[Features, NDArray[np.float32]]:
    before = int(rng.uniform(1.0, 1.5) * RATE_HZ)
    after = int(0.5 * RATE_HZ)
    placed = np.concatenate([np.zeros(before), samples, np.zeros(after)])
    placed *= rng.uniform(0.05, 0.9) / np.max(np.abs(placed))
    noisy = placed + _noise(len(placed), rng) * np.std(samples) * 10 ** rng.uniform(-2.5, -0.4)
    rows = stacked(embed(noisy.astype(np.float32)))
    # The last row ends with the sound; each one before ends 80 ms earlier.
    ends = (len(placed) - HOP * np.arange(len(rows))[::-1]) / RATE_HZ
    late = ends - (before + len(samples)) / RATE_HZ
    if is_stop:
        sure = (late > 0.0) & (late < 0.32)
        unsure = (late > -0.35) & (late < 0.5) & ~sure
        return rows[~unsure], sure[~unsure].astype(np.float32)
    return rows, np.zeros(len(rows), dtype=np.float32)


def _noise(count: int, rng: np.random.Generator) -> NDArray[np.float64]:
    white = rng.standard_normal(count)
    if rng.random() < 0.5:
        spectrum = np.fft.rfft(white)
        spectrum /= np.sqrt(np.arange(1, len(spectrum) + 1))
        white = np.fft.irfft(spectrum, count)
    return np.asarray(white / np.std(white))


def train(told: Examples, rng: np.random.Generator, steps: int = 4000) -> dict[str, Any]:
    """Return weights of one hidden layer fitted by Adam on balanced batches."""
    mean, scale = told.features.mean(axis=0), told.features.std(axis=0) + 1e-6
    rows = (told.features - mean) / scale
    sides = [np.flatnonzero(told.labels == label) for label in (0.0, 1.0)]
    size = rows.shape[1]
    weights = [rng.standard_normal((size, 32)) / np.sqrt(size), np.zeros(32),
               rng.standard_normal(32) / np.sqrt(32), np.zeros(())]  # fmt: skip
    first = [np.zeros_like(w) for w in weights]
    second = [np.zeros_like(w) for w in weights]
    for step in range(1, steps + 1):
        picked = np.concatenate([rng.choice(sides[0], 192), rng.choice(sides[1], 64)])
        noisy = rows[picked] + 0.1 * rng.standard_normal((256, size))
        slopes = _slopes(weights, noisy, told.labels[picked])
        for at, slope in enumerate(slopes):
            first[at] = 0.9 * first[at] + 0.1 * slope
            second[at] = 0.999 * second[at] + 0.001 * slope**2
            rate = 1e-3 * np.sqrt(1 - 0.999**step) / (1 - 0.9**step)
            weights[at] = weights[at] - rate * first[at] / (np.sqrt(second[at]) + 1e-8)
    named = zip(("w1", "b1", "w2", "b2"), weights, strict=True)
    return {"mean": mean, "scale": scale, **{k: w.astype(np.float32) for k, w in named}}


def _slopes(
    weights: Sequence[NDArray[np.float64]], rows: NDArray[np.float64], labels: NDArray[np.float32]
) -> list[NDArray[np.float64]]:
    w1, b1, w2, b2 = weights
    hidden = np.maximum(rows @ w1 + b1, 0.0)
    error = (1.0 / (1.0 + np.exp(-(hidden @ w2 + b2))) - labels) / len(labels)
    back = np.outer(error, w2) * (hidden > 0)
    decay = 1e-4
    return [
        rows.T @ back + decay * w1,
        back.sum(axis=0),
        hidden.T @ error + decay * w2,
        error.sum(),
    ]


def report(told: Examples, weights: dict[str, Any]) -> str:
    """Return misses and false alarms, by row, at several thresholds."""
    hidden = np.maximum((told.features - weights["mean"]) / weights["scale"] @ weights["w1"]
                        + weights["b1"], 0.0)  # fmt: skip
    scores = 1.0 / (1.0 + np.exp(-(hidden @ weights["w2"] + weights["b2"])))
    stop = told.labels > 0.5
    rows = [
        f"at {at:.2f}: {np.mean(scores[stop] < at):.3f} missed, "
        f"{np.mean(scores[~stop] >= at):.5f} false"
        for at in (0.5, 0.8, 0.9, 0.95, 0.98, 0.99)
    ]
    return "\n".join(rows)


def main() -> int:
    """Train, tell how voices kept apart are heard, write the weights."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=WEIGHTS)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threshold", type=float, default=0.95)
    parser.add_argument("--piper", nargs="*", default=(), metavar="MODEL")
    args = parser.parse_args()
    rng = np.random.default_rng(args.seed)
    embed = Embedder()
    told = examples(voices(held_out=False, piper=args.piper), embed, rng, copies=1)
    weights = train(told, rng)
    kept_apart = examples(voices(held_out=True), embed, rng, copies=1)
    sys.stderr.write(report(kept_apart, weights) + "\n")
    np.savez(args.out, threshold=np.float32(args.threshold), **weights)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
